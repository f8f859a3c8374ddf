#include "core/visibility/spherical/spherical_horizon.h"

#include <algorithm>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/spherical/mapped_culling.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/spherical/slope_horizon.h"

namespace cullscope::spherical {
namespace {

class SphericalHorizon final : public MappedCulling {
    using MappedCulling::MappedCulling;

    static constexpr size_t kFewTriangles = 500;

protected:
    [[nodiscard]] Promise promiseOf(const MappedScene& structure, const ParameterSet& /*parameters*/,
                                    Facing facing) const override {
        return structure.starShaped[size_t(facing)] ? Promise::Conservative : Promise::Approximate;
    }

    void fill(MappedScene& structure, const ParameterSet& parameters, const Progress& progress) const override {
        structure.starShaped.fill(true);
        MappedCulling::fill(structure, parameters, progress);
    }
    void buildFor(MappedScene& structure, MappedMesh& mesh) const override {
        mesh.horizonCells = std::make_unique<HorizonCells>(*mesh.maps, *mesh.bandCells);
        // Above the limit the star-shape test is not run, because the user did not request it; the weaker promise is made
        // instead.
        const bool asked = mesh.maps->mesh().triangleCount() <= kOptionalAnalysisLimit;
        bool &both = structure.starShaped[size_t(Facing::TwoSided)], &front = structure.starShaped[size_t(Facing::Front)];
        both = asked && both && isStarShaped(*mesh.maps, Facing::TwoSided);
        front = both && front && isStarShaped(*mesh.maps, Facing::Front);
        // A star-shaped mesh whose front does not suffice is turned inward, and has both sides drawn.
        structure.starShaped[size_t(Facing::ByObject)] = both;
    }
    [[nodiscard]] Cause causeOf(const SphericalDecision& /*decision*/) const override { return Cause::Hidden; }
    [[nodiscard]] BandsLine lineOf(const SphericalDecision& decision) const override { return lineOfHorizon(decision); }
    void decideAbout(const MappedMesh& mesh, const ObjectSpaceView& view, const ParameterSet& parameters,
                     SphericalDecision& decision, ObjectRecord* record) const override {
        // A surface that the near plane cuts hides nothing, and an object of few triangles is drawn faster than it is tested.
        if (!view.beyondNear || mesh.maps->mesh().triangleCount() < kFewTriangles) {
            decision.drawn = {{0, mesh.maps->grid().cellCount()}};
            return;
        }
        decision.bands = bandsFor(view.eye, parameters);
        decision.bands->slopes = true;
        attachBands(*decision.bands, false, record);
        decision.drawn = drawnBySlope(*mesh.maps, *mesh.bandCells, *mesh.horizonCells, view, *decision.bands, record);
        attachBands(*decision.bands, true, record);
    }
    /// Each cell that is drawn was said by itself.
    [[nodiscard]] bool saysRanges() const override { return false; }
    /// The sectors that are drawn in part at least are those that the cells touch that were decided to be drawn.
    [[nodiscard]] MapSnapshot mapOfDecision(const MappedScene& structure, const FrameLog& log,
                                            const SphericalDecision& decision) const override {
        MapSnapshot map = MappedCulling::mapOfDecision(structure, log, decision);
        if (map.decision.bands)
            markDrawnSectors(*structure.meshOf(decision.instance).maps, *structure.meshOf(decision.instance).bandCells,
                             map.decision.drawn, *map.decision.bands);
        return map;
    }
};

}  // namespace

RegisteredStrategy sphericalHorizon() {
    StrategyInfo info{"spherical-horizon",
                      CULLSCOPE_TR("Spherical coordinates, exact horizon"),
                      CULLSCOPE_TR("Leaves out cells whose slope lies below the horizon of the surface in front of them: loses "
                                   "nothing of star-shaped objects."),
                      "Han & Hong 2008, S replaced by the slope",
                      {facingParameter(), rowsParameter()}};
    std::ranges::move(bandParameters(3.0, 72), std::back_inserter(info.parameters));
    info.needsEyePoint = true;
    info.shows = withListing(showsOfBands(true), horizonListing());
    return {info, std::make_shared<SphericalHorizon>(info.id)};
}

}  // namespace cullscope::spherical
