#include "core/visibility/small_feature/small_feature.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/message.h"
#include "core/spatial/occupancy.h"
#include "core/spatial/regular_octree.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/small_feature/frame_budget.h"
#include "core/visibility/small_feature/occupancy_bars.h"
#include "core/visibility/small_feature/outline_overlay.h"
#include "core/visibility/small_feature/small_feature_parameters.h"

namespace cullscope::small_feature {
namespace {

/// Where a held frame time begins with a threshold of 0, which no factor raises.
constexpr double kLeastHeldThreshold = 1e-4;

constexpr OctreeWalkLines kFeatureLines{.groupPlanes = uint8_t(FeatureLine::Planes),
                                        .groupAxes = uint8_t(FeatureLine::Planes),
                                        .groupOutside = uint8_t(FeatureLine::Outside),
                                        .groupInside = uint8_t(FeatureLine::Draw),
                                        .objectTests = uint8_t(FeatureLine::Planes),
                                        .objectOutside = uint8_t(FeatureLine::Outside)};

/// Both octrees and the values of their components.
struct FeatureTrees : Structure {
    using Structure::Structure;

    RegularOctree large, small;
    std::vector<double> values;                        ///< by instance
    std::vector<double> sorted;                        ///< those of the components, the largest first
    std::vector<double> largestInLarge, largestBelow;  ///< by node of octree L and S: the largest value of its components
    double split = 0.0;                                ///< components with a larger value are in octree L

    /// The value that divides where so many percent of the components are the outline.
    [[nodiscard]] double splitAt(double percent) const {
        const auto place = size_t(double(sorted.size()) * percent / 100.0);
        return place < sorted.size() ? sorted[place] : -1.0;
    }
    /// Octree L numbers its nodes from 0, octree S behind it. `cells`: the cells are tested, not the boxes around the components.
    [[nodiscard]] GroupTree largeTree(bool cells) const {
        GroupTree tree(large.nodes(), large.order());
        tree.name = "L";
        if (cells) tree.boxes = large.cells();
        return tree;
    }
    [[nodiscard]] GroupTree smallTree(bool cells) const {
        GroupTree tree(small.nodes(), small.order());
        tree.firstNumber = uint32_t(large.nodes().size());
        tree.name = "S";
        if (cells) tree.boxes = small.cells();
        return tree;
    }
};

/// What the view was in the frame before.
struct LastFrame : ViewState {
    std::optional<Camera> camera;
    Viewport size;
    FrameBudget budget;  ///< with hold-fps
    bool whole = false;  ///< everything was drawn: its time says nothing of the culling

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<LastFrame>(*this); }
};

/// What divides outline and details in a frame, and what is too small.
struct InForce {
    double threshold = 0.0, outline = 0.0, split = 0.0;
    bool held = false;  ///< by hold-fps: `split` is not that of the octrees, which then decide by whole leaves
};

InForce inForce(const FeatureTrees& trees, const LastFrame& last, const ParameterSet& parameters) {
    InForce result{parameters.real(kThreshold), parameters.real(kOutline), trees.split, parameters.real(kHoldFps) > 0.0};
    if (!result.held) return result;
    const double factor = std::exp2(last.budget.doublings());
    result.threshold = std::min(1.0, factor * std::max(result.threshold, kLeastHeldThreshold));
    result.outline = std::min(100.0, result.outline / factor);
    result.split = trees.splitAt(result.outline);
    return result;
}

/// A leaf that is drawn.
struct KeptLeaf {
    double distance = 0.0;
    const RegularOctree* octree = nullptr;
    uint32_t node = 0;
};

/// One frame.
class FeatureFrame {
public:
    FeatureFrame(FrameContext& frame, const FeatureTrees& trees, const InForce& force, bool cells, bool whole)
        : m_frame(frame), m_trees(trees), m_force(force), m_cells(cells), m_whole(whole) {}

    [[nodiscard]] DrawList listed() {
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("octrees"));
            walk(m_trees.large, m_trees.largeTree(m_cells), m_trees.largestInLarge, false);
            walk(m_trees.small, m_trees.smallTree(m_cells), m_trees.largestBelow, true);
        }
        const StageTimer stage(m_frame, CULLSCOPE_TR("draw list"));
        std::ranges::stable_sort(m_kept, {}, &KeptLeaf::distance);
        DrawList list{m_frame.facing(), {}};
        for (const KeptLeaf& leaf : m_kept)
            for (const uint32_t instance : leaf.octree->instancesOf(leaf.octree->nodes()[leaf.node]))
                list.ranges.push_back({instance, 0, uint32_t(m_frame.scene().meshOf(instance).indices().size())});
        FrameCounters& counted = m_frame.counters();
        counted.culledTriangles[size_t(Cause::OutsideFrustum)] = m_walked.trianglesCulled;
        counted.culledTriangles[size_t(Cause::TooSmall)] = m_tooSmall;
        counted.nodesVisited = m_walked.nodesVisited;
        counted.bytesTouched = m_walked.nodesVisited * (sizeof(RegularOctree::Node) + sizeof(double));
        counted.figures.push_back({"plane_tests", double(m_walked.planesTested)});
        counted.figures.push_back({"leaves_visible", double(m_kept.size() + m_leavesTooSmall)});
        counted.figures.push_back({"leaves_too_small", double(m_leavesTooSmall)});
        if (m_force.held) {
            counted.figures.push_back({"threshold_in_force", m_force.threshold});
            counted.figures.push_back({"outline_in_force_percent", m_force.outline});
            counted.held = {{kThreshold, m_force.threshold, ""}, {kOutline, m_force.outline, "%"}};
        }
        return list;
    }

