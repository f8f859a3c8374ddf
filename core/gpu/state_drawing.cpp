#include <cassert>
#include <glm/gtc/type_ptr.hpp>

#include "core/base/error.h"
#include "core/gpu/colour.h"
#include "core/gpu/submission.h"
#include "core/scene/eye_triangle.h"

namespace cullscope {
namespace {

using Look = PaletteEntry::Look;

/// Widths of the lines around marked triangles, in units: the outer line contrasts with the background, the inner one has the
/// mark's colour.
constexpr float kHaloWidth = 7.0f;
constexpr float kLossMarkWidth = 3.0f;
/// How many of 16 units along a row of a marked triangle are black and how many white; the others have the mark's colour. Chosen
/// so that the mean differs from every other verdict colour, in grey too (tests/core/measure/verdict_colour_test.cpp).
constexpr glm::vec2 kHatchOnLight(7.0f, 1.0f);
constexpr glm::vec2 kHatchOnDark(5.0f, 1.0f);

/// The states and the palette as shader storage buffers.
class StateBuffers {
public:
    StateBuffers(std::span<const uint8_t> states, std::span<const PaletteEntry> palette) {
        GLint64 most = 0;
        glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
        const size_t bytes = (states.size() / 4 + 1) * 4;
        if (static_cast<GLint64>(bytes) > most)
            throwOpenGl(CULLSCOPE_TR("Colours by verdict need %1 bytes in one buffer and this OpenGL gives %2: show the scene "
                                     "shaded, or a part of it."),
                        {std::to_string(bytes), std::to_string(most)});
        glCreateBuffers(2, m_buffers.data());
        glNamedBufferStorage(m_buffers[0], static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
        glNamedBufferSubData(m_buffers[0], 0, static_cast<GLsizeiptr>(states.size()), states.data());
        std::vector<glm::vec4> entries;
        for (const PaletteEntry& entry : palette) entries.emplace_back(entry.colour * entry.shade, float(entry.look));
        glNamedBufferStorage(m_buffers[1], static_cast<GLsizeiptr>(entries.size() * sizeof(glm::vec4)), entries.data(), 0);
        for (GLuint i = 0; i < 2; ++i) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, m_buffers[i]);
    }
    ~StateBuffers() {
        for (GLuint i = 0; i < 2; ++i) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, i, 0);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
        glDeleteBuffers(2, m_buffers.data());
    }
    StateBuffers(const StateBuffers&) = delete;
    StateBuffers& operator=(const StateBuffers&) = delete;

private:
    std::array<unsigned, 2> m_buffers{};
};

/// Draw lists of the instances that have a triangle of each look, so that a look is drawn only for the instances that need it.
std::array<DrawList, 3> listsByLook(const Scene& scene, Facing facing, std::span<const uint8_t> states,
                                    std::span<const PaletteEntry> palette) {
    std::array<DrawList, 3> lists;
    for (DrawList& list : lists) list.facing = facing;
    for (const DrawRange& range : everything(scene, facing).ranges) {
        std::array<bool, 4> has{};
        for (const uint8_t state : states.subspan(scene.firstTriangle(range.instance), range.indexCount / 3))
            has[size_t(palette[state].look)] = true;
        for (size_t look = 0; look < lists.size(); ++look)
            if (has[look]) lists[look].ranges.push_back(range);
    }
    return lists;
}

/// The edges of the marked triangles, in their colour.
std::vector<LineOnGpu> markedEdges(const Scene& scene, const Vec3& eye, const DrawList& marked, std::span<const uint8_t> states,
                                   std::span<const PaletteEntry> palette) {
    std::vector<LineOnGpu> edges;
    for (const DrawRange& range : marked.ranges) {
        const InstanceFromEye instance(scene, range.instance, eye);
        const auto own = states.subspan(scene.firstTriangle(range.instance), range.indexCount / 3);
        for (size_t triangle = 0; triangle < own.size(); ++triangle) {
            if (palette[own[triangle]].look != Look::Marked) continue;
            const auto corners = instance.corners(triangle);
            for (size_t i = 0; i < 3; ++i)
                edges.push_back({Vec3f(corners[i]), Vec3f(corners[(i + 1) % 3]), palette[own[triangle]].colour});
        }
    }
    return edges;
}

/// The width nearest to the wanted one that this OpenGL can draw wireframe edges with.
float wireWidth(float wanted) {
    GLint flags = 0;
    glGetIntegerv(GL_CONTEXT_FLAGS, &flags);
    if (wanted <= 1.0f || (flags & GL_CONTEXT_FLAG_FORWARD_COMPATIBLE_BIT) != 0) return 1.0f;
    std::array<GLfloat, 2> range{1.0f, 1.0f};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, range.data());
    return std::min(wanted, range[1]);
}

std::vector<LineOnGpu> recoloured(std::vector<LineOnGpu> lines, const Vec3f& colour) {
    for (LineOnGpu& line : lines) line.colour = colour;
    return lines;
}

}  // namespace

void Renderer::drawByState(const SceneBuffers& buffers, const View& view, Facing facing, std::span<const uint8_t> stateOfTriangle,
                           std::span<const PaletteEntry> palette, Framebuffer& target, const DrawStyle& style) {
    const Scene& scene = buffers.scene();
    assert(stateOfTriangle.size() == scene.triangleCount());
    const std::array<DrawList, 3> lists = listsByLook(scene, facing, stateOfTriangle, palette);
    const Vec3f contrast = contrastTo(style.background);
    const glm::vec2 hatch = isLight(style.background) ? kHatchOnLight : kHatchOnDark;
    const DrawingState state(view, target, facing);
    const StateBuffers onGpu(stateOfTriangle, palette);
    const auto drawLook = [&](Look look) {
        glUseProgram(m_programs->of(view).state.id());
        glUniform1ui(kWantedLook, static_cast<GLuint>(look));
        glUniform2fv(kHatch, 1, glm::value_ptr(hatch));
        glUniform3f(kHatchPlace, float(target.tile().x), float(target.tile().y), style.unit);
        submitNumbered(buffers, view, lists[size_t(look)], m_programs->input());
    };
    clearTo(style);
    drawLook(Look::Filled);
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glLineWidth(wireWidth(style.unit));
    drawLook(Look::Wireframe);
    glLineWidth(1.0f);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    // Edges are drawn before the marked triangles: inside a triangle only the hatch remains visible, around it the halo.
    const std::vector<LineOnGpu> edges = markedEdges(scene, view.eye(), lists[size_t(Look::Marked)], stateOfTriangle, palette);
    drawLinesOnGpu(m_programs->line, m_programs->lineArray, view, recoloured(edges, contrast), kHaloWidth * style.unit);
    drawLinesOnGpu(m_programs->line, m_programs->lineArray, view, edges, kLossMarkWidth * style.unit);
    drawLook(Look::Marked);
}

}  // namespace cullscope
