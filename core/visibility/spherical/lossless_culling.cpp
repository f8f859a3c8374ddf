#include "core/visibility/spherical/lossless_culling.h"
#include "core/visibility/single_triangles.h"

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/spherical/cell_scene.h"
#include "core/visibility/spherical/listings.h"
#include "core/visibility/spherical/lossless_frame.h"
#include "core/visibility/spherical/map_shows.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/triangles_by_test.h"

namespace cullscope::spherical {
namespace {

// With fewer triangles, setting up the horizon costs more than it saves.
constexpr size_t kLeastTrianglesForHorizon = 2000;
// An object of fewer triangles is drawn faster than its cells are tested.
constexpr size_t kLeastTrianglesForCells = 1000;

class SphericalLossless final : public StrategyWithMaps<CellScene> {
    using StrategyWithMaps::StrategyWithMaps;

public:
    [[nodiscard]] std::vector<MeshStates> meshStates(const Structure& structure, const ParameterSet& parameters) const override {
        return {kernelStates(own(structure), parameters.boolean("horizon"))};
    }
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& structure, const FrameLog& log) const override {
        return trianglesByTest(log, structure.scene(), CULLSCOPE_TR("horizon of the kernel"));
    }

protected:
    void fill(CellScene& structure, const ParameterSet& parameters, const Progress& progress) const override {
        const CellTree::Options options{mapLayoutFromId(parameters.choice("layout")), uint32_t(parameters.integer("level")),
                                        kLeastTrianglesForCells};
        buildCells(structure, options, kLeastTrianglesForHorizon, parameters.boolean("triangles"), progress);
    }

    void decide(FrameContext& frame, const CellScene& structure, ViewState& /*state*/,
                const ParameterSet& parameters) const override {
        drawLossless(frame, structure, parameters);
    }

    [[nodiscard]] Promise promiseOf(const CellScene& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }

    [[nodiscard]] StructureSnapshot snapshotOf(const CellScene& structure, const FrameLog& log) const override {
        const std::vector<std::optional<FrustumPlane>> rejectedBy = rejectingPlanes(log, structure.scene().instances().size());
        StructureSnapshot result;
        std::vector<MapSnapshot> maps;
        for (const SphericalDecision& decision : decisionsOf(log)) {
            maps.push_back(mapOfDecision(structure, log, decision));
            result.nodes.push_back(nodeOf(structure.scene(), decision));
            result.nodes.back().rejectedBy = rejectedBy[decision.instance];
        }
        setMaps(result, std::move(maps));
        addGroups(result, structure.octree, structure.scene(), log);
        return result;
    }

    [[nodiscard]] MapSnapshot mapOfDecision(const CellScene& structure, const FrameLog& log,
                                            const SphericalDecision& decision) const override {
        const MeshCells& mesh = structure.meshOf(decision.instance);
        return {mesh.maps, decision, mesh.tree, asksKernels(log) ? mesh.kernel : nullptr};
    }

private:
    [[nodiscard]] static SnapshotNode nodeOf(const Scene& scene, const SphericalDecision& decision) {
        SnapshotNode node;
        node.instance = decision.instance;
        node.box = scene.instanceBox(decision.instance);
        node.triangles = scene.meshOf(decision.instance).triangleCount();
        node.culled = decision.drawnTriangles == 0;
        node.cause = decision.walk ? mainCause(decision.walk->culled) : Cause::OutsideFrustum;
        node.containment = containmentOf(decision.relation);
        return node;
    }
};

}  // namespace

RegisteredStrategy sphericalLossless() {
    StrategyInfo info{
        "spherical-lossless",
        CULLSCOPE_TR("Spherical coordinates, lossless"),
        CULLSCOPE_TR("Tests the cells of a map of directions, from large to small, against the frustum, by normal cones and by "
                     "the horizon of the solid's inner kernel: loses nothing on any mesh."),
        "Han & Hong 2008 made conservative; Shirman & Abi-Ezzi 1993",
        {facingParameter(),
         readWhenBuilding(choiceParameter(
             "layout", "octahedral", CULLSCOPE_TR("How directions are laid out on the map."),
             {{"octahedral", CULLSCOPE_TR("an octahedron unfolded: no poles, no trigonometry")},
              {"latitude-longitude", CULLSCOPE_TR("rows of zenith angle and columns of azimuth, as in the paper")}})),
         {"level",
          ParameterType::Integer,
          int64_t{0},
          0.0,
          double(kFinestLevel),
          "",
          CULLSCOPE_TR(
              "How often the map is quartered: 2^level cells a side; 0: down to some four dozen triangles a cell. An object of "
              "fewer than a thousand is one cell."),
          {},
          ParameterUse::Building},
         booleanParameter("cones", true,
                          CULLSCOPE_TR("Whether cells whose triangles all face away are left out (where only front sides "
                                       "are drawn).")),
         booleanParameter("horizon", true,
                          CULLSCOPE_TR("Whether cells behind the solid's inner kernel are left out (where the mesh is "
                                       "closed).")),
         readWhenBuilding(booleanParameter(
             "triangles", true,
             CULLSCOPE_TR("Whether triangles that hold no pixel centre or face away are left out of the drawn cells "
                          "one by one (where the picture has few pixels for each).")))}};
    info.needsEyePoint = true;
    info.sweeps = {{"level", {"4", "5", "6", "7", "8", "0"}, "0"}};
    info.shows = withListing(showsOfCells(), walkListing());
    info.shows.push_back(trianglesByTestShow());
    return {info, std::make_shared<SphericalLossless>(info.id)};
}

}  // namespace cullscope::spherical