private:
    /// `largest`: by node. `details`: leaves are left out by their size, where hold-fps says no other.
    void walk(const RegularOctree& octree, const GroupTree& tree, const std::vector<double>& largest, bool details) {
        OctreeWalkOptions options{.lines = kFeatureLines};
        options.visited = [&](uint32_t number, uint32_t /*planes*/) {
            const RegularOctree::Node& node = octree.nodes()[number];
            if (!node.leaf()) return true;
            const double distance = glm::length(tree.boxOf(number).centre() - m_frame.view().eye());
            const bool measured = !m_whole && (m_force.held ? largest[number] <= m_force.split : details);
            const Subject subject = Subject::ofNode(tree.firstNumber + number);
            // The paper's comparison (Algorithm 4, step 3): what is no number, as beside an infinite box, is drawn.
            const bool tooSmall = measured && m_force.threshold > largest[number] / distance;
            if (measured && m_frame.recording()) sayTest(subject, node.depth, largest[number], distance, tooSmall);
            if (tooSmall) {
                m_tooSmall += node.triangles;
                ++m_leavesTooSmall;
            } else {
                m_kept.push_back({distance, &octree, number});
            }
            if (m_frame.recording()) sayEnd(subject, node.depth, octree.instancesOf(node), tooSmall, measured);
            return false;
        };
        (void)keptObjects(tree, m_frame, &m_walked, options);
    }

    void sayTest(const Subject& subject, uint8_t depth, double value, double distance, bool tooSmall) {
        Decision test;
        test.subject = subject;
        test.cause = Cause::TooSmall;
        test.containment = tooSmall ? Containment::Outside : Containment::Inside;
        test.nesting = depth;
        test.sentence = tooSmall ? CULLSCOPE_TR("Largest value %1 ÷ distance %2 = %3 < %4: its components count as too small.")
                                 : CULLSCOPE_TR("Largest value %1 ÷ distance %2 = %3 ≥ %4: its components are drawn.");
        test.operands = {value, distance, value / distance, m_force.threshold};
        test.operandCount = 4;
        m_frame.say(atLine(FeatureLine::Value, test));
    }

    void sayEnd(const Subject& subject, uint8_t depth, std::span<const uint32_t> instances, bool tooSmall, bool measured) {
        Decision end =
            tooSmall ? ending(subject, Decision::Outcome::Culled, Cause::TooSmall) : ending(subject, Decision::Outcome::Drawn);
        end.nesting = depth;
        const FeatureLine drawn = measured ? FeatureLine::Draw : FeatureLine::Large;
        m_frame.say(atLine(tooSmall ? FeatureLine::TooSmall : drawn, end), instances);
    }

    FrameContext& m_frame;
    const FeatureTrees& m_trees;
    InForce m_force;
    bool m_cells, m_whole;
    std::vector<KeptLeaf> m_kept;
    OctreeWalkCounters m_walked;
    uint64_t m_tooSmall = 0, m_leavesTooSmall = 0;
};

class SmallFeature final : public StrategyWith<FeatureTrees, LastFrame> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<LastFrame>(); }
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& structure, const FrameLog& log) const override {
        return occupancyBars(own(structure).values, own(structure).split, structure.scene(), log);
    }
    [[nodiscard]] std::vector<OverlayLines> overlay(std::string_view id, const OverlayContext& context,
                                                    const Structure& structure, const FrameLog& log) const override {
        if (id != kOutlineShow) return {};
        return outlineOverlay(context, log, own(structure).smallTree(false));
    }

