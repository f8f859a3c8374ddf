#include "core/visibility/baseline/oracle.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/message.h"
#include "core/visibility/facing.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/scene_clusters.h"

namespace cullscope::baseline {
namespace {

constexpr const char* kBy = "by";
constexpr const char* kObjects = "objects";
constexpr const char* kClusters = "clusters";

struct OracleScene : Structure {
    using Structure::Structure;
    bool byObjects = false;
    std::optional<SceneClusters> clusters;  ///< by clusters
};

/// What the exact picture of the last view showed, and what is drawn for it: of the same view neither is worked out again.
struct Known : ViewState {
    std::optional<Camera> camera;
    Viewport size;
    std::vector<uint32_t> visible;  ///< ascending
    std::vector<DrawRange> ranges;  ///< in the order of the instances; of nothing that is not visible
    uint64_t drawn = 0;             ///< triangles of the ranges

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<Known>(*this); }
    void find(FrameContext& frame, const OracleScene& structure);

private:
    void list(const OracleScene& structure);
};

enum class OracleLine : uint8_t { Known = 1, Objects, Draw, LeaveOut };

/// Appends the ranges of consecutive triangles of an object, `triangles` ascending.
void addRuns(std::vector<DrawRange>& ranges, uint32_t instance, uint64_t first, std::span<const uint32_t> triangles) {
    for (size_t i = 0; i < triangles.size(); ++i) {
        const auto place = uint32_t(3 * (triangles[i] - first));
        if (i > 0 && triangles[i] == triangles[i - 1] + 1)
            ranges.back().indexCount += 3;
        else
            ranges.push_back({instance, place, 3});
    }
}

/// Appends the clusters of an object of which a triangle is visible; neighbouring ones become one range.
void addClusters(std::vector<DrawRange>& ranges, uint32_t instance, const ClusterTree& tree, std::span<const uint32_t> visible,
                 uint64_t first) {
    std::vector<const SurfaceNode*> leaves;
    for (const SurfaceNode& node : tree.nodes())
        if (node.leaf()) leaves.push_back(&node);
    std::ranges::sort(leaves, {}, [](const SurfaceNode* node) { return node->first; });
    uint32_t end = 0;
    for (const SurfaceNode* leaf : leaves) {
        bool shows = false;
        for (uint32_t place = leaf->first; place < leaf->first + leaf->count && !shows; ++place)
            shows = std::ranges::binary_search(visible, first + tree.triangleAt(place));
        if (!shows) continue;
        if (end > 0 && end == leaf->first)
            ranges.back().indexCount += 3 * leaf->count;
        else
            ranges.push_back({instance, 3 * leaf->first, 3 * leaf->count});
        end = leaf->first + leaf->count;
    }
}

void Known::find(FrameContext& frame, const OracleScene& structure) {
    const View& view = frame.view();
    if (camera == view.camera() && size == view.viewport()) return;
    visible = frame.visibleTriangles();
    camera = view.camera();
    size = view.viewport();
    // The limit has no cost by the objects of the scene: its list is known beforehand, too.
    frame.workOutUntimed([&] { list(structure); });
}

void Known::list(const OracleScene& structure) {
    const Scene& scene = structure.scene();
    ranges.clear();
    for (auto from = visible.begin(); from != visible.end();) {
        const auto instance = uint32_t(scene.instanceOf(*from));
        const uint64_t first = scene.firstTriangle(instance), all = scene.meshOf(instance).triangleCount();
        const auto to = std::lower_bound(from, visible.end(), first + all);
        const std::span<const uint32_t> own(from, to);
        if (structure.clusters)
            addClusters(ranges, instance, structure.clusters->of(scene, instance), own, first);
        else if (structure.byObjects || own.size() == all)
            ranges.push_back({instance, 0, uint32_t(3 * all)});
        else
            addRuns(ranges, instance, first, own);
        from = to;
    }
    drawn = 0;
    for (const DrawRange& range : ranges) drawn += range.indexCount / 3;
}

class Oracle final : public StrategyWith<OracleScene, Known> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<Known>(); }

