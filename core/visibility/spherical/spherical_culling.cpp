#include "core/visibility/spherical/spherical_culling.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/spherical/mapped_culling.h"
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
    [[nodiscard]] Cause causeOf(SphereRelation relation) const override {
        return relation == SphereRelation::Within ? Cause::Hidden : Cause::OutsideFrustum;
    }
    [[nodiscard]] BandsLine lineOf(const SphericalDecision& decision) const override { return lineOfBands(decision); }

    void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, const ParameterSet& parameters,
                     SphericalDecision& decision, ObjectRecord* record) const override {
        if (view.relation == SphereRelation::Within) {
            decision.bands = bandsFor(view.eye, parameters);
            attachBands(*decision.bands, false, record);
            decision.drawn = drawnByS(*mesh.bandCells, *decision.bands, record);
            attachBands(*decision.bands, true, record);
            return;
        }
        for (uint32_t i = 0; i < decision.rays.size(); ++i)
            // The ray starts at the near plane: nothing before it is visible.
            decision.rays[i] =
                followCorner(*mesh.maps, {view.eye + view.cornerDirections[i], view.cornerDirections[i]}, i, record);
        const Join join = parameters.choice("joined") == "arcs" ? Join::Arcs : Join::Chart;
        decision.region = visibleRegion(*mesh.maps, decision.rays, join);
        decision.drawn = runsOf(mesh.maps->grid(), *decision.region);
        if (record == nullptr) return;
        uint64_t triangles = 0;
        for (const CellRun& run : decision.drawn) triangles += mesh.maps->run(run.first, run.last).second;
        sayRegion(*decision.region, triangles, *record);
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
    info.parameters.push_back(
        choiceParameter("joined", "chart", CULLSCOPE_TR("How the four hits are joined to the visible region."),
                        {{"chart", CULLSCOPE_TR("straight on the map, so that the extremes are the hits'")},
                         {"arcs", CULLSCOPE_TR("by great circles, whose extremes may lie between the hits")}}));
    info.sweeps = {{"rows", {"45", "90", "180", "360"}}, {"band", {"2.5", "5", "10", "20"}}};
    info.shows = withListing(showsOfBands(), bandsListing());
    return {info, std::make_shared<Spherical>(info.id)};
}

}  // namespace cullscope::spherical
