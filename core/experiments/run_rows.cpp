#include "core/experiments/run_rows.h"

#include "core/measure/field_figures.h"
#include "core/visibility/registry.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

void addLosses(Row& cells, const RunMeasurement& run) {
    const std::optional<Losses> losses = run.losses();
    if (!losses) return;
    cells["missed_pixels"] = double(losses->missedPixels);
    cells["largest_hole_px"] = double(losses->largestHolePixels);
    if (losses->beyondSnapping) cells["missed_beyond_snapping"] = double(losses->missedBeyondSnapping);
    if (losses->worstPose) cells["worst_pose"] = double(*losses->worstPose);
    for (size_t i = 0; i < run.summary.field.size(); ++i)
        if (const std::optional<RatioEstimate>& figure = run.summary.field[i]) cells[fieldFigures()[i].key] = *figure;
    if (run.summary.missedPixelRate) cells["missed_pixel_rate"] = *run.summary.missedPixelRate;
}

}  // namespace

std::string limitText() { return limitOfCulling().id; }

ResultColumn headroomColumn() {
    return {.key = "headroom_share", .title = CULLSCOPE_TR("of the headroom, % [95 %]"), .scale = 100.0, .estimated = true};
}

const RunMeasurement* runOf(const MeasureResult& result, std::string_view strategy) {
    for (const RunMeasurement& run : result.runs)
        if (!run.frames.empty() && strategyText(run.strategy) == strategy) return &run;
    return nullptr;
}

void addRatio(Row& cells, const char* key, const RunMeasurement* baseline, const RunMeasurement& run) {
    if (baseline != nullptr && baseline->frames.size() == run.frames.size()) cells[key] = ratioOver(baseline->frames, run.frames);
}

Row rowCells(const Setting& setting, const RunMeasurement& run) {
    Row cells = setting.labels;
    const std::string strategy = strategyText(run.strategy);
    if (const auto stated = setting.stated.find(strategy); stated != setting.stated.end())
        cells.insert(stated->second.begin(), stated->second.end());
    const Summary& summary = run.summary;
    cells["strategy"] = strategy;
    cells["promise"] = std::string(promiseId(run.promise));
    cells["poses"] = double(run.frames.size());
    cells["fps_overall"] = summary.fpsOverall;
    cells["fps_max"] = summary.fpsMax;
    cells["fps_min"] = summary.fpsMin;
    cells["fps_mean"] = summary.fpsMean;
    cells["ratio_to_same_sides"] = summary.ratioToOwnRule;
    cells["same_sides_baseline"] = strategyText(run.ownRule);
    if (summary.headroomShare) cells["headroom_share"] = *summary.headroomShare;
    cells["ratio_to_all"] = summary.ratioToTriangles;
    cells["ratio_to_backface"] = summary.ratioToFrontFaces;
    cells["speedup_vs_all"] = summary.speedupVsTriangles;
    cells["culled_fraction"] = summary.culledFraction;
    cells["cull_share"] = summary.cullShare;
    cells["cull_ms"] = meanOfFrames(run, [](const FrameMeasurement& frame) { return frame.cullMilliseconds; });
    cells["frame_ms"] = meanOfFrames(run, [](const FrameMeasurement& frame) { return frame.frameMilliseconds; });
    cells["build_ms"] = run.structure.buildMilliseconds;
    cells["structure_bytes"] = double(run.structure.bytes);
    addLosses(cells, run);
    return cells;
}

Rows runRows(const Setting& setting, const MeasureResult& result) {
    Rows rows;
    for (const RunMeasurement& run : result.runs)
        if (!run.frames.empty()) rows.push_back(rowCells(setting, run));
    return rows;
}

}  // namespace cullscope
