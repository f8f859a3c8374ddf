#pragma once

#include <optional>

#include "core/gpu/renderer.h"

namespace cullscope {

/// The object that a picture in spherical coordinates shows: the first one of which a draw list has anything. None: of nothing.
[[nodiscard]] std::optional<uint32_t> sphericalModelInstance(const DrawList& list);

/// Whether a list has every triangle of that object.
[[nodiscard]] bool hasWholeModel(const Scene& scene, const DrawList& list);

/// Where the model lies in a picture of that size; around it there is a margin for what stands at its ticks.
[[nodiscard]] MapArea sphericalModelArea(const Viewport& size, const DrawStyle& style);

/// Clears `target` and draws what a list has of that object in spherical coordinates about its mesh's bounding sphere, as large
/// as `viewing`'s picture allows, in a frame with ticks every 30°, longer every 90° (Han & Hong 2008, Figure 2). Leaves no depth.
void drawSphericalModel(Renderer& renderer, const SceneBuffers& buffers, const View& viewing, const DrawList& list,
                        const DrawStyle& style, Framebuffer& target);

/// A triangle with the point of it in world coordinates.
struct DirectionPick {
    uint64_t triangle = 0;  ///< scene triangle number
    Vec3 point{0.0};
};
/// What that picture shows at a pixel (y upward): of the triangles in its direction the farthest out.
[[nodiscard]] std::optional<DirectionPick> pickSphericalModel(const Scene& scene, const DrawList& list, const Viewport& size,
                                                              const DrawStyle& style, int x, int y);

}  // namespace cullscope
