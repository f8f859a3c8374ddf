#include "ui/statistics/result_rows.h"

#include <algorithm>
#include <set>

#include "core/experiments/sweeps.h"
#include "core/measure/field_figures.h"
#include "ui/text/terms.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kMillion = 1e6;

ResultRow emptyRow(const StrategyRequest& strategy, Promise promise) {
    ResultRow row;
    row.name = strategyWords(strategy);
    row.id = QString::fromStdString(strategy.id);
    row.promise = promise;
    return row;
}

/// A row of a sweep's table; what is not known there is empty.
class SweepRow {
public:
    SweepRow(const ResultTable& table, size_t row) : m_table(table), m_row(row) {}

    /// The strategy with the value that the row's sweep gives it.
    [[nodiscard]] StrategyRequest strategy() const {
        StrategyRequest request = strategyFromText(words("strategy").value_or(std::string()));
        if (const std::optional<std::string> key = words("parameter")) request.parameters.setFromText(*key, *words("value"));
        return request;
    }
    [[nodiscard]] std::optional<std::string> words(const char* key) const { return value<std::string>(key); }
    [[nodiscard]] std::optional<double> number(const char* key) const { return value<double>(key); }
    [[nodiscard]] std::optional<uint64_t> count(const char* key) const {
        const std::optional<double> found = number(key);
        return found ? std::optional(uint64_t(*found)) : std::nullopt;
    }
    [[nodiscard]] std::optional<RatioEstimate> estimate(const char* key) const { return value<RatioEstimate>(key); }

private:
    template <typename Value>
    [[nodiscard]] std::optional<Value> value(const char* key) const {
        const CellValue cell = m_table.value(m_row, key);
        const auto* found = std::get_if<Value>(&cell);
        return found != nullptr ? std::optional(*found) : std::nullopt;
    }

    const ResultTable& m_table;
    size_t m_row;
};

Promise promiseOf(const std::optional<std::string>& id) {
    for (const Promise promise : {Promise::Exact, Promise::Conservative})
        if (id == promiseId(promise)) return promise;
    return Promise::Approximate;
}

/// `missed`: all missed pixels, `beyond`: those of them that the raster's snapping does not explain, where it may explain some.
/// `rate`: of `missed`.
void countLoss(ResultRow& row, const std::optional<uint64_t>& missed, const std::optional<uint64_t>& beyond,
               const std::optional<double>& rate) {
    row.missedPixels = beyond ? beyond : missed;
    if (missed && beyond) row.withinSnapping = *missed - *beyond;
    if (!rate) return;
    const double lost = beyond && missed && *missed > 0 ? double(*beyond) / double(*missed) : 1.0;
    row.missedPpm = kMillion * *rate * lost;
}

ResultRow resultRow(const SweepRow& measured, const StrategyRequest& strategy) {
    ResultRow row = emptyRow(strategy, promiseOf(measured.words("promise")));
    row.speedup = measured.estimate("ratio_to_same_sides");
    row.baseline = measured.words("same_sides_baseline").value_or("");
    row.headroomShare = measured.estimate("headroom_share");
    row.speedupOverFrontFaces = measured.estimate("ratio_to_backface");
    row.speedupOverTriangles = measured.estimate("ratio_to_all");
    row.fpsOverall = measured.number("fps_overall");
    row.fpsMin = measured.number("fps_min");
    row.fpsMax = measured.number("fps_max");
    row.cullShare = measured.number("cull_share");
    if (const std::optional<double> culled = measured.number("culled_fraction")) row.submittedShare = 1.0 - *culled;
    countLoss(row, measured.count("missed_pixels"), measured.count("missed_beyond_snapping"),
              measured.number("missed_pixel_rate"));
    row.views = size_t(measured.number("poses").value_or(0.0));
    if (row.missedPixels != uint64_t{0}) row.worstPose = measured.count("worst_pose");
    for (const FieldFigure& figure : fieldFigures())
        if (const std::optional<RatioEstimate> value = measured.estimate(figure.key)) row.figures[figure.key] = *value;
    return row;
}

/// The field's figures of one view. Its shaded picture is not compared with that of everything, and one view does not pop.
std::map<std::string, RatioEstimate> figuresOf(const ViewFigures& view) {
    FrameMeasurement frame;
    frame.accuracy = view.accuracy;
    frame.lostPixels = view.lostPixels();
    const FieldEstimates estimates = fieldEstimates({&frame, 1});
    std::map<std::string, RatioEstimate> figures;
    for (const char* key : {"triangle_false_negative_rate", "triangle_false_positive_rate", "object_false_negative_rate",
                            "object_false_positive_rate", "silhouette_error_px"})
        if (const std::optional<RatioEstimate>& value = estimates[fieldFigurePlace(key)]) figures[key] = *value;
    return figures;
}

}  // namespace

std::vector<ResultRow> resultRows(const ResultTable& table) {
    std::vector<ResultRow> rows;
    std::set<std::string> known;
    for (size_t i = 0; i < table.rows.size(); ++i) {
        const SweepRow measured(table, i);
        const StrategyRequest strategy = measured.strategy();
        const std::string text = strategyText(strategy);
        if (!known.insert(text).second) continue;
        rows.push_back(resultRow(measured, strategy));
        rows.back().promiseBroken = std::ranges::find(table.brokenPromises, text) != table.brokenPromises.end();
    }
    return rows;
}

std::vector<ResultRow> resultRows(const MeasureResult& result) {
    const Experiment experiment = sweepExperiment({});
    ResultTable table = emptyTable(experiment);
    addRuns(table, experiment, experiment.settings.front(), result);
    return resultRows(table);
}

std::vector<ResultRow> liveRows(const std::vector<LiveFigures>& views) {
    std::vector<ResultRow> rows;
    for (const LiveFigures& view : views) {
        ResultRow row = emptyRow(view.strategy, view.promise);
        row.name = view.view + QStringLiteral(" · ") + row.name;
        const ViewMetrics& figures = view.figures;
        if (figures.state == ViewMetrics::State::Ready && figures.frameMilliseconds > 0.0) {
            row.speedup = figures.speedup;
            row.baseline = figures.baseline;
            if (figures.headroom) row.headroomShare = figures.headroom->share;
            row.speedupOverFrontFaces = figures.speedupOverFrontFaces;
            row.fpsOverall = 1000.0 / figures.frameMilliseconds;
            row.cullShare = figures.cullMilliseconds / figures.frameMilliseconds;
            row.submittedShare = figures.submittedShare();
            countLoss(row, figures.accuracy.missedPixels, figures.missedBeyondSnapping, figures.accuracy.missedPixelRate());
            row.promiseBroken = view.promise != Promise::Approximate && figures.lostPixels() > 0;
            row.figures = figuresOf(figures);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace cullscope::ui
