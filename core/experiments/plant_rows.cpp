#include "core/experiments/plant_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/visibility/strategy_request.h"

namespace cullscope::plants {
namespace {

using Origin = ResultColumn::Origin;

/// The paper's frames are at least so many times as many as by triangle, its conclusion says.
constexpr double kPaperRatio = 3.0;

/// The sum of a figure over a run's views; none where the strategy does not count it.
std::optional<double> figureOf(const RunMeasurement& run, std::string_view name) {
    std::optional<double> sum;
    for (const FrameMeasurement& frame : run.frames)
        for (const NamedFigure& figure : frame.figures)
            if (figure.name == name) sum = sum.value_or(0.0) + figure.value;
    return sum;
}

/// A column that sums up stages of what kind they are.
struct StageColumn {
    const char* key;
    const char* title;
    std::array<std::string_view, 2> stages;
};
constexpr std::array kStages{StageColumn{"groups_ms", CULLSCOPE_TR("groups, ms"), {"octrees", "groups of objects"}},
                             StageColumn{"sizes_ms", CULLSCOPE_TR("sizes, ms"), {"triangles", "components"}},
                             StageColumn{"list_ms", CULLSCOPE_TR("draw list, ms"), {"draw list", ""}}};

/// Milliseconds of a view by stage, of the strategies that say their stages.
void addStages(Row& cells, const RunMeasurement& run) {
    for (const StageColumn& column : kStages) {
        const bool known = std::ranges::any_of(run.frames.front().stages, [&](const Stage& stage) {
            return std::ranges::find(column.stages, stage.name) != column.stages.end();
        });
        if (!known) continue;
        cells[column.key] = meanOfFrames(run, [&](const FrameMeasurement& frame) {
            double sum = 0.0;
            for (const Stage& stage : frame.stages)
                if (std::ranges::find(column.stages, stage.name) != column.stages.end()) sum += stage.milliseconds;
            return sum;
        });
    }
    cells["draw_ms"] =
        meanOfFrames(run, [](const FrameMeasurement& frame) { return frame.frameMilliseconds - frame.cullMilliseconds; });
}

}  // namespace

std::string plantOf(int pipelines) { return fmt::format("plant:pipelines={},seed=1", pipelines); }

CameraPath withField(CameraPath path, const Viewport& size) {
    path.fovy = verticalField(kField, size);
    return path;
}

CameraPath partsOfWalk(const Scene& scene, int views, const Viewport& size) {
    CameraPath path = withField(cameraPath(fmt::format("walk:{}", 2 * views + 1), scene), size);
    std::vector<CameraPath::Pose> middles;
    for (size_t i = 1; i < path.poses.size(); i += 2) middles.push_back(path.poses[i]);
    path.poses = std::move(middles);
    return path;
}

Row runCells(const Setting& setting, const MeasureResult& result, const RunMeasurement& run) {
    Row cells = rowCells(setting, run);
    const Scene& scene = *result.request.scene;
    cells["triangles"] = double(scene.triangleCount());
    cells["components"] = double(scene.instances().size());
    cells["scene_bytes"] = double(scene.bytes());
    addRatio(cells, "ratio_to_triangle", runOf(result, kTriangle), run);
    addRatio(cells, "ratio_to_octree", runOf(result, kOctree), run);
    addStages(cells, run);
    if (const std::optional<double> leaves = figureOf(run, "leaves_visible"))
        cells["leaves_visible"] = *leaves / double(run.frames.size());
    const std::optional<double> stated = figureOf(run, "lost_pixels_at_most");
    const std::optional<Losses> losses = run.losses();
    if (stated) cells["lost_at_most"] = *stated;
    if (stated && losses) cells["beyond_stated"] = double(losses->missedPixels) - *stated;
    return cells;
}

std::vector<ResultColumn> plantColumns(const std::vector<Axis>& axes) {
    std::vector<ResultColumn> columns = columnsOf(axes);
    const std::vector<ResultColumn> measured{
        {"triangles", CULLSCOPE_TR("triangles")},
        {"components", CULLSCOPE_TR("components")},
        {"per_pipeline", CULLSCOPE_TR("triangles a pipeline")},
        {"components_per_pipeline", CULLSCOPE_TR("components a pipeline"), Origin::Measured, 1},
        {"fps_overall", CULLSCOPE_TR("fps, all views"), Origin::Measured, 2},
        {"frame_ms", CULLSCOPE_TR("frame, ms"), Origin::Measured, 1},
        {"ratio_to_all", CULLSCOPE_TR("× all [95 %]"), Origin::Measured, 2},
        {"ratio_to_octree", CULLSCOPE_TR("× frustum-octree [95 %]"), Origin::Measured, 2},
        headroomColumn(),
        {"paper_ratio_to_triangle", CULLSCOPE_TR("paper: × by triangle, at least"), Origin::Stated, 0},
        {"ratio_to_triangle", CULLSCOPE_TR("× by triangle [95 %]"), Origin::Measured, 2},
        {"culled_fraction", CULLSCOPE_TR("culled, %"), Origin::Measured, 1, 100.0},
        {"missed_pixels", CULLSCOPE_TR("missed px")},
        {"missed_pixel_rate", CULLSCOPE_TR("missed ppm"), Origin::Measured, 0, 1e6},
        {"largest_hole_px", CULLSCOPE_TR("largest hole, px")},
        {"lost_at_most", CULLSCOPE_TR("stated, at most, px")},
        {"beyond_stated", CULLSCOPE_TR("missed less stated, px")},
        {"cull_ms", CULLSCOPE_TR("culling, ms"), Origin::Measured, 2},
        {"groups_ms", kStages[0].title, Origin::Measured, 2},
        {"sizes_ms", kStages[1].title, Origin::Measured, 2},
        {"list_ms", kStages[2].title, Origin::Measured, 2},
        {"draw_ms", CULLSCOPE_TR("drawing, ms"), Origin::Measured, 1},
        {"leaves_visible", CULLSCOPE_TR("visible leaves"), Origin::Measured, 0},
        {"build_ms", CULLSCOPE_TR("build, ms"), Origin::Measured, 1},
        {"structure_bytes", CULLSCOPE_TR("bytes")},
        {"scene_bytes", CULLSCOPE_TR("bytes of the scene")},
        {"poses", CULLSCOPE_TR("views")}};
    columns.insert(columns.end(), measured.begin(), measured.end());
    return columns;
}

Setting commonSetting(const PlantFiguresSize& size) {
    Setting common;
    common.shown = kFeature;
    common.size = size.size;
    common.timing.fixedRepetitions = size.repetitions;
    common.timing.warmUpOnce = true;
    common.stated[kFeature] = {{"paper_ratio_to_triangle", kPaperRatio}};
    return common;
}

Check boundCheck() {
    return everyRowCheck("pixels missed beyond what small-feature-bounded states", {}, "beyond_stated", {.most = 0.0});
}

}  // namespace cullscope::plants
