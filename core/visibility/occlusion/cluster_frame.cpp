#include "core/visibility/occlusion/cluster_frame.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>

#include "core/base/message.h"
#include "core/visibility/object_record.h"
#include "core/visibility/part_walk.h"

namespace cullscope::occlusion {
namespace {

// From this number of objects, a second thread saves time.
constexpr size_t kObjectsForThreads = 16;

constexpr OctreeWalkLines kGroupLines{.groupPlanes = uint8_t(ClusterLine::Groups),
                                      .groupAxes = uint8_t(ClusterLine::Groups),
                                      .groupOutside = uint8_t(ClusterLine::Outside),
                                      .groupInside = uint8_t(ClusterLine::Groups),
                                      .objectTests = uint8_t(ClusterLine::Groups),
                                      .objectOutside = uint8_t(ClusterLine::Outside)};
constexpr BufferLines kClusterBufferLines{.walk = kGroupLines,
                                          .group = uint8_t(ClusterLine::Hidden),
                                          .object = uint8_t(ClusterLine::Hidden),
                                          .hidden = uint8_t(ClusterLine::Hidden),
                                          .occlude = uint8_t(ClusterLine::Occlude),
                                          .again = uint8_t(ClusterLine::Hidden)};
constexpr PartWalkLines kPartLines{.planes = uint8_t(ClusterLine::Planes),
                                   .cones = uint8_t(ClusterLine::Cones),
                                   .hiding = uint8_t(ClusterLine::HiddenPart),
                                   .draw = uint8_t(ClusterLine::Draw)};

/// The decision about an object that no group test culled.
struct WalkedObject {
    uint32_t instance = 0;
    bool whole = false;  ///< drawn completely, without a walk
    PartWalk walk;
    std::optional<ObjectRecord> record{};  ///< only while the frame is recorded
};

/// The cause for which most of the culled triangles were culled.
Cause mainCause(const PartWalk& walk) { return Cause(std::ranges::max_element(walk.culled) - walk.culled.begin()); }

class ClusterFrame {
public:
    ClusterFrame(FrameContext& frame, const ClusterScene& structure, const ClusterOptions& options)
        : m_frame(frame), m_structure(structure), m_options(options) {}

    void run(ClusterMemory& memory) {
        const std::vector<KeptObject> kept = m_options.occlusion ? keepUnhidden(memory) : keep(memory);
        std::vector<WalkedObject> decided(kept.size());
        m_tests = kept.size() <= kMostWithTests;
        if (m_frame.recording() && !m_tests) sayResultsAlone(m_frame);
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("clusters"));
            const auto decideOne = [&](size_t i) { decided[i] = decideAbout(kept[i]); };
            // One thread at a time asks the buffer.
            if (kept.size() < kObjectsForThreads || m_buffer != nullptr)
                for (size_t i = 0; i < kept.size(); ++i) decideOne(i);
            else
                tbb::parallel_for(size_t{0}, kept.size(), decideOne);
        }
        DrawList list{m_frame.facing(), {}, m_structure.clusters.order};
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("draw list"));
            m_frame.counters().parts = {
                {CULLSCOPE_TR("planes of the frustum"), kept.size(), counters().culledTriangles[size_t(Cause::OutsideFrustum)]},
                {CULLSCOPE_TR("normal cones"), 0, 0},
                {CULLSCOPE_TR("occluders"), m_buffer != nullptr ? kept.size() : 0,
                 counters().culledTriangles[size_t(Cause::Hidden)]}};
            if (m_frame.recording()) m_frame.countPlacesIn(m_structure.clusters.order);
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

    [[nodiscard]] std::vector<KeptObject> keep(ClusterMemory& memory) {
        const StageTimer stage(m_frame, CULLSCOPE_TR("groups of objects"));
        OctreeWalkCounters walked;
        std::vector<KeptObject> kept =
            keptObjects(m_structure.octree, m_frame, &walked,
                        {.refine = true, .memory = &memory.planes, .lines = kGroupLines, .visited = {}});
        sortNearestFirst(kept, scene(), m_frame.view().eye());
        count(walked);
        return kept;
    }

    /// The same without the objects that others hide; keeps the buffer for the clusters of the others.
    [[nodiscard]] std::vector<KeptObject> keepUnhidden(ClusterMemory& memory) {
        const StageTimer stage(m_frame, CULLSCOPE_TR("walk and occluders"));
        if (!memory.buffer || memory.buffer->form() != *m_options.occlusion) memory.buffer.emplace(*m_options.occlusion);
        BufferCounters counted;
        std::vector<KeptObject> kept =
            walkWithBuffer(m_structure.octree, m_structure.occluders, m_structure.parts, m_frame,
                           {m_options.pixels, m_options.triangles, kClusterBufferLines}, memory.planes, *memory.buffer, counted);
        count(counted.walk);
        counters().culledTriangles[size_t(Cause::Hidden)] += counted.hiddenTriangles;
        counters().figures = {{"occluders", double(counted.occluders)},
                              {"occluder_triangles", double(memory.buffer->counts().given)},
                              {"questions", double(counted.questions)}};
        if (memory.buffer->empty()) return kept;
        counters().workBytes = memory.buffer->bytes();
        m_buffer = &*memory.buffer;
        return kept;
    }

