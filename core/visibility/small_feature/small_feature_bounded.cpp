#include "core/visibility/small_feature/small_feature_bounded.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/pixel_cover.h"
#include "core/visibility/small_feature/sampled_triangles.h"

namespace cullscope::small_feature {
namespace {

constexpr const char* kPixels = "pixels";
constexpr const char* kTriangles = "triangles";
/// The largest number of components in a group.
constexpr uint32_t kGroupComponents = 8;

/// The lines of the listing (boundedListing).
enum class BoundedLine : uint8_t { Planes = 1, Outside, Group, GroupOut, Component, NoSample, Sum, Out, Triangles, Draw };

constexpr OctreeWalkLines kBoundedLines{.groupPlanes = uint8_t(BoundedLine::Planes),
                                        .groupAxes = uint8_t(BoundedLine::Planes),
                                        .groupOutside = uint8_t(BoundedLine::Outside),
                                        .groupInside = uint8_t(BoundedLine::Draw),
                                        .objectTests = uint8_t(BoundedLine::Planes),
                                        .objectOutside = uint8_t(BoundedLine::Outside)};

struct ComponentGroups : Structure {
    using Structure::Structure;
    InstanceOctree octree;
    std::vector<uint32_t> leafOf;  ///< by instance: its leaf's node
};

struct BoundedMemory : ViewState {
    LastFailedPlanes planes;

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<BoundedMemory>(*this); }
};

/// A component that the frustum keeps.
struct Candidate {
    KeptObject object;
    uint64_t pixels = 0;  ///< at most so many pixel centres are covered by it
};

/// One frame.
class BoundedFrame {
public:
    BoundedFrame(FrameContext& frame, const ComponentGroups& groups, BoundedMemory& memory, const ParameterSet& parameters)
        : m_frame(frame),
          m_groups(groups),
          m_memory(memory),
          m_pixels(uint64_t(parameters.integer(kPixels))),
          m_triangles(parameters.boolean(kTriangles)),
          m_cover(frame.view()) {}

    [[nodiscard]] DrawList listed() {
        std::vector<KeptObject> kept;
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("groups of objects"));
            OctreeWalkOptions options{.refine = true, .memory = &m_memory.planes, .lines = kBoundedLines, .visited = {}};
            options.visited = [this](uint32_t node, uint32_t /*planes*/) { return !leavesOutGroup(node); };
            kept = keptObjects(m_groups.octree, m_frame, &m_walked, options);
        }
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("components"));
            leaveOutComponents(kept);
        }
        DrawList list{m_frame.facing(), {}};
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("draw list"));
            sortNearestFirst(m_drawn, scene(), m_frame.view().eye());
            if (!m_triangles)
                for (const KeptObject& object : m_drawn)
                    list.ranges.push_back({object.instance, 0, uint32_t(scene().meshOf(object.instance).indices().size())});
        }
        if (m_triangles) {
            const StageTimer stage(m_frame, CULLSCOPE_TR("triangles"));
            appendSampled(list.ranges);
        }
        count();
        return list;
    }

