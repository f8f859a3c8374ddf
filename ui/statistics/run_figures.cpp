#include "ui/statistics/run_figures.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "core/experiments/run_rows.h"
#include "core/experiments/trade_plot.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr double kDegrees = 180.0 / 3.14159265358979323846;
constexpr double kLeastLossShare = 0.2;

double ppmOf(uint64_t lost, uint64_t covered) { return covered > 0 ? kPartsPerMillion * double(lost) / double(covered) : 0.0; }

PoseFigures poseFigures(const FrameMeasurement& frame, const RunMeasurement& run, const MeasureResult& result) {
    PoseFigures figures;
    figures.pose = frame.pose;
    figures.frameMilliseconds = frame.frameMilliseconds;
    if (frame.accuracy) {
        figures.missedPixels = lostPixels(run, frame);
        figures.missedPpm = ppmOf(figures.missedPixels, frame.accuracy->coveredPixels);
    }
    const Vec3 direction = result.request.path.poses.at(frame.pose).eye - result.request.scene->boundingSphere().centre;
    figures.azimuth = kDegrees * std::atan2(direction.x, direction.z);
    figures.elevation = kDegrees * std::atan2(direction.y, std::hypot(direction.x, direction.z));
    return figures;
}

}  // namespace

uint64_t lostPixels(const RunMeasurement& run, const FrameMeasurement& frame) {
    const bool explained = frame.ownRaster || run.facing != run.referenceFacing;
    return explained || !frame.accuracy ? frame.missedBeyondSnapping : frame.accuracy->missedPixels;
}

QString runLabel(const StrategyRequest& strategy) { return QString::fromStdString(strategyLabel(strategy)); }

std::vector<RunFigures> runFigures(const MeasureResult& result) {
    std::vector<RunFigures> all;
    const auto add = [&](const RunMeasurement& run) {
        if (run.frames.empty()) return;
        RunFigures figures;
        figures.label = runLabel(run.strategy);
        figures.id = QString::fromStdString(run.strategy.id);
        figures.role = findStrategy(run.strategy.id).info.baseline;
        figures.baseline = figures.role != BaselineRole::None;
        figures.limit = findStrategy(run.strategy.id).info.limit;
        figures.headroomShare = run.summary.headroomShare;
        figures.parameters = run.strategy.parameters;
        figures.promise = run.promise;
        figures.frameMilliseconds = 1000.0 / run.summary.fpsOverall;
        figures.cullMilliseconds = run.summary.cullShare * figures.frameMilliseconds;
        figures.speedup = run.summary.ratioToOwnRule;
        if (const std::optional<Losses> losses = run.losses())
            figures.missedPpm =
                ppmOf(losses->beyondSnapping ? losses->missedBeyondSnapping : losses->missedPixels, losses->coveredPixels);
        // Where the limit was not judged, as in older files: it draws what is visible.
        if (figures.limit && !figures.missedPpm) figures.missedPpm = 0.0;
        figures.values = tradeValues(rowCells({}, run));
        for (const FrameMeasurement& frame : run.frames) figures.poses.push_back(poseFigures(frame, run, result));
        all.push_back(std::move(figures));
    };
    for (const RunMeasurement& run : result.runs) add(run);
    const auto isLimit = [&](const RunMeasurement& run) { return run.strategy == result.limit->strategy; };
    if (result.limit && std::ranges::none_of(result.runs, isLimit)) add(*result.limit);
    return all;
}

double lossShare(double missedPpm) {
    if (missedPpm <= 0.0) return 0.0;
    // Six decades: from 0.1 parts per million to a tenth.
    return std::clamp((std::log10(missedPpm) + 1.0) / 6.0, kLeastLossShare, 1.0);
}

QString significantText(double value) {
    if (value <= 0.0) return QStringLiteral("0");
    const int digits = value >= 9.95 ? 0 : std::min(6, 1 - int(std::floor(std::log10(value))));
    return QLocale().toString(value, 'f', digits);
}

}  // namespace cullscope::ui