    void count(const OctreeWalkCounters& walked) {
        counters().culledTriangles[size_t(Cause::OutsideFrustum)] += walked.trianglesCulled;
        counters().nodesVisited += walked.nodesVisited + walked.objectsTested;
        counters().bytesTouched += walked.nodesVisited * sizeof(InstanceOctree::Node) + walked.objectsTested * sizeof(Box3);
    }

    [[nodiscard]] WalkedObject decideAbout(const KeptObject& object) const {
        const ClusterTree& tree = m_structure.clusters.of(scene(), object.instance);
        WalkedObject result{object.instance, false, {}};
        if (m_frame.recording()) result.record.emplace(object.instance, m_tests);
        const bool cones = m_options.cones && dropsBacks(scene(), object.instance, m_frame.facing());
        // The planes were tested with the object's own bounds; of a single cluster nothing else is left.
        const SurfaceNode& root = tree.nodes().front();
        const bool nothing = root.leaf() ? !cones || !root.hasCone() : object.planes == 0 && !cones;
        if (nothing && m_buffer == nullptr) {
            result.whole = true;
            if (result.record)
                result.record->say(
                    atLine(ClusterLine::Objects, ending(Subject::ofObject(object.instance), Decision::Outcome::Drawn)));
            return result;
        }
        const EyeFromLocal fromEye = eyeFromLocal(scene(), object.instance, tree.sphere(), Mat3(1.0), m_frame.view().eye());
        const PartView seen = partView(m_frame.view(), fromEye);
        std::optional<BufferHiding> hiding;
        if (m_buffer != nullptr) hiding.emplace(*m_buffer, m_frame.view(), fromEye);
        const PartTests tests{object.planes, cones, hiding ? &*hiding : nullptr, kPartLines};
        result.walk = walkParts(SurfaceNodes(tree.nodes()), seen, tests, result.record ? &*result.record : nullptr);
        if (result.record) sayEnd(result.walk, tree.mesh().triangleCount(), *result.record);
        return result;
    }

    /// What became of an object of so many triangles.
    static void sayEnd(const PartWalk& walk, uint64_t triangles, ObjectRecord& record) {
        uint64_t drawn = 0;
        for (const PlaceRun& run : walk.drawn) drawn += run.count;
        const auto outcome = drawn == triangles ? Decision::Outcome::Drawn
                             : drawn > 0        ? Decision::Outcome::PartlyDrawn
                                                : Decision::Outcome::Culled;
        record.say(atLine(ClusterLine::Objects, ending(record.subject(), outcome, mainCause(walk))));
    }

    void submit(const WalkedObject& object, DrawList& list) {
        if (object.whole) {
            list.ranges.push_back({object.instance, 0, uint32_t(3 * scene().meshOf(object.instance).triangleCount())});
            return;
        }
        const PartWalk& walk = object.walk;
        for (const PlaceRun& run : walk.drawn) list.ranges.push_back({object.instance, 3 * run.first, 3 * run.count});
        for (size_t cause = 0; cause < kCauseCount; ++cause) counters().culledTriangles[cause] += walk.culled[cause];
        std::vector<CullPart>& parts = counters().parts;
        parts[0].culledTriangles += walk.culled[size_t(Cause::OutsideFrustum)];
        parts[1].culledTriangles += walk.culled[size_t(Cause::BackFacing)];
        parts[1].objects += walk.cones ? 1 : 0;
        parts[2].culledTriangles += walk.culled[size_t(Cause::Hidden)];
        counters().nodesVisited += walk.nodesVisited;
        counters().bytesTouched += walk.nodesVisited * sizeof(SurfaceNode);
    }

    FrameContext& m_frame;
    const ClusterScene& m_structure;
    ClusterOptions m_options;
    OcclusionBuffer* m_buffer = nullptr;  ///< null: nothing hides
    bool m_tests = false;                 ///< whether a record holds tests
};

}  // namespace

void drawClusters(FrameContext& frame, const ClusterScene& structure, ClusterMemory& memory, const ClusterOptions& options) {
    ClusterFrame(frame, structure, options).run(memory);
}

}  // namespace cullscope::occlusion
