#include "core/visibility/spherical/lossless_culling.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/spherical/cell_walk.h"

namespace cullscope::spherical {
namespace {

// With fewer triangles, setting up the horizon costs more than it saves.
constexpr size_t kLeastTrianglesForHorizon = 2000;
// An object of fewer triangles is drawn faster than its cells are tested.
constexpr size_t kLeastTrianglesForCells = 1000;
// From this number of objects, a second thread saves time.
constexpr size_t kObjectsForThreads = 8;

/// The structures of one mesh; empty for a mesh without triangles or instances.
struct MeshCells {
    CellTreePointer tree;
    InnerKernelPointer kernel;
    LazyMaps maps;
};

class SphericalLossless final : public Strategy {
public:
    explicit SphericalLossless(ParameterSet set)
        : Strategy(std::move(set)),
          m_options{mapLayoutFromId(parameters().choice("layout")), uint32_t(parameters().integer("level")),
                    kLeastTrianglesForCells},
          m_cones(parameters().boolean("cones")),
          m_horizon(parameters().boolean("horizon")) {}

    [[nodiscard]] Promise promise() const override { return Promise::Conservative; }

    [[nodiscard]] StructureSnapshot snapshot(const Trace& trace) const override {
        const std::vector<std::optional<FrustumPlane>> rejectedBy = rejectingPlanes(trace, scene().instances().size());
        StructureSnapshot result;
        for (const SphericalDecision& decision : trace.spherical) {
            const MeshCells& mesh = cellsOf(decision.instance);
            result.maps.push_back({mesh.maps, decision, mesh.tree, mesh.kernel});
            result.nodes.push_back(nodeOf(decision));
            result.nodes.back().rejectedBy = rejectedBy[decision.instance];
        }
        addGroups(result, m_octree, scene(), trace);
        return result;
    }

protected:
    void buildStructures(const Scene& scene, const Progress& progress, StructureReport& report) override {
        m_meshes.assign(scene.meshes().size(), {});
        const std::vector<bool> shown = scene.shownMeshes();
        for (size_t i = 0; i < m_meshes.size(); ++i) {
            if (!shown[i]) continue;
            const Progress part = progress.part(double(i) / double(m_meshes.size()), double(i + 1) / double(m_meshes.size()));
            const MeshPointer& mesh = scene.meshes()[i];
            m_meshes[i].tree = std::make_shared<CellTree>(mesh, m_options, part);
            if (wantsKernel(*mesh)) m_meshes[i].kernel = std::make_shared<InnerKernel>(*mesh);
            m_meshes[i].maps = LazyMaps(mesh);
        }
        m_octree = InstanceOctree(scene);
        m_order = orderOfAll();
        fillReport(report);
    }

    void decide(const View& view, Verdict& verdict, Trace* trace) override {
        std::vector<KeptObject> kept = keep(view, verdict, trace);
        sortNearestFirst(kept, scene(), view.eye());
        std::vector<Decided> decided(kept.size());
        {
            const StageTimer stage(verdict, CULLSCOPE_TR("cells"));
            const auto decideOne = [&](size_t i) { decided[i] = decideAbout(kept[i], view, trace != nullptr); };
            if (kept.size() < kObjectsForThreads)
                for (size_t i = 0; i < kept.size(); ++i) decideOne(i);
            else
                tbb::parallel_for(size_t{0}, kept.size(), decideOne);
        }
        const StageTimer stage(verdict, CULLSCOPE_TR("draw list"));
        verdict.drawList.order = m_order;
        verdict.parts = {{CULLSCOPE_TR("cells against the frustum"), 0, verdict.culledTriangles[size_t(Cause::OutsideFrustum)]},
                         {CULLSCOPE_TR("normal cones"), 0, 0},
                         {CULLSCOPE_TR("horizon of the kernel"), 0, 0}};
        for (const Decided& object : decided) submit(object, verdict);
        if (trace != nullptr) record(decided, view, *trace);
    }

private:
    /// The decision about an object that no group test culled.
    struct Decided {
        uint32_t instance = 0;
        SphereRelation relation = SphereRelation::Outside;
        bool whole = false;  ///< drawn completely, without a walk
        CellWalk walk;
    };

    [[nodiscard]] const MeshCells& cellsOf(uint32_t instance) const { return m_meshes[scene().instances()[instance].mesh]; }

    [[nodiscard]] bool wantsKernel(const TriangleMesh& mesh) const {
        return m_horizon && mesh.triangleCount() >= kLeastTrianglesForHorizon;
    }

    [[nodiscard]] TriangleOrderPointer orderOfAll() const {
        auto order = std::make_shared<TriangleOrder>();
        auto owner = std::make_shared<std::vector<CellTreePointer>>();
        for (const MeshCells& mesh : m_meshes) {
            owner->push_back(mesh.tree);
            order->meshes.push_back(mesh.tree && mesh.tree->divided()
                                        ? TriangleOrder::OfMesh{mesh.tree->indices(), mesh.tree->triangleOrder()}
                                        : TriangleOrder::OfMesh{});
        }
        order->owner = std::move(owner);
        return order;
    }

