#include "core/visibility/spherical/lossless_culling.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/spherical/cell_scene.h"
#include "core/visibility/spherical/cell_walk.h"
#include "core/visibility/spherical/listings.h"
#include "core/visibility/spherical/map_shows.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/spherical/recorded_tests.h"
#include "core/visibility/triangles_by_test.h"

namespace cullscope::spherical {
namespace {

// With fewer triangles, setting up the horizon costs more than it saves.
constexpr size_t kLeastTrianglesForHorizon = 2000;
// An object of fewer triangles is drawn faster than its cells are tested.
constexpr size_t kLeastTrianglesForCells = 1000;
// From this number of objects, a second thread saves time.
constexpr size_t kObjectsForThreads = 8;

constexpr OctreeWalkLines kWalkLines{.groupPlanes = uint8_t(WalkLine::Groups),
                                     .groupOutside = uint8_t(WalkLine::GroupOutside),
                                     .groupInside = uint8_t(WalkLine::Groups),
                                     .objectTests = uint8_t(WalkLine::Groups),
                                     .objectOutside = uint8_t(WalkLine::GroupOutside)};

/// The cause for which most of the culled triangles were culled.
Cause mainCause(const CellWalk& walk) {
    return static_cast<Cause>(std::max_element(walk.culled.begin(), walk.culled.end()) - walk.culled.begin());
}

/// The decision about an object that no group test culled.
struct WalkedObject {
    uint32_t instance = 0;
    SphereRelation relation = SphereRelation::Outside;
    bool whole = false;  ///< drawn completely, without a walk
    CellWalk walk;
    std::optional<ObjectRecord> record{};  ///< only while the frame is recorded
};

/// The decisions of one frame.
class LosslessFrame {
public:
    LosslessFrame(FrameContext& frame, const CellScene& structure, const ParameterSet& parameters)
        : m_frame(frame),
          m_structure(structure),
          m_cones(parameters.boolean("cones")),
          m_horizon(parameters.boolean("horizon")) {}

    void run() {
        std::vector<KeptObject> kept = keep();
        if (m_frame.recording() && m_horizon && m_frame.said() > 0) m_frame.attach(std::make_shared<KernelsDetail>());
        sortNearestFirst(kept, scene(), m_frame.view().eye());
        std::vector<WalkedObject> decided(kept.size());
        m_tests = kept.size() <= kMostWithTests;
        if (m_frame.recording() && !m_tests) sayResultsAlone(m_frame);
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("cells"));
            const auto decideOne = [&](size_t i) { decided[i] = decideAbout(kept[i]); };
            if (kept.size() < kObjectsForThreads)
                for (size_t i = 0; i < kept.size(); ++i) decideOne(i);
            else
                tbb::parallel_for(size_t{0}, kept.size(), decideOne);
        }
        DrawList list{m_frame.facing(), {}, m_structure.order};
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("draw list"));
            m_frame.counters().parts = {
                {CULLSCOPE_TR("cells against the frustum"), 0, counters().culledTriangles[size_t(Cause::OutsideFrustum)]},
                {CULLSCOPE_TR("normal cones"), 0, 0},
                {CULLSCOPE_TR("horizon of the kernel"), 0, 0}};
            if (m_frame.recording()) m_frame.countPlacesIn(m_structure.order);
            for (const WalkedObject& object : decided) {
                submit(object, list);
                if (object.record) object.record->sayTo(m_frame);
            }
        }
        m_frame.draw(std::move(list));
    }