private:
    [[nodiscard]] const Scene& scene() const { return m_frame.scene(); }

    /// Whether a box might cover so few pixels that its corners are worth a look: a diagonal of more pixels than the most that
    /// may be lost covers too many, unless it is seen along that diagonal.
    [[nodiscard]] bool mayBeSmall(const EyeBox& box) const {
        const double ahead = glm::dot(m_frame.view().frustum().forward, box.centre);
        const double edge = std::max({box.halfExtent.x, box.halfExtent.y, box.halfExtent.z});
        return ahead > 0.0 && edge * m_cover.pixelsPerUnit(ahead) <= 4.0 * (double(m_pixels) + 1.0);
    }

    /// Whether a group is left out as a whole, because its box covers no more pixels than may be lost.
    [[nodiscard]] bool leavesOutGroup(uint32_t number) {
        const InstanceOctree::Node& node = m_groups.octree.nodes()[number];
        const EyeBox box = relativeToEye(node.box, m_frame.view().eye());
        if (!mayBeSmall(box)) return false;
        const uint64_t covered = m_cover.of(box);
        const bool leaves = covered <= m_pixels;
        const Subject subject = Subject::ofNode(number);
        if (m_frame.recording()) {
            Decision test = coverTest(subject, leaves, covered);
            test.sentence = leaves ? CULLSCOPE_TR("Its box covers at most %1 pixels, no more than the %2 that may be lost.")
                                   : CULLSCOPE_TR("Its box covers up to %1 pixels, more than the %2 that may be lost.");
            test.nesting = node.depth;
            m_frame.say(atLine(BoundedLine::Group, test));
        }
        if (!leaves) return false;
        const Cause cause = covered == 0 ? Cause::NoSample : Cause::TooSmall;
        leaveOut(cause, node.triangles, covered);
        if (m_frame.recording()) {
            Decision end = ending(subject, Decision::Outcome::Culled, cause);
            end.nesting = node.depth;
            m_frame.say(atLine(BoundedLine::GroupOut, end), m_groups.octree.instancesOf(node));
        }
        return true;
    }

    /// Of components in the octree's order: leaves out those without a pixel centre, and the small ones of a leaf where all of
    /// these cover no more pixels than may be lost.
    void leaveOutComponents(const std::vector<KeptObject>& kept) {
        std::vector<Candidate> small;
        for (size_t begin = 0, end = 0; begin < kept.size(); begin = end) {
            const uint32_t leaf = m_groups.leafOf[kept[begin].instance];
            small.clear();
            uint64_t together = 0;
            for (; end < kept.size() && m_groups.leafOf[kept[end].instance] == leaf; ++end) {
                const uint64_t covered = coveredBy(kept[end].instance);
                if (covered > m_pixels) {
                    keep(kept[end]);
                } else if (covered == 0) {
                    leaveOut(Cause::NoSample, scene().meshOf(kept[end].instance).triangleCount(), 0);
                    if (m_frame.recording())
                        sayEnd(kept[end].instance, BoundedLine::NoSample, Decision::Outcome::Culled, Cause::NoSample);
                } else {
                    small.push_back({kept[end], covered});
                    together += covered;
                }
            }
            leaveOutTogether(small, together);
        }
    }

    void leaveOutTogether(std::span<const Candidate> small, uint64_t together) {
        for (const Candidate& candidate : small) {
            const bool leaves = together <= m_pixels;
            if (m_frame.recording()) {
                Decision test = coverTest(Subject::ofObject(candidate.object.instance), leaves, together);
                test.sentence = leaves ? CULLSCOPE_TR(
                                             "With the small components of its group it covers at most %1 pixels, no more "
                                             "than the %2 that may be lost.")
                                       : CULLSCOPE_TR(
                                             "With the small components of its group it covers up to %1 pixels, more than "
                                             "the %2 that may be lost.");
                m_frame.say(atLine(BoundedLine::Sum, test));
            }
            if (!leaves) {
                keep(candidate.object);
                continue;
            }
            leaveOut(Cause::TooSmall, scene().meshOf(candidate.object.instance).triangleCount(), candidate.pixels);
            if (m_frame.recording())
                sayEnd(candidate.object.instance, BoundedLine::Out, Decision::Outcome::Culled, Cause::TooSmall);
        }
    }

    /// At most so many pixel centres are covered by a component; more than may be lost where that is plain without its corners.
    [[nodiscard]] uint64_t coveredBy(uint32_t instance) {
        const EyeBox box = relativeToEye(scene().instanceBox(instance), m_frame.view().eye());
        if (!mayBeSmall(box)) return m_pixels + 1;
        ++m_projected;
        const uint64_t covered = m_cover.of(box);
        if (m_frame.recording()) {
            Decision test = coverTest(Subject::ofObject(instance), covered == 0, covered);
            test.sentence = CULLSCOPE_TR("Its box covers at most %1 pixels; %2 may be lost of a group.");
            m_frame.say(atLine(BoundedLine::Component, test));
        }
        return covered;
    }

    void keep(const KeptObject& object) {
        m_drawn.push_back(object);
        if (m_frame.recording() && !m_triangles)
            sayEnd(object.instance, BoundedLine::Draw, Decision::Outcome::Drawn, Cause::TooSmall);
    }

    /// Appends the ranges of the components that are drawn, without their triangles that hold no pixel centre.
    void appendSampled(std::vector<DrawRange>& ranges) {
        const std::vector<uint64_t> left = SampledTriangles(scene(), m_frame.view(), m_cover).appendAll(m_drawn, ranges);
        for (size_t i = 0; i < left.size(); ++i) {
            m_frame.counters().culledTriangles[size_t(Cause::NoSample)] += left[i];
            if (m_frame.recording()) sayTriangles(m_drawn[i].instance, left[i]);
        }
    }

    void sayTriangles(uint32_t instance, uint64_t left) {
        const uint64_t count = scene().meshOf(instance).triangleCount();
        Decision test = coverTest(Subject::ofObject(instance), false, 0);
        test.containment = left == 0 ? Containment::Inside : left == count ? Containment::Outside : Containment::Straddles;
        test.sentence = CULLSCOPE_TR("Of %1 triangles %2 hold no pixel centre.");
        test.operands = {double(count), double(left)};
        m_frame.say(atLine(BoundedLine::Triangles, test));
        using Outcome = Decision::Outcome;
        const Outcome outcome = left == 0 ? Outcome::Drawn : left == count ? Outcome::Culled : Outcome::PartlyDrawn;
        sayEnd(instance, BoundedLine::Draw, outcome, Cause::NoSample);
    }

    void leaveOut(Cause cause, uint64_t triangles, uint64_t pixels) {
        m_frame.counters().culledTriangles[size_t(cause)] += triangles;
        m_lost += pixels;
    }

    [[nodiscard]] Decision coverTest(const Subject& subject, bool leaves, uint64_t covered) const {
        Decision test;
        test.subject = subject;
        test.cause = covered == 0 ? Cause::NoSample : Cause::TooSmall;
        test.containment = leaves ? Containment::Outside : Containment::Straddles;
        test.operands = {double(covered), double(m_pixels)};
        test.operandCount = 2;
        return test;
    }

    void sayEnd(uint32_t instance, BoundedLine line, Decision::Outcome outcome, Cause cause) {
        m_frame.say(atLine(line, ending(Subject::ofObject(instance), outcome, cause)));
    }

    void count() {
        FrameCounters& counted = m_frame.counters();
        counted.culledTriangles[size_t(Cause::OutsideFrustum)] = m_walked.trianglesCulled;
        counted.nodesVisited = m_walked.nodesVisited + m_walked.objectsTested + m_projected;
        counted.bytesTouched =
            m_walked.nodesVisited * sizeof(InstanceOctree::Node) + (m_walked.objectsTested + m_projected) * sizeof(Box3);
        counted.figures.push_back({"plane_tests", double(m_walked.planesTested)});
        counted.figures.push_back({"components_projected", double(m_projected)});
        counted.figures.push_back({"lost_pixels_at_most", double(m_lost)});
    }

    FrameContext& m_frame;
    const ComponentGroups& m_groups;
    BoundedMemory& m_memory;
    uint64_t m_pixels;
    bool m_triangles;
    PixelCover m_cover;
    OctreeWalkCounters m_walked;
    std::vector<KeptObject> m_drawn;
    uint64_t m_projected = 0, m_lost = 0;
};

