#include "core/experiments/paper_rows.h"

#include "core/measure/statistics.h"
#include "core/visibility/strategy_request.h"

namespace cullscope {
namespace {

void addLosses(PaperCells& cells, const RunMeasurement& run) {
    const std::optional<Losses> losses = run.losses();
    if (!losses) return;
    cells["missed_pixels"] = double(losses->missedPixels);
    cells["largest_hole_px"] = double(losses->largestHolePixels);
    if (run.summary.missedPixelRate) cells["missed_pixel_rate"] = *run.summary.missedPixelRate;
}

}  // namespace

PaperCells rowCells(const PaperSetting& setting, const RunMeasurement& run) {
    PaperCells cells = setting.labels;
    const std::string strategy = strategyText(run.strategy);
    if (const auto stated = setting.paper.find(strategy); stated != setting.paper.end())
        cells.insert(stated->second.begin(), stated->second.end());
    const Summary& summary = run.summary;
    cells["strategy"] = strategy;
    cells["poses"] = double(run.frames.size());
    cells["fps_max"] = summary.fpsMax;
    cells["fps_min"] = summary.fpsMin;
    cells["fps_mean"] = summary.fpsMean;
    cells["ratio_to_all"] = summary.ratioToAll;
    cells["ratio_to_backface"] = summary.ratioToBackface;
    cells["speedup_vs_all"] = summary.speedupVsAll;
    addLosses(cells, run);
    return cells;
}

}  // namespace cullscope
