#pragma once

#include <QString>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/experiments/result_table.h"
#include "core/measure/meter.h"
#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// The metrics of one view's strategy at the present camera.
struct LiveFigures {
    QString view;  ///< the view's letter, "A"
    StrategyRequest strategy;
    Promise promise = Promise::Approximate;
    ViewMetrics figures;
};

/// One row of the table of results; unknown values are empty.
struct ResultRow {
    QString name;  ///< translated, with the parameters that differ from the defaults
    QString id;
    Promise promise = Promise::Approximate;
    bool promiseBroken = false;
    std::optional<RatioEstimate> speedup;                                      ///< over the baseline that draws the same sides,
    std::string baseline;                                                      ///< which is this one
    std::optional<RatioEstimate> headroomShare;                                ///< of the time that any culling could save
    std::optional<RatioEstimate> speedupOverTriangles, speedupOverFrontFaces;  ///< over `all` and over `backface`
    std::optional<double> fpsOverall, fpsMin, fpsMax;
    std::optional<double> cullShare, submittedShare;
    std::optional<uint64_t> missedPixels;          ///< that are lost: without those that the raster's snapping explains
    std::optional<uint64_t> withinSnapping;        ///< those; none: it cannot explain any
    std::optional<double> missedPpm;               ///< of the lost ones
    size_t views = 0;                              ///< measured; 0: at the present camera
    std::optional<size_t> worstPose;               ///< pose with the most missed pixels; none if no pixel is lost
    std::map<std::string, RatioEstimate> figures;  ///< the field's (fieldFigures), by key; what was not measured is missing
};

/// The rows of a sweep's table (sweepExperiment), each strategy once, though several sweeps contain it.
[[nodiscard]] std::vector<ResultRow> resultRows(const ResultTable& table);
/// The same of a measurement whose strategies no sweep varies.
[[nodiscard]] std::vector<ResultRow> resultRows(const MeasureResult& result);
[[nodiscard]] std::vector<ResultRow> liveRows(const std::vector<LiveFigures>& views);

}  // namespace cullscope::ui