class SmallFeatureBounded final : public StrategyWith<ComponentGroups, BoundedMemory> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& structure) const override {
        auto memory = std::make_unique<BoundedMemory>();
        memory->planes = LastFailedPlanes(own(structure).octree.nodes().size(), structure.scene().instances().size());
        return memory;
    }

protected:
    void fill(ComponentGroups& groups, const ParameterSet& /*parameters*/, const Progress& progress) const override {
        const Scene& scene = groups.scene();
        groups.octree = InstanceOctree(scene, kGroupComponents);
        progress.check();
        groups.leafOf.assign(scene.instances().size(), 0);
        size_t leaves = 0;
        for (uint32_t number = 0; number < groups.octree.nodes().size(); ++number) {
            const InstanceOctree::Node& node = groups.octree.nodes()[number];
            if (!node.leaf()) continue;
            ++leaves;
            for (const uint32_t instance : groups.octree.instancesOf(node)) groups.leafOf[instance] = number;
        }
        groups.report.bytes = groups.octree.bytes() + groups.leafOf.size() * sizeof(uint32_t);
        groups.report.figures = {{"components", double(groups.octree.order().size())},
                                 {"nodes", double(groups.octree.nodes().size())},
                                 {"leaves", double(leaves)}};
    }

    void decide(FrameContext& frame, const ComponentGroups& groups, BoundedMemory& memory,
                const ParameterSet& parameters) const override {
        frame.draw(BoundedFrame(frame, groups, memory, parameters).listed());
    }

    [[nodiscard]] Promise promiseOf(const ComponentGroups& /*groups*/, const ParameterSet& parameters,
                                    Facing /*facing*/) const override {
        return parameters.integer(kPixels) == 0 ? Promise::Conservative : Promise::Approximate;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const ComponentGroups& groups, const FrameLog& log) const override {
        StructureSnapshot result = objectNodes(log, groups.scene());
        addGroups(result, groups.octree, groups.scene(), log);
        result.objectSentence =
            CULLSCOPE_TR("Of the component \"%1\" with %2 triangles the pixels that its box covers are counted.");
        result.groupSentence =
            CULLSCOPE_TR("It lies in a group of %1 components, which covers too many pixels to be left out as a whole.");
        return result;
    }
    [[nodiscard]] std::string frameLine(const Structure& /*structure*/, const FrameLog& log) const override {
        for (const NamedFigure& figure : log.counters.figures)
            if (figure.name == "lost_pixels_at_most")
                return "may have lost at most " + std::to_string(uint64_t(figure.value)) + " pixels";
        return {};
    }
};

