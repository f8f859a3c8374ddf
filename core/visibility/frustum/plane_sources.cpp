#include "core/visibility/frustum/plane_sources.h"

#include <cmath>

namespace cullscope::frustum {
namespace {

/// Whether planes are so near to others that the margin of a plane test covers the difference.
bool areNearTo(const FrustumPlanes& planes, const FrustumPlanes& others) {
    constexpr double kMost = 0x1p-24;
    for (size_t i = 0; i < planes.size(); ++i)
        if (!(glm::length(planes[i].normal - others[i].normal) <= kMost) ||
            !(std::abs(planes[i].offset - others[i].offset) <= kMost * std::abs(others[i].offset)))
            return false;
    return true;
}

/// The blog's GetNormalFromPoints. Its world is left-handed: mirrored into a right-handed one, a cross product changes its sign.
Plane throughPoints(const Vec3& p1, const Vec3& p2, const Vec3& p3) {
    const Vec3 normal = -glm::cross(p1 - p2, p1 - p3);
    return {normal, -glm::dot(normal, p1)};
}

}  // namespace

SourcedFrustum frustumFrom(const View& view, PlaneSource source) {
    SourcedFrustum result{view.frustum()};
    if (source != PlaneSource::Rows && source != PlaneSource::Corners) return result;
    const Mat4& clip = view.clipFromEyeRelative();
    auto planes = source == PlaneSource::Rows ? planesFromRows(clip, ClipDepth::ReversedZeroToOne)
                                              : planesFromCorners(clip, ClipDepth::ReversedZeroToOne);
    if (planes && view.frustum().parallel())
        for (const FrustumPlane plane : {FrustumPlane::Near, FrustumPlane::Far})
            (*planes)[size_t(plane)].offset += depthRoom(view.frustum().farDistance);
    result.kept = planes && areNearTo(*planes, view.frustum().planes);
    if (result.kept) result.frustum.planes = *planes;
    return result;
}

FrustumPlanes publishedPlanes(const View& view) {
    const Frustum& frustum = view.frustum();
    // The inverse projection takes (x, y, depth, 1) to (x tan, y tan, 1, 1/near or 1/far); the inverse view turns the first three
    // and adds the eye as often as the fourth says.
    const auto corner = [&](double x, double y, double distance) {
        return view.eye() / distance + x * frustum.tanHalfWidth * frustum.right + y * frustum.tanHalfHeight * frustum.up +
               frustum.forward;
    };
    const double near = frustum.nearDistance, far = frustum.farDistance;
    const Plane nearPlane = throughPoints(corner(-1, 1, near), corner(1, 1, near), corner(1, -1, near));
    FrustumPlanes planes;
    planes.fill(nearPlane);
    planes[size_t(FrustumPlane::Far)] = throughPoints(corner(-1, 1, far), corner(-1, -1, far), corner(1, 1, far));
    return planes;
}

}  // namespace cullscope::frustum
