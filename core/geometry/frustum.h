#pragma once

#include <array>

#include "core/geometry/angle.h"
#include "core/geometry/bounds.h"
#include "core/geometry/plane.h"

namespace cullscope {

enum class Containment { Outside, Straddles, Inside };

/// The order of a frustum's planes; a trace names the plane that culled by this number.
enum class FrustumPlane { Left, Right, Bottom, Top, Near, Far };
inline constexpr size_t kFrustumPlaneCount = 6;

/// A view frustum in coordinates relative to the eye (world axes, origin at the eye): no precision is lost far from the world's
/// origin. In perspective the four side planes pass through 0. In a parallel view the volume is a box: its sides lie as far apart
/// at each distance, and the eye is the middle of its front.
struct Frustum {
    std::array<Plane, 6> planes;  ///< unit normals pointing inward, in the order of FrustumPlane
    Vec3 forward{0.0, 0.0, -1.0};
    Vec3 right{1.0, 0.0, 0.0};
    Vec3 up{0.0, 1.0, 0.0};
    double tanHalfWidth = 1.0;   ///< by how much half the width of the view grows with each unit of distance; 0: parallel
    double tanHalfHeight = 1.0;  ///< the same of half its height
    double halfWidth = 0.0;      ///< half the width of the view at the eye; 0 in perspective
    double halfHeight = 0.0;     ///< half its height there
    double nearDistance = 0.1;
    double farDistance = 10.0;

    [[nodiscard]] bool parallel() const { return halfHeight > 0.0; }
    /// What a picture shows lies between these distances, those of the near and far planes: in a parallel view depthRoom more.
    [[nodiscard]] double leastDistance() const;
    [[nodiscard]] double mostDistance() const;
    /// Half the width and half the height of the view at a distance ahead of the eye.
    [[nodiscard]] double halfWidthAt(double ahead) const { return halfWidth + tanHalfWidth * ahead; }
    [[nodiscard]] double halfHeightAt(double ahead) const { return halfHeight + tanHalfHeight * ahead; }

    /// The corners relative to the eye: near bottom-left, bottom-right, top-right, top-left, then the far ones in the same order.
    [[nodiscard]] std::array<Vec3, 8> corners() const;
};

/// Builds the planes from an orthonormal basis. Exact to a few ulp for any near : far ratio, because no rows of a projection
/// matrix are subtracted from each other.
[[nodiscard]] Frustum makeFrustum(const Vec3& forward, const Vec3& right, const Vec3& up, double tanHalfWidth,
                                  double tanHalfHeight, double nearDistance, double farDistance);

/// The same for a parallel view. The near and far planes lie farther out by depthRoom: OpenGL's depth is not relative to the
/// distance here, so that what it draws may lie before the near plane by a rounding of the far distance.
[[nodiscard]] Frustum makeParallelFrustum(const Vec3& forward, const Vec3& right, const Vec3& up, double halfWidth,
                                          double halfHeight, double nearDistance, double farDistance);

/// By how much the near and far planes of a parallel view lie beyond its distances.
[[nodiscard]] constexpr double depthRoom(double farDistance) { return farDistance * 0x1p-20; }

inline double Frustum::leastDistance() const { return parallel() ? nearDistance - depthRoom(farDistance) : nearDistance; }
inline double Frustum::mostDistance() const { return parallel() ? farDistance + depthRoom(farDistance) : farDistance; }

/// A box in coordinates relative to the eye.
struct EyeBox {
    Vec3 centre{0.0};
    Vec3 halfExtent{0.0};
};

/// A world box relative to the eye. The half extents grow by the rounding of the subtraction, so that the result contains the
/// box.
[[nodiscard]] EyeBox relativeToEye(const Box3& box, const Vec3& eye);

/// Signed distance of a box's p-vertex, the corner farthest inside: below 0 the whole box is outside. n·c + d + |n|·e.
[[nodiscard]] inline double pVertexDistance(const Plane& plane, const EyeBox& box) {
    return plane.distance(box.centre) + glm::dot(glm::abs(plane.normal), box.halfExtent);
}

/// The margin of a plane test, in world units, for a bound whose farthest point lies `magnitude` from the eye: a bound is culled
/// only when it lies outside by more than this, so that nothing visible in the picture is culled. It covers two errors: the
/// test's own rounding in double (below 2^-49 of the magnitude), and that of the picture: OpenGL gets float matrices and
/// positions, so a vertex is displaced by up to 8 roundings of 2^-24 = 2^-21 of its distance. (A mesh far from the origin of its
/// own coordinates has larger errors: Scene::pictureRounding adds them to its bounds.) Side planes have half a pixel of tolerance
/// besides (samples lie at pixel centres); near and far planes have none. The cost: objects that lie outside a plane by less than
/// a millionth of their distance are drawn.
[[nodiscard]] constexpr double conservativeMargin(double magnitude) { return magnitude * 0x1p-20; }

/// Classifies a box against one plane. Conservative in both directions: `Outside` and `Inside` are returned only where the box
/// lies outside or inside by more than `margin`.
[[nodiscard]] inline Containment classify(const Plane& plane, const EyeBox& box, double margin) {
    const double centre = plane.distance(box.centre);
    const double reach = glm::dot(glm::abs(plane.normal), box.halfExtent);
    if (centre + reach < -margin) return Containment::Outside;
    return centre - reach > margin ? Containment::Inside : Containment::Straddles;
}

/// Classifies a box against the frustum by its six planes. A box that intersects the frustum is never `Outside`; one outside near
/// an edge or corner may be `Straddles` (a known false positive of plane tests; stability cases 1 and 2).
[[nodiscard]] Containment classify(const Frustum& frustum, const EyeBox& box);

/// The same for a sphere with its centre relative to the eye.
[[nodiscard]] Containment classify(const Frustum& frustum, const Sphere& eyeSphere);

}  // namespace cullscope