protected:
    void fill(OracleScene& structure, const ParameterSet& parameters, const Progress& progress) const override {
        structure.report.figures = {{"objects", double(structure.scene().instances().size())}};
        structure.byObjects = parameters.choice(kBy) == kObjects;
        if (parameters.choice(kBy) != kClusters) return;
        structure.clusters.emplace(structure.scene(), uint32_t(parameters.integer(kClusterSize)), progress);
        structure.report.bytes = structure.clusters->bytes();
        const std::vector<StructureReport::Figure> figures = structure.clusters->figures();
        structure.report.figures.insert(structure.report.figures.end(), figures.begin(), figures.end());
    }
    void decide(FrameContext& frame, const OracleScene& structure, Known& known,
                const ParameterSet& /*parameters*/) const override {
        known.find(frame, structure);
        sayBegin(frame, uint8_t(OracleLine::Known),
                 CULLSCOPE_TR("The exact picture shows %1 triangles. They are known beforehand, and in no time of the frame."),
                 {double(known.visible.size())});
        DrawList list{frame.facing(), {}, structure.clusters ? structure.clusters->order : nullptr};
        {
            const StageTimer stage(frame, CULLSCOPE_TR("listing"));
            list.ranges = known.ranges;
            frame.counters().culledTriangles[size_t(Cause::Hidden)] += structure.scene().triangleCount() - known.drawn;
        }
        if (frame.recording()) sayObjects(frame, structure.scene(), known.ranges);
        frame.draw(std::move(list));
    }
    [[nodiscard]] Promise promiseOf(const OracleScene& /*structure*/, const ParameterSet& parameters,
                                    Facing /*facing*/) const override {
        return parameters.choice(kBy) == "triangles" ? Promise::Exact : Promise::Conservative;
    }

private:
    static void sayObjects(FrameContext& frame, const Scene& scene, const std::vector<DrawRange>& ranges) {
        auto range = ranges.begin();
        for (uint32_t i = 0; i < scene.instances().size(); ++i) {
            uint64_t drawn = 0;
            for (; range != ranges.end() && range->instance == i; ++range) drawn += range->indexCount / 3;
            if (const uint64_t all = scene.meshOf(i).triangleCount(); all > 0) frame.say(end(i, drawn, all));
        }
    }
    [[nodiscard]] static Decision end(uint32_t instance, uint64_t drawn, uint64_t all) {
        const Subject subject = Subject::ofObject(instance);
        if (drawn == 0) return atLine(OracleLine::LeaveOut, ending(subject, Decision::Outcome::Culled, Cause::Hidden));
        const auto outcome = drawn == all ? Decision::Outcome::Drawn : Decision::Outcome::PartlyDrawn;
        return atLine(OracleLine::Draw, ending(subject, outcome, Cause::Hidden));
    }
};

}  // namespace

RegisteredStrategy oracle() {
    StrategyInfo info{"oracle",
                      CULLSCOPE_TR("Oracle"),
                      CULLSCOPE_TR("Draws exactly what is visible, known beforehand: what any culling could gain at most."),
                      "",
                      {facingParameter(),
                       readWhenBuilding(choiceParameter(
                           kBy, "triangles", CULLSCOPE_TR("What is drawn where any of it is visible."),
                           {{"triangles", CULLSCOPE_TR("the visible triangles")},
                            {kObjects, CULLSCOPE_TR("whole objects of which anything is visible")},
                            {kClusters, CULLSCOPE_TR("whole clusters of triangles of which anything is visible")}})),
                       clusterSizeParameter()},
                      GlRequirement::Context};
    info.limit = true;
    info.shows = {listingShow({{CULLSCOPE_TR("know what is visible (not timed)"), 0},
                               {CULLSCOPE_TR("for each object"), 0},
                               {CULLSCOPE_TR("draw what is visible of it"), 1},
                               {CULLSCOPE_TR("nothing: leave it out"), 1}})};
    return {std::move(info), std::make_shared<Oracle>()};
}

}  // namespace cullscope::baseline
