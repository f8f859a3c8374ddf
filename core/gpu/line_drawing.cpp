#include <glm/gtc/type_ptr.hpp>

#include "core/gpu/drawing.h"

namespace cullscope {
namespace {

/// Uniform locations that line.vert declares.
enum LineUniform : GLint { kClipFromEyeRelative = 0, kHalfViewport = 1, kHalfWidth = 2, kLeastDistance = 3 };

constexpr GLsizei kVerticesALine = 6;

}  // namespace

void drawLinesOnGpu(const Program& program, unsigned lineArray, const View& view, std::span<const LineOnGpu> lines, float width) {
    if (lines.empty()) return;
    unsigned buffer = 0;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(lines.size_bytes()), lines.data(), 0);
    glVertexArrayVertexBuffer(lineArray, 0, buffer, 0, sizeof(LineOnGpu));
    glBindVertexArray(lineArray);
    glUseProgram(program.id());
    const Mat4f clip(view.clipFromEyeRelative());
    glUniformMatrix4fv(kClipFromEyeRelative, 1, GL_FALSE, glm::value_ptr(clip));
    glUniform2f(kHalfViewport, 0.5f * float(view.viewport().width), 0.5f * float(view.viewport().height));
    glUniform1f(kHalfWidth, 0.5f * width);
    // Lines are clipped close to the eye, not at the near plane: a frustum's edges often start in front of the near plane.
    // In a parallel view nothing lies behind an eye, and w, which is compared, is 1.
    glUniform1f(kLeastDistance, view.frustum().parallel() ? 0.0f : float(view.camera().nearDistance * 0x1p-6));
    // Behind the far plane and in front of the near plane, depths are clamped to the ends of their range.
    glEnable(GL_DEPTH_CLAMP);
    glFrontFace(GL_CCW);  // the winding of the rectangles, for either direction of a line
    glDepthMask(GL_FALSE);
    glDrawArraysInstanced(GL_TRIANGLES, 0, kVerticesALine, static_cast<GLsizei>(lines.size()));
    glDisable(GL_DEPTH_CLAMP);
    glDepthMask(GL_TRUE);
    glVertexArrayVertexBuffer(lineArray, 0, 0, 0, sizeof(LineOnGpu));
    glDeleteBuffers(1, &buffer);
}

void Renderer::drawLines(const View& view, std::span<const LineSegment> lines, const LineStyle& style, Framebuffer& target) {
    std::vector<LineOnGpu> onGpu;
    onGpu.reserve(lines.size());
    for (const LineSegment& line : lines)
        onGpu.push_back({Vec3f(line.from - view.eye()), Vec3f(line.to - view.eye()), line.colour});
    const DrawingState state(view, target, Facing::TwoSided);
    glDepthFunc(style.depthTest ? GL_GEQUAL : GL_ALWAYS);
    drawLinesOnGpu(m_programs->line, m_programs->lineArray, view, onGpu, style.width);
}

}  // namespace cullscope
