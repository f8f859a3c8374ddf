#include "core/visibility/occlusion/cluster_frame.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <map>
#include <optional>

#include "core/base/message.h"
#include "core/visibility/object_record.h"
#include "core/visibility/part_walk.h"
#include "core/visibility/single_triangles.h"

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
    std::vector<uint32_t> leaves{};                    ///< that are tested against a pyramid
    std::optional<SampledTriangles::Found> sampled{};  ///< among the walk's runs, where triangles are tested
    std::optional<ObjectRecord> record{};              ///< only while the frame is recorded
};

constexpr TwoPassLines kPassLines{.first = uint8_t(ClusterLine::Draw),
                                  .reduce = uint8_t(ClusterLine::HiddenPart),
                                  .test = uint8_t(ClusterLine::HiddenPart),
                                  .hidden = uint8_t(ClusterLine::HiddenPart),
                                  .draw = uint8_t(ClusterLine::Draw),
                                  .again = uint8_t(ClusterLine::HiddenPart),
                                  .next = uint8_t(ClusterLine::HiddenPart)};
/// Near clusters first, as many rounds as two: what comes into sight hides the rest (docs/methods/occlusion.md).
constexpr size_t kRoundsOfClusters = 2;

class ClusterFrame {
public:
    ClusterFrame(FrameContext& frame, const ClusterScene& structure, const ClusterOptions& options)
        : m_frame(frame), m_structure(structure), m_options(options), m_cover(frame.view()) {}