protected:
    void fill(FeatureTrees& trees, const ParameterSet& parameters, const Progress& progress) const override {
        const Scene& scene = trees.scene();
        trees.values = occupancyValues(scene);
        progress.check();
        std::vector<uint32_t> components;
        for (uint32_t i = 0; i < scene.instances().size(); ++i)
            if (scene.meshOf(i).triangleCount() > 0) components.push_back(i);
        // Algorithm 2: sorted by value, the largest first; the value at x % of them divides.
        std::ranges::stable_sort(components, std::greater<>(), [&](uint32_t i) { return trees.values[i]; });
        for (const uint32_t i : components) trees.sorted.push_back(trees.values[i]);
        trees.split = trees.splitAt(parameters.real(kOutline));
        progress.check();
        const auto end = std::ranges::partition_point(components, [&](uint32_t i) { return trees.values[i] > trees.split; });
        const auto large = size_t(end - components.begin());
        trees.large = RegularOctree(scene, std::span(components).first(large), int(parameters.integer(kOutlineLevels)));
        progress.check();
        trees.small = RegularOctree(scene, std::span(components).subspan(large), int(parameters.integer(kDetailLevels)));
        trees.largestInLarge = largestIn(trees.large, trees.values);
        trees.largestBelow = largestIn(trees.small, trees.values);
        trees.report.bytes =
            trees.large.bytes() + trees.small.bytes() +
            (trees.values.size() + trees.sorted.size() + trees.largestInLarge.size() + trees.largestBelow.size()) *
                sizeof(double);
        trees.report.figures = {{"components", double(components.size())},
                                {"components of the outline", double(large)},
                                {"leaves of octree L", double(leaves(trees.large))},
                                {"leaves of octree S", double(leaves(trees.small))}};
    }

    void decide(FrameContext& frame, const FeatureTrees& trees, LastFrame& last, const ParameterSet& parameters) const override {
        const bool resting = last.camera == frame.view().camera() && last.size == frame.view().viewport();
        last.camera = frame.view().camera();
        last.size = frame.view().viewport();
        const bool whole = parameters.choice("at-rest") == "whole" && resting;
        const double fps = parameters.real(kHoldFps);
        const std::optional<double> took = frame.frameBeforeMilliseconds();
        if (fps > 0.0 && took && !last.whole) last.budget.follow(*took, 1000.0 / fps, resting);
        last.whole = whole;
        last.unsteady = fps > 0.0 && !whole && !(resting && last.budget.steady());
        const InForce force = inForce(trees, last, parameters);
        sayBegin(frame, uint8_t(FeatureLine::Trees),
                 whole ? CULLSCOPE_TR("The camera rests: %1 components of the outline and %2 others, none of them too small.")
                       : CULLSCOPE_TR("%1 components of the outline are in octree L, %2 others in octree S."),
                 {double(trees.large.order().size()), double(trees.small.order().size())});
        if (force.held && took)
            sayBegin(frame, uint8_t(FeatureLine::Trees),
                     CULLSCOPE_TR("The frame before took %1 of %2 ms: now the threshold is %3 and the outline %4 %."),
                     {*took, 1000.0 / fps, force.threshold, force.outline});
        frame.draw(FeatureFrame(frame, trees, force, parameters.choice("boxes") == "cells", whole).listed());
    }

    [[nodiscard]] Promise promiseOf(const FeatureTrees& /*trees*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }
    [[nodiscard]] StructureSnapshot snapshotOf(const FeatureTrees& trees, const FrameLog& log) const override {
        StructureSnapshot result = objectNodes(log, trees.scene());
        addGroups(result, trees.largeTree(false), trees.scene(), log);
        addGroups(result, trees.smallTree(false), trees.scene(), log);
        result.objectSentence = CULLSCOPE_TR("The component \"%1\" has %2 triangles; it is drawn with its leaf or not at all.");
        result.groupSentence = CULLSCOPE_TR("It lies in a leaf of %1 components, which is drawn as a whole.");
        result.groupName = CULLSCOPE_TR("Octree %1: %2 components");
        return result;
    }

private:
    /// The largest value of the components below each node.
    [[nodiscard]] static std::vector<double> largestIn(const RegularOctree& octree, const std::vector<double>& values) {
        std::vector<double> result(octree.nodes().size(), 0.0);
        for (size_t number = result.size(); number-- > 0;) {
            const RegularOctree::Node& node = octree.nodes()[number];
            double& largest = result[number];
            if (node.leaf())
                for (const uint32_t instance : octree.instancesOf(node)) largest = std::max(largest, values[instance]);
            for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child)
                largest = std::max(largest, result[child]);
        }
        return result;
    }
    [[nodiscard]] static size_t leaves(const RegularOctree& octree) {
        return size_t(std::ranges::count_if(octree.nodes(), &RegularOctree::Node::leaf));
    }
};

}  // namespace

RegisteredStrategy smallFeature() {
    StrategyInfo info{
        "small-feature", CULLSCOPE_TR("Small-feature culling"),
        CULLSCOPE_TR("Leaves out groups of components that are too small for their distance; a plant's outline stays."),
        "Du et al. 2017", featureParameters()};
    info.remembers = true;
    info.needsEyePoint = true;
    info.sweeps = {{kThreshold, {"0", "0.0005", "0.001", "0.002", "0.004", "0.008"}},
                   {kOutline, {"0", "10", "20", "30", "40", "60"}}};
    info.shows = {outlineShow(), featureListing(), treeShow(), occupancyBarsShow()};
    return {std::move(info), std::make_shared<SmallFeature>()};
}

}  // namespace cullscope::small_feature
