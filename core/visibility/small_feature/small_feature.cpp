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
#include "core/visibility/small_feature/occupancy_bars.h"

namespace cullscope::small_feature {
namespace {

constexpr const char* kOutline = "outline";
constexpr const char* kThreshold = "threshold";
constexpr const char* kOutlineLevels = "outline-levels";
constexpr const char* kDetailLevels = "detail-levels";

/// The lines of the listing (featureListing).
enum class FeatureLine : uint8_t { Trees = 1, Planes, Outside, Large, Value, TooSmall, Draw };

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
    std::vector<double> values;        ///< by instance
    std::vector<double> largestBelow;  ///< by node of octree S: the largest value of its components
    double split = 0.0;                ///< components with a larger value are in octree L

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

/// Where the view's camera was in the frame before.
struct LastCamera : ViewState {
    std::optional<Camera> camera;

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<LastCamera>(*this); }
};

/// A leaf that is drawn.
struct KeptLeaf {
    double distance = 0.0;
    const RegularOctree* octree = nullptr;
    uint32_t node = 0;
};

/// One frame.
class FeatureFrame {
public:
    FeatureFrame(FrameContext& frame, const FeatureTrees& trees, const ParameterSet& parameters, bool whole)
        : m_frame(frame),
          m_trees(trees),
          m_threshold(parameters.real(kThreshold)),
          m_cells(parameters.choice("boxes") == "cells"),
          m_whole(whole) {}

    [[nodiscard]] DrawList listed() {
        {
            const StageTimer stage(m_frame, CULLSCOPE_TR("octrees"));
            walk(m_trees.large, m_trees.largeTree(m_cells), false);
            walk(m_trees.small, m_trees.smallTree(m_cells), !m_whole);
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
        counted.figures.push_back({"leaves_too_small", double(m_leavesTooSmall)});
        return list;
    }

private:
    /// `measured`: leaves are left out by their size.
    void walk(const RegularOctree& octree, const GroupTree& tree, bool measured) {
        OctreeWalkOptions options{.lines = kFeatureLines};
        options.visited = [&](uint32_t number, uint32_t /*planes*/) {
            const RegularOctree::Node& node = octree.nodes()[number];
            if (!node.leaf()) return true;
            const double distance = glm::length(tree.boxOf(number).centre() - m_frame.view().eye());
            const Subject subject = Subject::ofNode(tree.firstNumber + number);
            // The paper's comparison (Algorithm 4, step 3): what is no number, as beside an infinite box, is drawn.
            const bool tooSmall = measured && m_threshold > m_trees.largestBelow[number] / distance;
            if (measured && m_frame.recording()) sayTest(subject, node.depth, m_trees.largestBelow[number], distance, tooSmall);
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
        test.operands = {value, distance, value / distance, m_threshold};
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
    double m_threshold;
    bool m_cells, m_whole;
    std::vector<KeptLeaf> m_kept;
    OctreeWalkCounters m_walked;
    uint64_t m_tooSmall = 0, m_leavesTooSmall = 0;
};

class SmallFeature final : public StrategyWith<FeatureTrees, LastCamera> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<LastCamera>(); }
    [[nodiscard]] Bars bars(std::string_view /*id*/, const Structure& structure, const FrameLog& log) const override {
        return occupancyBars(own(structure).values, own(structure).split, structure.scene(), log);
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
        const auto place = size_t(double(components.size()) * parameters.real(kOutline) / 100.0);
        trees.split = place < components.size() ? trees.values[components[place]] : -1.0;
        progress.check();
        const auto end = std::ranges::partition_point(components, [&](uint32_t i) { return trees.values[i] > trees.split; });
        const auto large = size_t(end - components.begin());
        trees.large = RegularOctree(scene, std::span(components).first(large), int(parameters.integer(kOutlineLevels)));
        progress.check();
        trees.small = RegularOctree(scene, std::span(components).subspan(large), int(parameters.integer(kDetailLevels)));
        trees.largestBelow.assign(trees.small.nodes().size(), 0.0);
        for (size_t number = trees.small.nodes().size(); number-- > 0;) {
            const RegularOctree::Node& node = trees.small.nodes()[number];
            double& largest = trees.largestBelow[number];
            if (node.leaf())
                for (const uint32_t instance : trees.small.instancesOf(node)) largest = std::max(largest, trees.values[instance]);
            for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child)
                largest = std::max(largest, trees.largestBelow[child]);
        }
        trees.report.bytes =
            trees.large.bytes() + trees.small.bytes() + (trees.values.size() + trees.largestBelow.size()) * sizeof(double);
        trees.report.figures = {{"components", double(components.size())},
                                {"components of the outline", double(large)},
                                {"leaves of octree L", double(leaves(trees.large))},
                                {"leaves of octree S", double(leaves(trees.small))}};
    }

