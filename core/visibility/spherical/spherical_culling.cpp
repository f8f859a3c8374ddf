#include "core/visibility/spherical/spherical_culling.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/spherical/flow_chart.h"
#include "core/visibility/spherical/map_coordinates.h"
#include "core/visibility/spherical/mapped_culling.h"
#include "core/visibility/spherical/readings.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/spherical/recorded_tests.h"
#include "core/visibility/spherical/visible_region.h"

namespace cullscope::spherical {
namespace {

class Spherical final : public MappedCulling {
    using MappedCulling::MappedCulling;

protected:
    [[nodiscard]] Promise promiseOf(const MappedScene& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }
    [[nodiscard]] Cause causeOf(const SphericalDecision& decision) const override {
        return decision.bands ? Cause::Hidden : Cause::OutsideFrustum;
    }
    [[nodiscard]] BandsLine lineOf(const SphericalDecision& decision) const override { return lineOfBands(decision); }

    void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, const ParameterSet& parameters,
                     SphericalDecision& decision, ObjectRecord* record) const override {
        const Readings readings = readingsOf(parameters);
        if (view.relation == SphereRelation::Within) {
            decideByBands(mesh, view, parameters, readings, decision, record);
            return;
        }
        std::vector<CornerRay> corners;
        for (uint32_t i = 0; i < decision.rays.size(); ++i) {
            // The ray starts at the near plane: nothing before it is visible.
            const Ray ray{view.eye + view.cornerDirections[i], view.cornerDirections[i]};
            decision.rays[i] = followCorner(*mesh.maps, ray, i, readings.start, record);
            if (decision.rays[i].hit || readings.missed == Missed::Nearest) corners.push_back(decision.rays[i]);
        }
        const auto hits = std::ranges::count_if(decision.rays, [](const CornerRay& ray) { return ray.hit.has_value(); });
        if ((hits == 0 && readings.branch == Branch::Text) || (hits < 4 && readings.missed == Missed::Bands)) {
            if (record != nullptr) sayBranch(size_t(hits), *record);
            decideByBands(mesh, view, parameters, readings, decision, record);
            return;
        }
        if (corners.empty()) return;
        const std::optional<Pole> pole =
            readings.pole == PoleRule::Direction ? std::optional(poleInView(*mesh.maps, view)) : std::nullopt;
        decision.region = visibleRegion(*mesh.maps, corners, readings.join, pole);
        decision.drawn = runsOf(mesh.maps->grid(), *decision.region);
        if (record == nullptr) return;
        uint64_t triangles = 0;
        for (const CellRun& run : decision.drawn) triangles += mesh.maps->run(run.first, run.last).second;
        sayRegion(*decision.region, triangles, *record);
    }

private:
    static void decideByBands(const MappedMesh& mesh, const ObjectSpaceView& view, const ParameterSet& parameters,
                              const Readings& readings, SphericalDecision& decision, ObjectRecord* record) {
        decision.bands = bandsFor(view.eye, parameters);
        attachBands(*decision.bands, false, record);
        decision.drawn = drawnByS(*mesh.bandCells, *decision.bands, readings.cut, record);
        attachBands(*decision.bands, true, record);
    }
};

}  // namespace

RegisteredStrategy spherical() {
    StrategyInfo info{"spherical",
                      CULLSCOPE_TR("Spherical coordinates"),
                      CULLSCOPE_TR("Looks up on a map of directions what four corner rays enclose; seen whole, compares contour "
                                   "bands by S. As published, with its losses."),
                      "Han & Hong 2008",
                      {facingParameter("two-sided"), rowsParameter()}};
    std::ranges::move(bandParameters(5.0, 36), std::back_inserter(info.parameters));
    std::ranges::move(readingParameters(), std::back_inserter(info.parameters));
    std::ranges::move(coordinateParameters(), std::back_inserter(info.parameters));
    info.parameters.push_back(storageParameter());
    info.needsEyePoint = true;
    info.sweeps = {{"rows", {"45", "90", "180", "360"}}, {"band", {"2.5", "5", "10", "20"}}};
    Show listing = bandsListing();
    listing.chart = flowChart();
    info.shows = withListing(showsOfBands(false), std::move(listing));
    return {info, std::make_shared<Spherical>(info.id)};
}

}  // namespace cullscope::spherical
