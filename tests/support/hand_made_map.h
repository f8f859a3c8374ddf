#pragma once

#include <numbers>

#include "core/mesh/parametric.h"
#include "core/visibility/spherical/map_details.h"

namespace cullscope::test {

inline constexpr double kDegree = std::numbers::pi / 180.0;

/// The direction of a zenith angle and an azimuth in degrees.
inline Vec3 directionOf(double theta, double phi) {
    return {std::sin(theta * kDegree) * std::cos(phi * kDegree), std::sin(theta * kDegree) * std::sin(phi * kDegree),
            std::cos(theta * kDegree)};
}

/// A map of 90 × 45 cells over a sphere of radius 1 about the origin, in the form a strategy returns it: outside the frustum.
inline spherical::MapSnapshot sphereMap() {
    spherical::MapSnapshot map;
    map.maps = std::make_shared<SphericalMaps>(sphereMesh(20000), SphericalGrid(90, 45));
    map.decision.relation = spherical::SphereRelation::Outside;
    return map;
}

/// The same inside the frustum, with twelve bands of 15° and six sectors, of which the second half is hidden; seen along `axis`.
inline spherical::MapSnapshot bandedMap(const Vec3& axis) {
    spherical::MapSnapshot map = sphereMap();
    map.decision.relation = spherical::SphereRelation::Within;
    map.decision.eye = 4.0 * axis;
    spherical::ContourBands bands;
    bands.axis = axis;
    bands.side = glm::normalize(glm::cross(axis, std::abs(axis.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
    bands.over = glm::cross(axis, bands.side);
    bands.bands = 12;
    bands.width = 15.0 * kDegree;
    bands.sectors = 6;
    for (uint32_t band = 0; band < bands.bands; ++band)
        for (uint32_t sector = 0; sector < bands.sectors; ++sector)
            bands.table.push_back({std::sin((band + 0.5) * bands.width), 0.0, band < 6});
    map.decision.bands = bands;
    return map;
}

/// The same cut by the frustum, with a region from azimuth `left` to `right` (across the seam where `right` is above 360°) and
/// from zenith angle 60° to 100°.
inline spherical::MapSnapshot cutMap(double left, double right) {
    spherical::MapSnapshot map = sphereMap();
    map.decision.relation = spherical::SphereRelation::Cut;
    map.decision.eye = 4.0 * directionOf(80.0, 0.5 * (left + right));
    spherical::VisibleRegion region;
    region.caseNumber = right > 360.0 ? 3 : 2;
    for (const auto& [theta, phi] :
         {std::pair(100.0, left), std::pair(100.0, right), std::pair(60.0, right), std::pair(60.0, left)})
        region.outline.emplace_back(theta * kDegree, phi * kDegree);
    const auto column = [](double degrees) { return uint32_t(degrees / 4.0); };
    if (right > 360.0)
        region.boxes = {{15, 24, column(left), 89}, {15, 24, 0, column(right - 360.0) - 1}};
    else
        region.boxes = {{15, 24, column(left), column(right) - 1}};
    for (size_t i = 0; i < 4; ++i) {
        spherical::CornerRay& ray = map.decision.rays[i];
        ray.followed = true;
        ray.point = directionOf(region.outline[i].x / kDegree, region.outline[i].y / kDegree);
        ray.ray = {map.decision.eye, ray.point - map.decision.eye};
        ray.span = throughSphere(ray.ray, map.maps->sphere().radius);
        if (i != 3) ray.hit = TriangleHit{0, 1.0};
    }
    map.decision.region = region;
    return map;
}

}  // namespace cullscope::test