    void run(ClusterMemory& memory) {
        const std::vector<KeptObject> kept = m_options.occlusion ? keepUnhidden(memory) : keep(memory);
        std::vector<WalkedObject> decided(kept.size());
        m_tests = kept.size() <= kMostWithTests;
        if (m_frame.recording() && !m_tests) sayResultsAlone(m_frame);
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("clusters"));
            const auto decideOne = [&](size_t i) { decided[i] = decideAbout(kept[i]); };
            if (kept.size() < kObjectsForThreads)
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
                 counters().culledTriangles[size_t(Cause::Hidden)]},
                {CULLSCOPE_TR("triangles one by one"), 0, 0}};
            if (m_frame.recording()) m_frame.countPlacesIn(m_structure.clusters.order);
            for (const WalkedObject& object : decided) {
                submit(object, list);
                if (object.record) object.record->sayTo(m_frame);
            }
        }
        if (m_options.pyramid)
            drawUnhidden(decided, memory.last);
        else
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
        memory.buffer->settle();
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
        const bool nothing = m_options.pyramid ? false : root.leaf() ? !cones || !root.hasCone() : object.planes == 0 && !cones;
        if (nothing && m_buffer == nullptr && !m_options.samples) {
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
        PartTests tests{object.planes, cones, hiding ? &*hiding : nullptr, kPartLines};
        if (m_options.pyramid) tests.leaves = &result.leaves;
        result.walk = walkParts(SurfaceNodes(tree.nodes()), seen, tests, result.record ? &*result.record : nullptr);
        if (m_options.samples && !m_options.pyramid)
            result.sampled = leaveOutTriangles(m_frame, m_cover, object.instance, cornersOf(object.instance), result.walk.drawn);
        if (result.record && !m_options.pyramid) sayEnd(result, tree.mesh().triangleCount(), *result.record);
        return result;
    }

    [[nodiscard]] const CornerBlocks& cornersOf(uint32_t instance) const {
        return m_structure.corners[scene().instances()[instance].mesh];
    }

    /// Draws the clusters that no test has left out, but for those that are hidden by the others.
    void drawUnhidden(const std::vector<WalkedObject>& objects, LastVisible& last) {
        DrawnParts parts(m_frame.view());
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("boxes of clusters"));
            for (const WalkedObject& object : objects) addClusters(object, parts);
        }
        const StageTimer stage(m_frame, CULLSCOPE_TR("walk and pyramid"));
        const TwoPassOptions options{.rounds = kRoundsOfClusters,
                                     .lines = kPassLines,
                                     .like = {m_frame.facing(), {}, m_structure.clusters.order},
                                     .tests = m_tests};
        const TwoPassCounters counted = drawInTwoPasses(m_frame, parts, options, last);
        counters().workBytes = counted.pyramids > 0 ? pyramidBytes(m_frame.view().viewport()) : 0;
        counters().figures = {{"first_clusters", double(counted.first)},
                              {"tested_clusters", double(counted.tested)},
                              {"pyramids", double(counted.pyramids)}};
        if (m_frame.recording()) sayEnds(objects, counted.hidden);
    }

    void addClusters(const WalkedObject& object, DrawnParts& parts) const {
        const ClusterTree& tree = m_structure.clusters.of(scene(), object.instance);
        const EyeFromLocal fromEye = eyeFromLocal(scene(), object.instance, tree.sphere(), Mat3(1.0), m_frame.view().eye());
        Mat3 spread(0.0);
        for (int column = 0; column < 3; ++column) spread[column] = glm::abs(fromEye.linear[column]);
        for (const uint32_t leaf : object.leaves) {
            const SurfaceNode& node = tree.nodes()[leaf];
            DrawnParts::Part& part = parts.add(uint64_t(object.instance) << 32 | leaf, Subject::ofCell(leaf, object.instance),
                                               {object.instance, 3 * node.first, 3 * node.count});
            part.places = {node.first, node.count};
            part.nesting = uint8_t(std::min<uint32_t>(node.level + 1u, 255u));
            const Vec3 low(node.low), high(node.high);
            // A picture's float rounding displaces what the box holds.
            const EyeBox box{fromEye.linear * (0.5 * (low + high)) + fromEye.centre,
                             spread * (0.5 * (high - low)) + Vec3(fromEye.rounding)};
            parts.addBox(grownBox(box, fromEye.margin, m_frame.view()));
        }
    }

    /// What became of the objects, by what became of their clusters.
    void sayEnds(const std::vector<WalkedObject>& objects, const std::vector<const DrawnParts::Part*>& hidden) {
        std::map<uint32_t, uint64_t> hiddenOf;
        for (const DrawnParts::Part* part : hidden) hiddenOf[part->range.instance] += part->places.count;
        for (const WalkedObject& object : objects) {
            const ClusterTree& tree = m_structure.clusters.of(scene(), object.instance);
            PartWalk walk = object.walk;
            for (const uint32_t leaf : object.leaves) walk.drawn.push_back({tree.nodes()[leaf].first, tree.nodes()[leaf].count});
            ObjectRecord record(object.instance, m_tests);
            sayEnd(walk, hiddenOf[object.instance], tree.mesh().triangleCount(), record);
            record.sayTo(m_frame);
        }
    }

    static void sayEnd(const WalkedObject& object, uint64_t triangles, ObjectRecord& record) {
        if (!object.sampled) return sayEnd(object.walk, 0, triangles, record);
        sayLeftOut(*object.sampled, object.walk.drawn, uint8_t(ClusterLine::Triangles), record);
        PartWalk walk = object.walk;
        walk.drawn = object.sampled->kept;
        addLeftOut(*object.sampled, walk.culled);
        sayEnd(walk, 0, triangles, record);
    }
    /// What became of an object of so many triangles, of which `hidden` are left out besides.
    static void sayEnd(PartWalk walk, uint64_t hidden, uint64_t triangles, ObjectRecord& record) {
        walk.culled[size_t(Cause::Hidden)] += hidden;
        const uint64_t drawn = triangleCount(walk.drawn) - hidden;
        const auto outcome = drawn == triangles ? Decision::Outcome::Drawn
                             : drawn > 0        ? Decision::Outcome::PartlyDrawn
                                                : Decision::Outcome::Culled;
        record.say(atLine(ClusterLine::Objects, ending(record.subject(), outcome, mainCause(walk.culled))));
    }

    void submit(const WalkedObject& object, DrawList& list) {
        if (object.whole) {
            list.ranges.push_back({object.instance, 0, uint32_t(3 * scene().meshOf(object.instance).triangleCount())});
            return;
        }
        const PartWalk& walk = object.walk;
        for (const PlaceRun& run : object.sampled ? object.sampled->kept : walk.drawn)
            list.ranges.push_back({object.instance, 3 * run.first, 3 * run.count});
        for (size_t cause = 0; cause < kCauseCount; ++cause) counters().culledTriangles[cause] += walk.culled[cause];
        std::vector<CullPart>& parts = counters().parts;
        if (object.sampled) {
            addLeftOut(*object.sampled, counters().culledTriangles);
            ++parts[3].objects;
            parts[3].culledTriangles += object.sampled->facingAway + object.sampled->withoutSample;
        }
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
    PixelCover m_cover;
    const OcclusionBuffer* m_buffer = nullptr;  ///< null: nothing hides
    bool m_tests = false;                       ///< whether a record holds tests
};

}  // namespace

void drawClusters(FrameContext& frame, const ClusterScene& structure, ClusterMemory& memory, const ClusterOptions& options) {
    ClusterFrame(frame, structure, options).run(memory);
}

}  // namespace cullscope::occlusion