    void fillReport(StructureReport& report) const {
        double nodes = 0, leaves = 0, deepest = 0, treeBytes = 0, kernels = 0, kernelBytes = 0;
        for (const MeshCells& mesh : m_meshes) {
            if (!mesh.tree) continue;
            nodes += double(mesh.tree->nodes().size());
            leaves += double(mesh.tree->leafCount());
            deepest = std::max(deepest, double(mesh.tree->deepestLevel()));
            treeBytes += double(mesh.tree->bytes());
            if (!mesh.kernel) continue;
            kernels += mesh.kernel->filled() ? 1 : 0;
            kernelBytes += double(mesh.kernel->bytes());
        }
        report.bytes = uint64_t(treeBytes + kernelBytes) + m_octree.bytes();
        report.figures = {{"objects", double(scene().instances().size())},
                          {"groups", double(m_octree.nodes().size())},
                          {"cells", nodes},
                          {"leaf cells", leaves},
                          {"deepest level", deepest},
                          {"kernels", kernels},
                          {"cell tree bytes", treeBytes},
                          {"kernel bytes", kernelBytes},
                          {"octree bytes", double(m_octree.bytes())}};
    }

    [[nodiscard]] std::vector<KeptObject> keep(const View& view, Verdict& verdict, Trace* trace) const {
        const StageTimer stage(verdict, CULLSCOPE_TR("groups of objects"));
        OctreeWalkCounters figures;
        std::vector<KeptObject> kept = keptObjects(m_octree, scene(), view, &figures, trace);
        verdict.culledTriangles[size_t(Cause::OutsideFrustum)] += figures.trianglesCulled;
        verdict.nodesVisited += figures.nodesVisited + figures.objectsTested;
        verdict.bytesTouched += figures.nodesVisited * sizeof(InstanceOctree::Node) + figures.objectsTested * sizeof(Box3);
        return kept;
    }

