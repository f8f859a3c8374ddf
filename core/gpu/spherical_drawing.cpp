#include <glm/gtc/type_ptr.hpp>

#include "core/gpu/drawing.h"

namespace cullscope {
namespace {

/// Uniform locations that the shaders spherical_model.* declare.
enum SphericalUniform : GLint { kCentre = 0, kLargestRadius = 1, kMap = 2, kRamp = 3 };

}  // namespace

MapArea mapArea(const Viewport& size, double margin) {
    const double around = std::min(margin, 0.1 * std::min(size.width, size.height));
    MapArea area;
    area.width = std::max(2.0, std::round(std::min(size.width - 2.0 * around, 2.0 * (size.height - 2.0 * around))));
    area.height = std::max(1.0, std::round(0.5 * area.width));
    area.left = std::round(0.5 * (size.width - area.width));
    area.bottom = std::round(0.5 * (size.height - area.height));
    return area;
}

void Renderer::drawSpherical(const SceneBuffers& buffers, const View& view, const DrawList& list, const SphericalModel& model,
                             Framebuffer& target, const DrawStyle& style) {
    const MapArea& area = model.area;
    const DrawingState state(view, target, Facing::TwoSided);
    clearTo(style);
    // The viewport of the map, of which a tile shows a part.
    glViewport(int(area.left) - target.tile().x, int(area.bottom) - target.tile().y, int(area.width), int(area.height));
    glUseProgram(m_programs->sphericalModel.id());
    glUniform3fv(kCentre, 1, glm::value_ptr(Vec3f(model.sphere.centre)));
    glUniform1f(kLargestRadius, float(model.sphere.radius));
    glUniform4f(kMap, float(area.left - target.tile().x), float(area.bottom - target.tile().y), float(area.width),
                float(area.height));
    glUniform3fv(kRamp, static_cast<GLsizei>(model.ramp.size()), glm::value_ptr(model.ramp.front()));
    VertexInput input(buffers, m_programs->vertexArray, list.order, Facing::TwoSided);
    input.bindMesh(buffers.scene().instances()[model.instance].mesh, VertexInput::Indices::InOrder);
    for (const DrawRange& range : list.ranges)
        if (range.instance == model.instance)
            glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(range.indexCount), input.indexType(),
                           input.indexAddress(range.firstIndex));
    // The depths are of the map, not of the camera's picture, so they are cleared.
    glClear(GL_DEPTH_BUFFER_BIT);
}

}  // namespace cullscope