Show boundedListing() {
    return listingShow({{CULLSCOPE_TR("for each group: planes and axes"), 0},
                        {CULLSCOPE_TR("outside: leave all its objects out"), 1},
                        {CULLSCOPE_TR("n = pixels that its box covers"), 1},
                        {CULLSCOPE_TR("if n ≤ pixels: leave the group out"), 2},
                        {CULLSCOPE_TR("for each component: n of its box"), 1},
                        {CULLSCOPE_TR("if n = 0: leave it out"), 2},
                        {CULLSCOPE_TR("if n ≤ pixels: it is a small one"), 2},
                        {CULLSCOPE_TR("small ones' sum ≤ pixels: leave out"), 1},
                        {CULLSCOPE_TR("leave out triangles without a centre"), 1},
                        {CULLSCOPE_TR("draw the others, nearest first"), 0}});
}

}  // namespace

RegisteredStrategy smallFeatureBounded() {
    const auto pixels = bySize({kPixels,
                                ParameterType::Integer,
                                int64_t{1},
                                0.0,
                                1000.0,
                                "px",
                                CULLSCOPE_TR("How many pixels a group of components may lose. With 0 nothing visible is lost."),
                                {}},
                               1.0);
    StrategyInfo info{
        "small-feature-bounded",
        CULLSCOPE_TR("Bounded small-feature culling"),
        CULLSCOPE_TR("Leaves out small components where the pixels that a group may lose by it stay under a bound."),
        "Cullscope, after Du et al. 2017",
        {facingParameter(), pixels,
         booleanParameter(kTriangles, true,
                          CULLSCOPE_TR("Whether triangles without a pixel centre are left out of components that are drawn. "
                                       "It loses nothing."))}};
    info.sweeps = {{kPixels, {"0", "1", "2", "4", "8", "16"}}};
    info.shows = {boundedListing(), treeShow()};
    return {std::move(info), std::make_shared<SmallFeatureBounded>()};
}

}  // namespace cullscope::small_feature
