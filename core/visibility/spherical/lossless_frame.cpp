#include "core/visibility/spherical/lossless_frame.h"

#include <tbb/parallel_for.h>

#include <optional>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/single_triangles.h"
#include "core/visibility/spherical/cell_walk.h"
#include "core/visibility/spherical/listings.h"
#include "core/visibility/spherical/recorded_decisions.h"
#include "core/visibility/spherical/recorded_tests.h"

namespace cullscope::spherical {
namespace {

// From this number of objects, a second thread saves time.
constexpr size_t kObjectsForThreads = 8;
// Where no plane cuts an object, its cells are tested for what faces away and what is hidden alone. With a smaller share facing
// away on average, the walk almost always ends in drawing all of it, and in an object of fewer triangles the horizon hides
// next to nothing, so that both tests would only cost time: 2 to 5 % of a frame.
constexpr double kLeastShareFacingAway = 0.25;
constexpr size_t kLeastTrianglesForHorizonInView = 20'000;

constexpr OctreeWalkLines kWalkLines{.groupPlanes = uint8_t(WalkLine::Groups),
                                     .groupOutside = uint8_t(WalkLine::GroupOutside),
                                     .groupInside = uint8_t(WalkLine::Groups),
                                     .objectTests = uint8_t(WalkLine::Groups),
                                     .objectOutside = uint8_t(WalkLine::GroupOutside)};

/// The decision about an object that no group test culled.
struct WalkedObject {
    uint32_t instance = 0;
    SphereRelation relation = SphereRelation::Outside;
    bool whole = false;  ///< drawn completely, without a walk
    CellWalk walk;
    std::optional<SampledTriangles::Found> sampled{};  ///< among the walk's runs, where triangles are tested
    std::optional<ObjectRecord> record{};              ///< only while the frame is recorded
};

/// The triangles of a walked object that are not drawn, by cause.
CulledByCause culledOf(const WalkedObject& object) {
    CulledByCause culled = object.walk.culled;
    if (object.sampled) addLeftOut(*object.sampled, culled);
    return culled;
}

/// The decisions of one frame.
class LosslessFrame {
public:
    LosslessFrame(FrameContext& frame, const CellScene& structure, const ParameterSet& parameters)
        : m_frame(frame),
          m_structure(structure),
          m_cones(parameters.boolean("cones")),
          m_horizon(parameters.boolean("horizon")),
          m_triangles(parameters.boolean("triangles")),
          m_cover(frame.view()) {}

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
                {CULLSCOPE_TR("horizon of the kernel"), 0, 0},
                {CULLSCOPE_TR("triangles one by one"), 0, 0}};
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
        const bool cut = tests.planes != 0;
        tests.cones = tests.cones && (cut || mesh.shareFacingAway >= kLeastShareFacingAway);
        std::optional<KernelHorizon> horizon;
        if (cut || mesh.tree->mesh().triangleCount() >= kLeastTrianglesForHorizonInView)
            horizon = horizonOf(object.instance, mesh, seen);
        tests.horizon = horizon ? &*horizon : nullptr;
        const std::shared_ptr<WalkDetail> detail = record != nullptr ? begin(mesh, tests, *record) : nullptr;
        result.walk = walkCells(*mesh.tree, seen, tests, record);
        if (detail) detail->nodesVisited = result.walk.nodesVisited;
        if (m_triangles) result.sampled = leaveOutTriangles(m_frame, m_cover, object.instance, mesh.corners, result.walk.drawn);
        if (record != nullptr) sayEnd(result, mesh, *record);
        return result;
    }

    /// Says how the walk over an object's cells begins; what it visits is set after it.
    static std::shared_ptr<WalkDetail> begin(const MeshCells& mesh, const CellTests& tests, ObjectRecord& record) {
        auto begin = std::make_shared<WalkDetail>();
        begin->cones = tests.cones;
        begin->horizon = tests.horizon != nullptr;
        if (tests.horizon != nullptr) begin->outline = tests.horizon->outline(*mesh.kernel);
        record.attach(begin);
        return begin;
    }

    /// Says which triangles of the drawn cells were left out, then what became of the object.
    static void sayEnd(const WalkedObject& object, const MeshCells& mesh, ObjectRecord& record) {
        if (object.sampled) sayLeftOut(*object.sampled, object.walk.drawn, uint8_t(WalkLine::Triangles), record);
        const uint64_t drawn = triangleCount(object.sampled ? object.sampled->kept : object.walk.drawn);
        const auto outcome = drawn == mesh.tree->mesh().triangleCount() ? Decision::Outcome::Drawn
                             : drawn > 0                                ? Decision::Outcome::PartlyDrawn
                                                                        : Decision::Outcome::Culled;
        // What became of an object's cells was decided cell by cell: their sum falls at no line.
        record.say(ending(record.subject(), outcome,
                          outcome == Decision::Outcome::Drawn ? Cause::OutsideFrustum : mainCause(culledOf(object))));
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
        for (const PlaceRun& run : object.sampled ? object.sampled->kept : walk.drawn)
            list.ranges.push_back({object.instance, 3 * run.first, 3 * run.count});
        const CulledByCause culled = culledOf(object);
        for (size_t cause = 0; cause < kCauseCount; ++cause) counters().culledTriangles[cause] += culled[cause];
        constexpr std::array kCauses{Cause::OutsideFrustum, Cause::BackFacing, Cause::Hidden};
        const std::array used{true, walk.cones, walk.hiding};
        for (size_t part = 0; part < kCauses.size(); ++part) {
            counters().parts[part].objects += used[part] ? 1 : 0;
            counters().parts[part].culledTriangles += walk.culled[size_t(kCauses[part])];
        }
        if (object.sampled) {
            ++counters().parts[3].objects;
            counters().parts[3].culledTriangles += object.sampled->facingAway + object.sampled->withoutSample;
        }
        counters().nodesVisited += walk.nodesVisited;
        counters().bytesTouched += walk.nodesVisited * sizeof(CellTree::Node);
    }

    FrameContext& m_frame;
    const CellScene& m_structure;
    bool m_cones, m_horizon, m_triangles;
    PixelCover m_cover;
    bool m_tests = false;  ///< whether a record holds tests
};

}  // namespace

void drawLossless(FrameContext& frame, const CellScene& structure, const ParameterSet& parameters) {
    LosslessFrame(frame, structure, parameters).run();
}

}  // namespace cullscope::spherical
