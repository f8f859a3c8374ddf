#pragma once

#include <array>
#include <optional>

#include "core/gpu/renderer.h"

namespace cullscope {

/// The object that a picture in spherical coordinates shows: the first instance in a draw list. None for an empty list.
[[nodiscard]] std::optional<uint32_t> sphericalModelInstance(const DrawList& list);

/// Whether a draw list has every triangle of that object.
[[nodiscard]] bool hasWholeModel(const Scene& scene, const DrawList& list);

/// The colours of the model in spherical coordinates for equally spaced R. They get lighter with R, because shading is visible on
/// light colours only.
[[nodiscard]] std::array<Vec3f, 5> reliefColours();
/// The colour at an R that is this share of the bounding sphere's radius.
[[nodiscard]] Vec3f reliefColour(double share);

/// The rectangle of the model in a picture of that size, with a margin for the labels of its ticks.
[[nodiscard]] MapArea sphericalModelArea(const Viewport& size, const DrawStyle& style);

/// Clears `target` and draws the list's triangles of that object in spherical coordinates about the centre of its mesh's bounding
/// sphere, as large as `viewing`'s picture allows, in a frame with ticks every 30°, longer every 90° (Han & Hong 2008, Figure 2).
/// Writes no depth.
void drawSphericalModel(Renderer& renderer, const SceneBuffers& buffers, const View& viewing, const DrawList& list,
                        const DrawStyle& style, Framebuffer& target);

/// A triangle and the point on it at a pixel, in world coordinates.
struct DirectionPick {
    uint64_t triangle = 0;  ///< scene triangle number
    Vec3 point{0.0};
};
/// The triangle that this picture shows at a pixel (y upward): of those in its direction the farthest from the centre.
[[nodiscard]] std::optional<DirectionPick> pickSphericalModel(const Scene& scene, const DrawList& list, const Viewport& size,
                                                              const DrawStyle& style, int x, int y);

}  // namespace cullscope