    void decide(FrameContext& frame, const FeatureTrees& trees, LastCamera& last, const ParameterSet& parameters) const override {
        const bool resting = last.camera == frame.view().camera();
        last.camera = frame.view().camera();
        const bool whole = parameters.choice("at-rest") == "whole" && resting;
        if (frame.recording())
            sayBegin(frame, uint8_t(FeatureLine::Trees),
                     whole ? CULLSCOPE_TR("The camera rests: %1 components of the outline and %2 others, none of them too small.")
                           : CULLSCOPE_TR("%1 components of the outline are in octree L, %2 others in octree S."),
                     {double(trees.large.order().size()), double(trees.small.order().size())});
        frame.draw(FeatureFrame(frame, trees, parameters, whole).listed());
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
    [[nodiscard]] static size_t leaves(const RegularOctree& octree) {
        return size_t(std::ranges::count_if(octree.nodes(), &RegularOctree::Node::leaf));
    }
};

Show featureListing() {
    return listingShow({{CULLSCOPE_TR("for each node of octrees L and S"), 0},
                        {CULLSCOPE_TR("test its box against the six planes"), 1},
                        {CULLSCOPE_TR("outside: leave its components out"), 1},
                        {CULLSCOPE_TR("leaf of L: draw its components"), 1},
                        {CULLSCOPE_TR("leaf of S: t = value ÷ distance"), 1},
                        {CULLSCOPE_TR("if t < k′·tan θ: leave it out"), 2},
                        {CULLSCOPE_TR("else draw its components"), 2}});
}

std::vector<ParameterDeclaration> featureParameters() {
    ParameterDeclaration outline{kOutline,
                                 ParameterType::Real,
                                 20.0,
                                 0.0,
                                 100.0,
                                 "%",
                                 CULLSCOPE_TR("How many of the components, the largest ones, are the outline, which is always "
                                              "drawn. The paper names no number."),
                                 {}};
    ParameterDeclaration threshold{kThreshold,
                                   ParameterType::Real,
                                   0.002,
                                   0.0,
                                   1.0,
                                   "",
                                   CULLSCOPE_TR("A leaf is left out where its largest occupancy value, divided by its distance, "
                                                "is below this: k′·tan θ."),
                                   {}};
    const auto levels = [](const char* key, const char* description) {
        return readWhenBuilding(
            {key, ParameterType::Integer, int64_t{4}, 1.0, double(RegularOctree::kMostLevels), "", description, {}});
    };
    return {facingParameter(),
            readWhenBuilding(outline),
            threshold,
            levels(kOutlineLevels, CULLSCOPE_TR("Levels of octree L, which holds the outline; the root is one of them.")),
            levels(kDetailLevels, CULLSCOPE_TR("Levels of octree S, which holds the details; the root is one of them.")),
            choiceParameter("boxes", "contents",
                            CULLSCOPE_TR("Which box of a node is tested and has the distance; the paper can be read both ways."),
                            {{"contents", CULLSCOPE_TR("the box around its components")},
                             {"cells", CULLSCOPE_TR("the octree's cell, over which components reach")}}),
            choiceParameter("at-rest", "culled", CULLSCOPE_TR("What is drawn while the camera does not move."),
                            {{"culled", CULLSCOPE_TR("the same as in motion")},
                             {"whole", CULLSCOPE_TR("everything in the frustum, as in the paper's Figure 8")}})};
}

}  // namespace

RegisteredStrategy smallFeature() {
    StrategyInfo info{
        "small-feature", CULLSCOPE_TR("Small-feature culling"),
        CULLSCOPE_TR("Leaves out groups of components that are too small for their distance; a plant's outline stays."),
        "Du et al. 2017", featureParameters()};
    info.remembers = true;
    info.sweeps = {{kThreshold, {"0", "0.0005", "0.001", "0.002", "0.004", "0.008"}}, {kOutline, {"0", "5", "10", "20", "50"}}};
    info.shows = {featureListing(), occupancyBarsShow()};
    return {std::move(info), std::make_shared<SmallFeature>()};
}

}  // namespace cullscope::small_feature
