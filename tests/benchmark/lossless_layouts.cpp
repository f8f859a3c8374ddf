// The latitude-longitude layout against the octahedral one, over meshes and resolutions.
#include <algorithm>
#include <array>

#include "core/experiments/run_rows.h"
#include "core/spatial/cell_tree.h"
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/lossless_scenes.h"
#include "tests/benchmark/run_means.h"

namespace cullscope::benchmark {
namespace {

using Origin = ResultColumn::Origin;

constexpr std::array kLayouts{MapLayout::Octahedral, MapLayout::LatitudeLongitude};
constexpr std::array kLevels{5u, 6u, 7u, 8u, 0u};
constexpr Viewport kLayoutSize{320, 240};
constexpr int kLayoutRounds = 5;

double ratioOfLeaves(const CellTree& tree) {
    double largest = 0.0, smallest = 100.0;
    for (const CellTree::Node& node : tree.nodes()) {
        if (node.childCount > 0) continue;
        const double angle = solidAngle(tree.layout(), node.cell());
        largest = std::max(largest, angle);
        smallest = std::min(smallest, angle);
    }
    return largest / smallest;
}

std::string levelText(uint32_t level) { return level == 0 ? "auto" : std::to_string(level); }

std::string layoutStrategy(MapLayout layout, uint32_t level) { return losslessText(layout, level, true, "auto"); }

Row layoutCells(const Setting& setting, const RunMeasurement& run, MapLayout layout, uint32_t level, const MeshPointer& mesh) {
    Row row = rowCells(setting, run);
    const double faces = double(mesh->triangleCount());
    const auto share = [&](Cause cause) {
        return meanOver(run, [&](const FrameMeasurement& frame) { return double(frame.culledTriangles[size_t(cause)]) / faces; });
    };
    const CellTree tree(mesh, {layout, level});
    row["mesh"] = mesh->name();
    row["facing"] = std::string(run.facing == Facing::Front ? "front" : "two-sided");
    row["layout"] = std::string(mapLayoutId(layout));
    row["level"] = levelText(level);
    row["bytes"] = double(run.structure.bytes);
    row["nodes"] = double(tree.nodes().size());
    row["leaves"] = double(tree.leafCount());
    row["largest_to_smallest_cell"] = ratioOfLeaves(tree);
    row["nodes_visited"] = meanOver(run, [](const FrameMeasurement& frame) { return double(frame.nodesVisited); });
    row["cull_ms"] = meanOver(run, [](const FrameMeasurement& frame) { return frame.cullMilliseconds; });
    row["considered_share"] =
        meanOver(run, [&](const FrameMeasurement& frame) { return frame.submitted.share(uint64_t(faces)); });
    row["outside_share"] = share(Cause::OutsideFrustum);
    row["back_facing_share"] = share(Cause::BackFacing);
    row["hidden_share"] = share(Cause::Hidden);
    return row;
}

Rows layoutRows(const Setting& setting, const MeasureResult& result) {
    Rows rows;
    for (const MapLayout layout : kLayouts)
        for (const uint32_t level : kLevels)
            for (const RunMeasurement& run : result.runs)
                if (!run.frames.empty() && strategyText(run.strategy) == layoutStrategy(layout, level))
                    rows.push_back(layoutCells(setting, run, layout, level, result.request.scene->meshes().front()));
    return rows;
}

/// A plot for each mesh; a line connects the levels of a layout over one path, coarse to fine, without auto.
RowPlot layoutsPlot() {
    RowPlot described{
        logPlot("%1, %2: share of the faces considered against what culling costs, levels 5 to 8", "ms a cull", "share")};
    described.x = "cull_ms";
    described.y = {{"considered_share"}};
    described.lines = {"layout", "path"};
    for (const uint32_t level : kLevels)
        if (level > 0) described.rows["level"].emplace_back(levelText(level));
    described.separate = {"mesh", "facing"};
    return described;
}

}  // namespace

Experiment losslessLayouts(const std::vector<std::string>& scenes, size_t views) {
    Experiment experiment;
    experiment.id = "spherical-layouts";
    experiment.title = "Both layouts of the map of spherical-lossless, 320 x 240";
    std::vector<CellValue> layouts, levels;
    for (const MapLayout layout : kLayouts) layouts.emplace_back(std::string(mapLayoutId(layout)));
    for (const uint32_t level : kLevels) levels.emplace_back(levelText(level));
    experiment.axes = {{"scene", "scene", Axis::Kind::Scene, {scenes.begin(), scenes.end()}},
                       {"path", "path", Axis::Kind::Path, {kObjectPaths.begin(), kObjectPaths.end()}},
                       {"layout", "layout", Axis::Kind::InTurns, layouts},
                       {"level", "level", Axis::Kind::InTurns, levels}};
    Setting common;
    for (const MapLayout layout : kLayouts)
        for (const uint32_t level : kLevels) common.strategies.push_back(layoutStrategy(layout, level));
    common.size = kLayoutSize;
    common.timing.fixedRepetitions = kLayoutRounds;
    experiment.settings = settingsOf(experiment.axes, common);
    for (Setting& setting : experiment.settings)
        setting.views = [views, path = setting.path](const Scene& scene) {
            static_cast<void>(scene.frontFacesSuffice());  // computed once, and not in the time of the first layout
            return objectPath(path, scene, views);
        };
    experiment.columns = columnsOf(experiment.axes);
    for (const char* key : {"mesh", "facing"}) experiment.columns.push_back({key, key, Origin::Axis});
    const std::vector<std::pair<const char*, int>> measured{{"build_ms", 1},
                                                            {"bytes", 0},
                                                            {"nodes", 0},
                                                            {"leaves", 0},
                                                            {"largest_to_smallest_cell", 1},
                                                            {"nodes_visited", 0},
                                                            {"cull_ms", 3},
                                                            {"considered_share", 3},
                                                            {"outside_share", 3},
                                                            {"back_facing_share", 3},
                                                            {"hidden_share", 3},
                                                            {"missed_pixels", 0}};
    for (const auto& [key, decimals] : measured) experiment.columns.push_back({key, key, Origin::Measured, decimals});
    experiment.columns.push_back({"ratio_to_backface", "x backface [95 %]", Origin::Measured, 2});
    experiment.plots = {layoutsPlot()};
    experiment.rowsOfRuns = layoutRows;
    return experiment;
}

}  // namespace cullscope::benchmark
