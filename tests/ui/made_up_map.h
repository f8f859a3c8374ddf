#pragma once

#include <functional>
#include <numbers>

#include "core/scene/scene_source.h"
#include "core/visibility/spherical/index_map.h"
#include "ui/plots/shown_map.h"

namespace cullscope::ui {

/// A decision for a sphere within the frustum: contour bands of 10° in eight sectors, of which those up to 110° are drawn.
inline spherical::SphericalDecision withinDecision(const Vec3& eye) {
    spherical::SphericalDecision decision;
    decision.relation = spherical::SphereRelation::Within;
    decision.eye = eye;
    spherical::ContourBands bands;
    bands.width = std::numbers::pi / 18;
    bands.bands = 18;
    bands.sectors = 8;
    for (uint32_t band = 0; band < bands.bands; ++band)
        for (uint32_t sector = 0; sector < bands.sectors; ++sector) {
            const double size = std::sin((band + 0.5) * bands.width) * (1.0 + 0.05 * sector);
            const double horizon = band == 0 ? 0.0 : bands.at(band - 1, sector).horizon;
            const double before = band == 0 ? 0.0 : bands.at(band - 1, sector).size;
            bands.table.push_back({size, std::max(horizon, before), band < 11});
        }
    decision.bands = bands;
    return decision;
}

/// A map of a scene's first object with the decision withinDecision().
struct MadeUpMap {
    MadeUpMap() = default;
    MadeUpMap(ScenePointer ofScene, const SphericalGrid& grid)
        : scene(std::move(ofScene)),
          maps(std::make_shared<SphericalMaps>(scene->meshes()[scene->instances()[0].mesh], grid)),
          decision(withinDecision({0, 0, 5})) {}

    /// As strategies show it.
    [[nodiscard]] ShownMap shown() const {
        return {scene, spherical::indexMap({maps, decision}, scene->instances()[0].name, scene->instances().size())};
    }

    ScenePointer scene;
    SphericalMapsPointer maps;
    spherical::SphericalDecision decision;
};

/// A decision for a sphere that the frustum cuts: the visible region between two corners (θ, φ), all four of which miss the
/// object.
inline spherical::SphericalDecision cutDecision(const Vec2& from, const Vec2& to, int caseNumber) {
    spherical::SphericalDecision decision;
    decision.relation = spherical::SphereRelation::Cut;
    spherical::VisibleRegion region;
    region.caseNumber = caseNumber;
    region.outline = {{to.x, from.y}, {to.x, to.y}, {from.x, to.y}, {from.x, from.y}};
    for (size_t i = 0; i < 4; ++i) {
        const double theta = region.outline[i].x, phi = region.outline[i].y;
        decision.rays[i].point = {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
    }
    decision.region = region;
    return decision;
}

}  // namespace cullscope::ui