    [[nodiscard]] Decided decideAbout(const KeptObject& object, const View& view, bool traced) const {
        const MeshCells& mesh = cellsOf(object.instance);
        Decided result{object.instance, object.planes == 0 ? SphereRelation::Within : SphereRelation::Cut, true, {}};
        if (!mesh.tree->divided()) return result;
        result.whole = false;
        const ObjectSpaceView seen = objectSpaceView(scene(), object.instance, mesh.tree->sphere(), view);
        result.relation = seen.relation;
        if (seen.relation == SphereRelation::Outside) return result;
        CellTests tests{planesToTest(object, seen), facing() == Facing::Front && m_cones && seen.eyeKnown};
        const std::optional<KernelHorizon> horizon = horizonOf(mesh, seen);
        tests.horizon = horizon ? &*horizon : nullptr;
        result.walk = walkCells(*mesh.tree, seen, tests, traced);
        if (traced && horizon) result.walk.outline = horizon->outline(*mesh.kernel);
        return result;
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
    [[nodiscard]] std::optional<KernelHorizon> horizonOf(const MeshCells& mesh, const ObjectSpaceView& seen) const {
        if (!mesh.kernel || !mesh.kernel->filled() || !seen.beyondNear || seen.relation == SphereRelation::AroundEye) return {};
        if (facing() == Facing::Front && !mesh.kernel->outward()) return {};
        KernelHorizon horizon(*mesh.kernel, seen.eye, mesh.tree->sphere().radius, snapping(seen));
        return horizon.usable() ? std::optional(std::move(horizon)) : std::nullopt;
    }

    void submit(const Decided& object, Verdict& verdict) const {
        const uint64_t triangles = scene().meshOf(object.instance).triangleCount();
        if (object.whole) {
            verdict.drawList.ranges.push_back({object.instance, 0, uint32_t(3 * triangles)});
            return;
        }
        if (object.relation == SphereRelation::Outside) {
            verdict.culledTriangles[size_t(Cause::OutsideFrustum)] += triangles;
            verdict.parts[0].culledTriangles += triangles;
            return;
        }
        const CellWalk& walk = object.walk;
        for (const PlaceRun& run : walk.drawn) verdict.drawList.ranges.push_back({object.instance, 3 * run.first, 3 * run.count});
        for (size_t cause = 0; cause < kCauseCount; ++cause) verdict.culledTriangles[cause] += walk.culled[cause];
        constexpr std::array kCauses{Cause::OutsideFrustum, Cause::BackFacing, Cause::Hidden};
        const std::array used{true, walk.cones, walk.horizon};
        for (size_t part = 0; part < kCauses.size(); ++part) {
            verdict.parts[part].objects += used[part] ? 1 : 0;
            verdict.parts[part].culledTriangles += walk.culled[size_t(kCauses[part])];
        }
        verdict.nodesVisited += walk.nodesVisited;
        verdict.bytesTouched += walk.nodesVisited * sizeof(CellTree::Node);
    }

    void record(const std::vector<Decided>& decided, const View& view, Trace& trace) const {
        std::vector<SphericalDecision> decisions(scene().instances().size());
        for (uint32_t instance = 0; instance < decisions.size(); ++instance) decisions[instance].instance = instance;
        for (const Decided& object : decided) {
            SphericalDecision& decision = decisions[object.instance];
            decision.relation = object.relation;
            if (object.relation != SphereRelation::Outside) decision.walk = object.walk;
            if (object.whole) {
                const auto triangles = uint32_t(scene().meshOf(object.instance).triangleCount());
                decision.walk->drawn.push_back({0, triangles});
                decision.walk->judged.push_back({0, std::nullopt});
            } else {
                const ObjectSpaceView seen =
                    objectSpaceView(scene(), object.instance, cellsOf(object.instance).tree->sphere(), view);
                decision.eye = seen.eye;
                recordTests(seen, object.instance, trace);
            }
            if (decision.walk)
                for (const PlaceRun& run : decision.walk->drawn) decision.drawnTriangles += run.count;
            recordEnd(decision, trace);
        }
        for (SphericalDecision& decision : decisions)
            if (scene().meshOf(decision.instance).triangleCount() > 0) trace.spherical.push_back(std::move(decision));
    }

    static void recordTests(const ObjectSpaceView& seen, uint32_t instance, Trace& trace) {
        for (size_t p = 0; p < seen.planesTested; ++p) {
            const ObjectSpaceView::PlaneTest& test = seen.planes[p];
            trace.events.push_back({TraceEvent::Kind::TestedPlane, instance, static_cast<FrustumPlane>(p), test.containment,
                                    test.distance, Cause::OutsideFrustum, test.bound});
        }
    }

    /// The cause for which most of the culled triangles were culled.
    [[nodiscard]] static Cause mainCause(const SphericalDecision& decision) {
        if (!decision.walk) return Cause::OutsideFrustum;
        const std::array<uint64_t, kCauseCount>& culled = decision.walk->culled;
        return static_cast<Cause>(std::max_element(culled.begin(), culled.end()) - culled.begin());
    }

    void recordEnd(const SphericalDecision& decision, Trace& trace) const {
        TraceEvent end{TraceEvent::Kind::Culled, decision.instance};
        end.cause = mainCause(decision);
        if (decision.drawnTriangles > 0) end.kind = TraceEvent::Kind::PartlyDrawn;
        if (decision.drawnTriangles == scene().meshOf(decision.instance).triangleCount()) end.kind = TraceEvent::Kind::Accepted;
        trace.events.push_back(end);
        if (!decision.walk) return;
        for (const JudgedCell& judged : decision.walk->judged) {
            const CellTree::Node& node = cellsOf(decision.instance).tree->nodes()[judged.node];
            if (judged.cause) trace.culledRuns.push_back({decision.instance, {node.first, node.count}, *judged.cause});
        }
    }

    [[nodiscard]] SnapshotNode nodeOf(const SphericalDecision& decision) const {
        SnapshotNode node;
        node.instance = decision.instance;
        node.box = scene().instanceBox(decision.instance);
        node.triangles = scene().meshOf(decision.instance).triangleCount();
        node.culled = decision.drawnTriangles == 0;
        node.cause = mainCause(decision);
        node.containment = decision.relation == SphereRelation::Outside  ? Containment::Outside
                           : decision.relation == SphereRelation::Within ? Containment::Inside
                                                                         : Containment::Straddles;
        return node;
    }

    CellTree::Options m_options;
    bool m_cones, m_horizon;
    std::vector<MeshCells> m_meshes;
    InstanceOctree m_octree;
    TriangleOrderPointer m_order;
};

}  // namespace

StrategyInfo sphericalLosslessInfo() {
    return {
        "spherical-lossless",
        CULLSCOPE_TR("Spherical coordinates, lossless"),
        CULLSCOPE_TR("Tests the cells of a map of directions, from large to small, against the frustum, by normal cones and by "
                     "the horizon of the solid's inner kernel: loses nothing on any mesh."),
        "Han & Hong 2008 made conservative; Shirman & Abi-Ezzi 1993",
        {facingParameter(),
         choiceParameter("layout", "octahedral", CULLSCOPE_TR("How directions are laid out on the map."),
                         {{"octahedral", CULLSCOPE_TR("an octahedron unfolded: no poles, no trigonometry")},
                          {"latitude-longitude", CULLSCOPE_TR("rows of zenith angle and columns of azimuth, as in the paper")}}),
         {"level",
          ParameterType::Integer,
          int64_t{0},
          0.0,
          double(kFinestLevel),
          "",
          CULLSCOPE_TR(
              "How often the map is quartered: 2^level cells a side; 0: down to some four dozen triangles a cell. An object of "
              "fewer than a thousand is one cell."),
          {}},
         booleanParameter("cones", true,
                          CULLSCOPE_TR("Whether cells whose triangles all face away are left out (where only front sides "
                                       "are drawn).")),
         booleanParameter("horizon", true,
                          CULLSCOPE_TR("Whether cells behind the solid's inner kernel are left out (where the mesh is "
                                       "closed)."))}};
}

StrategyPointer makeSphericalLossless(ParameterSet parameters) {
    return std::make_unique<SphericalLossless>(std::move(parameters));
}

}  // namespace cullscope::spherical
