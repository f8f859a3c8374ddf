#pragma once

#include <array>

#include "core/geometry/angle.h"
#include "core/geometry/bounds.h"
#include "core/geometry/plane.h"

namespace cullscope {

enum class Containment { Outside, Straddles, Inside };

/// The order of a frustum's planes; also the number under which a trace names the plane that culled.
enum class FrustumPlane { Left, Right, Bottom, Top, Near, Far };

/// A view frustum in coordinates relative to the eye (world axes, origin at the eye), so that nothing is lost far from
/// the world's origin: the four side planes pass through 0.
struct Frustum {
    std::array<Plane, 6> planes;  ///< unit normals pointing inward, in the order of FrustumPlane
    Vec3 forward{0.0, 0.0, -1.0};
    Vec3 right{1.0, 0.0, 0.0};
    Vec3 up{0.0, 1.0, 0.0};
    double tanHalfWidth = 1.0;   ///< half the width of the view at distance 1
    double tanHalfHeight = 1.0;  ///< half the height of the view at distance 1
    double nearDistance = 0.1;
    double farDistance = 10.0;

    /// The corners relative to the eye: near bottom-left, bottom-right, top-right, top-left, then the same far.
    [[nodiscard]] std::array<Vec3, 8> corners() const;
};

/// Builds the planes from an orthonormal basis; exact to a few ulp for any near : far ratio, because no row of a
/// projection matrix is subtracted from another.
[[nodiscard]] Frustum makeFrustum(const Vec3& forward, const Vec3& right, const Vec3& up, double tanHalfWidth,
                                  double tanHalfHeight, double nearDistance, double farDistance);

/// A box in coordinates relative to the eye.
struct EyeBox {
    Vec3 centre{0.0};
    Vec3 halfExtent{0.0};
};

/// Moves a world box to the eye; the half extents grow by the rounding of the subtraction, so that the result holds the box.
[[nodiscard]] EyeBox relativeToEye(const Box3& box, const Vec3& eye);

/// Signed distance of a box's p-vertex, the corner farthest inside: below 0 the whole box is outside. n·c + d + |n|·e.
[[nodiscard]] inline double pVertexDistance(const Plane& plane, const EyeBox& box) {
    return plane.distance(box.centre) + glm::dot(glm::abs(plane.normal), box.halfExtent);
}

/// How far a plane test leans outward so that it never culls what a picture shows, for a bound whose farthest point lies
/// `magnitude` from the eye. Two errors stand behind it: the test's own rounding in double (below 2^-49 of the magnitude), and
/// the picture's: OpenGL gets float matrices and positions, so a vertex is misplaced by up to 8 roundings of 2^-24 = 2^-21 of its
/// distance. (Of a mesh that lies away from the zero of its coordinates by more: Scene::pictureRounding, in its bounds.) A side
/// plane has half a pixel of room besides (samples lie at pixel centres); near and far planes have none. What it costs: objects
/// within a millionth of their distance outside a plane are kept.
[[nodiscard]] constexpr double conservativeMargin(double magnitude) { return magnitude * 0x1p-20; }

/// How a box lies to one plane. Conservative both ways: `Outside` and `Inside` are said only where they hold with `margin` to
/// spare.
[[nodiscard]] inline Containment classify(const Plane& plane, const EyeBox& box, double margin) {
    const double centre = plane.distance(box.centre);
    const double reach = glm::dot(glm::abs(plane.normal), box.halfExtent);
    if (centre + reach < -margin) return Containment::Outside;
    return centre - reach > margin ? Containment::Inside : Containment::Straddles;
}

/// How a box lies to the frustum by its six planes. A box that reaches into the frustum is never `Outside`; one that lies outside
/// near an edge or corner may be called `Straddles` (a known false positive of plane tests; stability cases 1 and 2).
[[nodiscard]] Containment classify(const Frustum& frustum, const EyeBox& box);

/// The same for a sphere with its centre relative to the eye.
[[nodiscard]] Containment classify(const Frustum& frustum, const Sphere& eyeSphere);

}  // namespace cullscope