private:
    [[nodiscard]] const Scene& scene() const { return m_frame.scene(); }
    [[nodiscard]] FrameCounters& counters() { return m_frame.counters(); }

    [[nodiscard]] std::vector<KeptObject> keep() {
        const StageTimer stage(m_frame, CULLSCOPE_TR("groups of objects"));
        OctreeWalkCounters walked;
        std::vector<KeptObject> kept = keptObjects(m_structure.octree, m_frame, &walked, {.lines = kWalkLines});
        counters().culledTriangles[size_t(Cause::OutsideFrustum)] += walked.trianglesCulled;
        counters().nodesVisited += walked.nodesVisited + walked.objectsTested;
        counters().bytesTouched += walked.nodesVisited * sizeof(InstanceOctree::Node) + walked.objectsTested * sizeof(Box3);
        return kept;
    }

    [[nodiscard]] WalkedObject decideAbout(const KeptObject& object) const {
        const MeshCells& mesh = m_structure.meshOf(object.instance);
        WalkedObject result{object.instance, object.planes == 0 ? SphereRelation::Within : SphereRelation::Cut, true, {}};
        if (m_frame.recording()) result.record.emplace(object.instance, m_tests);
        ObjectRecord* record = result.record ? &*result.record : nullptr;
        if (!mesh.tree->divided()) {
            if (record != nullptr) sayWhole(result, *record);
            return result;
        }
        result.whole = false;
        const ObjectSpaceView seen =
            objectSpaceView(scene(), object.instance, mesh.tree->sphere(), m_frame.view(), record, uint8_t(WalkLine::Sphere));
        result.relation = seen.relation;
        if (seen.relation == SphereRelation::Outside) {
            if (record != nullptr) record->say(atLine(WalkLine::Sphere, ending(record->subject(), Decision::Outcome::Culled)));
            return result;
        }
        CellTests tests{planesToTest(object, seen),
                        dropsBacks(scene(), object.instance, m_frame.facing()) && m_cones && seen.eyeKnown};
        const std::optional<KernelHorizon> horizon = horizonOf(object.instance, mesh, seen);
        tests.horizon = horizon ? &*horizon : nullptr;
        if (record == nullptr)
            result.walk = walkCells(*mesh.tree, seen, tests);
        else
            result.walk = recordedWalk(mesh, seen, tests, *record);
        return result;
    }

    /// The same walk, of which it is said how it begins, then all that falls, then what became of the object.
    [[nodiscard]] static CellWalk recordedWalk(const MeshCells& mesh, const ObjectSpaceView& seen, const CellTests& tests,
                                               ObjectRecord& record) {
        const auto begin = std::make_shared<WalkDetail>();
        begin->cones = tests.cones;
        begin->horizon = tests.horizon != nullptr;
        if (tests.horizon != nullptr) begin->outline = tests.horizon->outline(*mesh.kernel);
        record.attach(begin);
        CellWalk walk = walkCells(*mesh.tree, seen, tests, &record);
        begin->nodesVisited = walk.nodesVisited;
        uint64_t drawn = 0;
        for (const PlaceRun& run : walk.drawn) drawn += run.count;
        const auto outcome = drawn == mesh.tree->mesh().triangleCount() ? Decision::Outcome::Drawn
                             : drawn > 0                                ? Decision::Outcome::PartlyDrawn
                                                                        : Decision::Outcome::Culled;
        // What became of an object's cells was decided cell by cell: their sum falls at no line.
        record.say(
            ending(record.subject(), outcome, outcome == Decision::Outcome::Drawn ? Cause::OutsideFrustum : mainCause(walk)));
        return walk;
    }

    void sayWhole(const WalkedObject& object, ObjectRecord& record) const {
        record.say(atLine(WalkLine::Objects, ending(record.subject(), Decision::Outcome::Drawn)));
        record.attach(std::make_shared<SphereDetail>(object.relation, Vec3(0.0)));
        auto walk = std::make_shared<WalkDetail>();
        walk->whole = scene().meshOf(object.instance).triangleCount();
        record.attach(std::move(walk));
    }

    /// The planes that cut both the box and the sphere of the object.
    [[nodiscard]] static uint8_t planesToTest(const KeptObject& object, const ObjectSpaceView& seen) {
        uint8_t planes = object.planes;
        for (size_t p = 0; p < seen.planesTested; ++p)
            if (seen.planes[p].containment == Containment::Inside) planes = uint8_t(planes & ~(1U << p));
        return planes;
    }

    /// Without a horizon where the near plane cuts the object, or where the kernel's outer side is not drawn: then the surface
    /// around it hides nothing.
    [[nodiscard]] std::optional<KernelHorizon> horizonOf(uint32_t instance, const MeshCells& mesh,
                                                         const ObjectSpaceView& seen) const {
        if (!m_horizon || !mesh.kernel || !mesh.kernel->filled() || !seen.beyondNear ||
            seen.relation == SphereRelation::AroundEye)
            return {};
        if (dropsBacks(scene(), instance, m_frame.facing()) && !mesh.kernel->outward()) return {};
        KernelHorizon horizon(*mesh.kernel, seen.eye, mesh.tree->sphere().radius, snapping(seen));
        return horizon.usable() ? std::optional(std::move(horizon)) : std::nullopt;
    }

    void submit(const WalkedObject& object, DrawList& list) {
        const uint64_t triangles = scene().meshOf(object.instance).triangleCount();
        if (object.whole) {
            list.ranges.push_back({object.instance, 0, uint32_t(3 * triangles)});
            return;
        }
        if (object.relation == SphereRelation::Outside) {
            counters().culledTriangles[size_t(Cause::OutsideFrustum)] += triangles;
            counters().parts[0].culledTriangles += triangles;
            return;
        }
        const CellWalk& walk = object.walk;
        for (const PlaceRun& run : walk.drawn) list.ranges.push_back({object.instance, 3 * run.first, 3 * run.count});
        for (size_t cause = 0; cause < kCauseCount; ++cause) counters().culledTriangles[cause] += walk.culled[cause];
        constexpr std::array kCauses{Cause::OutsideFrustum, Cause::BackFacing, Cause::Hidden};
        const std::array used{true, walk.cones, walk.hiding};
        for (size_t part = 0; part < kCauses.size(); ++part) {
            counters().parts[part].objects += used[part] ? 1 : 0;
            counters().parts[part].culledTriangles += walk.culled[size_t(kCauses[part])];
        }
        counters().nodesVisited += walk.nodesVisited;
        counters().bytesTouched += walk.nodesVisited * sizeof(CellTree::Node);
    }

    FrameContext& m_frame;
    const CellScene& m_structure;
    bool m_cones, m_horizon;
    bool m_tests = false;  ///< whether a record holds tests
};

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
        buildCells(structure, options, kLeastTrianglesForHorizon, progress);
    }

    void decide(FrameContext& frame, const CellScene& structure, ViewState& /*state*/,
                const ParameterSet& parameters) const override {
        LosslessFrame(frame, structure, parameters).run();
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
        node.cause = decision.walk ? mainCause(*decision.walk) : Cause::OutsideFrustum;
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
                                       "closed)."))}};
    info.needsEyePoint = true;
    info.sweeps = {{"level", {"4", "5", "6", "7", "8", "0"}, "0"}};
    info.shows = withListing(showsOfCells(), walkListing());
    info.shows.push_back(trianglesByTestShow());
    return {info, std::make_shared<SphericalLossless>(info.id)};
}

}  // namespace cullscope::spherical
