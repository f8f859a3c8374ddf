#pragma once

#include <array>

#include "core/geometry/frustum.h"

namespace cullscope {

/// A parallelepiped in coordinates relative to the eye (a box, however it was turned, stretched, mirrored or sheared), and room
/// around it.
struct OrientedBox {
    Vec3 centre{0.0};
    std::array<Vec3, 3> axes{};  ///< half edges; those of a flat box may be 0
    double room = 0.0;           ///< what is bounded lies within this distance of the box: the rounding of its own making

    /// No point of it lies farther from the eye.
    [[nodiscard]] double farthest() const;
};

/// A mesh's box (coordinates about `meshOrigin`) where an instance puts it, seen from the eye. `worldFromMesh` is affine. The
/// result's room covers the rounding of the transform, so it holds every point of the transformed box, also where origin, place
/// and eye are large and cancel. The result for an empty box is NaN, which no test calls outside.
[[nodiscard]] OrientedBox orientedBox(const Box3& meshBox, const Mat4& worldFromMesh, const Vec3& eye,
                                      const Vec3& meshOrigin = Vec3(0.0));

/// Half the box's extent along a unit normal: Σ|n·aᵢ| and its room.
[[nodiscard]] inline double reachAlong(const Vec3& normal, const OrientedBox& box) {
    double reach = box.room;
    for (const Vec3& axis : box.axes) reach += glm::abs(glm::dot(normal, axis));
    return reach;
}

/// Signed distance of the box's p-vertex, the corner farthest inside: below 0 the whole box is outside.
[[nodiscard]] inline double pVertexDistance(const Plane& plane, const OrientedBox& box) {
    return plane.distance(box.centre) + reachAlong(plane.normal, box);
}

/// Signed distance of the box's n-vertex, the corner farthest outside: above 0 the whole box is inside.
[[nodiscard]] inline double nVertexDistance(const Plane& plane, const OrientedBox& box) {
    return plane.distance(box.centre) - reachAlong(plane.normal, box);
}

/// How a box lies to the frustum by its six planes; as for an EyeBox (geometry/frustum.h), a box that reaches into the frustum is
/// never `Outside`.
[[nodiscard]] Containment classify(const Frustum& frustum, const OrientedBox& box, double margin);
[[nodiscard]] Containment classify(const Frustum& frustum, const OrientedBox& box);

}  // namespace cullscope
