#pragma once

#include <array>

#include "core/geometry/frustum.h"

namespace cullscope {

/// A parallelepiped in coordinates relative to the eye (a box that was turned, stretched, mirrored or sheared), with a bound on
/// its rounding.
struct OrientedBox {
    Vec3 centre{0.0};
    std::array<Vec3, 3> axes{};  ///< half edges; those of a flat box may be 0
    double room = 0.0;           ///< the bounded points lie at most this far outside the box: the rounding of its construction

    /// An upper bound on the distance from the eye of any point of the box.
    [[nodiscard]] double farthest() const;
};

/// A mesh's box (coordinates about `meshOrigin`) placed by an instance, relative to the eye. `worldFromMesh` is affine. `room` of
/// the result covers the rounding of the transform, so it contains every point of the transformed box, also where origin,
/// translation and eye are large and cancel. An empty box gives NaN, which no test classifies as outside.
[[nodiscard]] OrientedBox orientedBox(const Box3& meshBox, const Mat4& worldFromMesh, const Vec3& eye,
                                      const Vec3& meshOrigin = Vec3(0.0));

/// Half the box's extent along a unit normal: Σ|n·aᵢ| plus its `room`.
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

/// Classifies a box against the frustum by its six planes; as with an EyeBox (geometry/frustum.h), a box that intersects the
/// frustum is never `Outside`.
[[nodiscard]] Containment classify(const Frustum& frustum, const OrientedBox& box, double margin);
[[nodiscard]] Containment classify(const Frustum& frustum, const OrientedBox& box);

}  // namespace cullscope
