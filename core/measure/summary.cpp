#include "core/measure/summary.h"

#include <algorithm>
#include <numeric>

#include "core/measure/field_figures.h"
#include "core/visibility/registry.h"

namespace cullscope {
namespace {

StrategyRequest baselineAtDefaults(BaselineRole role) {
    const StrategyInfo& info = baselineOf(role);
    return {info.id, ParameterSet(info.parameters)};
}

/// Sets both ratios of a run's times to a baseline's; neither where it was not measured.
void compareTo(const StrategyRequest& baseline, const RunMeasurement& run, const std::vector<RunMeasurement>& runs,
               RatioEstimate& ofTotals, RatioEstimate& mean) {
    const auto found = std::ranges::find(runs, baseline, &RunMeasurement::strategy);
    if (found == runs.end()) return;
    std::vector<double> ratios;
    for (size_t i = 0; i < std::min(run.frames.size(), found->frames.size()); ++i)
        ratios.push_back(found->frames[i].frameMilliseconds / run.frames[i].frameMilliseconds);
    mean = meanOfRatios(ratios);
    ofTotals = ratioOver(found->frames, run.frames);
}

const RunMeasurement* runOf(const std::vector<RunMeasurement>& runs, const StrategyRequest& strategy) {
    const auto found = std::ranges::find(runs, strategy, &RunMeasurement::strategy);
    return found == runs.end() ? nullptr : &*found;
}

/// Over the poses that all four have.
std::optional<RatioEstimate> headroomShareOf(const RunMeasurement& run, const std::vector<RunMeasurement>& runs) {
    const StrategyInfo& info = limitOfCulling();
    const RunMeasurement* const limit = runOf(runs, {info.id, ParameterSet(info.parameters)});
    const RunMeasurement* const baseline = runOf(runs, run.ownRule);
    if (limit == nullptr || baseline == nullptr) return std::nullopt;
    const RunMeasurement* const ofLimit = runOf(runs, limit->ownRule);
    if (ofLimit == nullptr) return std::nullopt;
    std::vector<TimesBesideLimit> views;
    const size_t poses = std::min({run.frames.size(), limit->frames.size(), baseline->frames.size(), ofLimit->frames.size()});
    for (size_t i = 0; i < poses; ++i)
        views.push_back({baseline->frames[i].frameTimes, run.frames[i].frameTimes, ofLimit->frames[i].frameTimes,
                         limit->frames[i].frameTimes});
    return shareOfHeadroom(views);
}

}  // namespace

Summary summaryOf(const RunMeasurement& run, const std::vector<RunMeasurement>& runs, const Scene& scene) {
    return summaryOf(run, runs, scene.triangleCount());
}

Summary summaryOf(const RunMeasurement& run, const std::vector<RunMeasurement>& runs, uint64_t triangles) {
    const std::vector<FrameMeasurement>& frames = run.frames;
    Summary summary;
    if (frames.empty()) return summary;
    std::vector<double> times;
    double cull = 0.0, submitted = 0.0;
    for (const FrameMeasurement& frame : frames) {
        times.push_back(frame.frameMilliseconds);
        cull += frame.cullMilliseconds;
        submitted += frame.submitted.share(triangles);
        summary.fpsMean += 1000.0 / frame.frameMilliseconds / double(frames.size());
    }
    const double total = std::accumulate(times.begin(), times.end(), 0.0);
    summary.fpsOverall = 1000.0 * double(frames.size()) / total;
    summary.fpsMin = 1000.0 / *std::max_element(times.begin(), times.end());
    summary.fpsMax = 1000.0 / *std::min_element(times.begin(), times.end());
    summary.frameMillisecondsMedian = quantile(times, 0.5);
    summary.frameMillisecondsP95 = quantile(times, 0.95);
    summary.frameMillisecondsP99 = quantile(times, 0.99);
    summary.cullShare = cull / total;
    summary.culledFraction = triangles > 0 ? 1.0 - submitted / double(frames.size()) : 0.0;
    if (const std::optional<Losses> lost = run.losses())
        summary.missedPixelRate = lost->coveredPixels > 0 ? double(lost->missedPixels) / double(lost->coveredPixels) : 0.0;
    compareTo(baselineAtDefaults(BaselineRole::Triangles), run, runs, summary.ratioToTriangles, summary.speedupVsTriangles);
    compareTo(baselineAtDefaults(BaselineRole::FrontFaces), run, runs, summary.ratioToFrontFaces, summary.speedupVsFrontFaces);
    RatioEstimate ofPapers;
    compareTo(run.ownRule, run, runs, summary.ratioToOwnRule, ofPapers);
    summary.headroomShare = headroomShareOf(run, runs);
    summary.field = fieldEstimates(frames);
    // The rule of three: of n views none with a loss.
    if (!summary.field.empty() && framesWithLoss(frames) == 0) summary.lossBelow = 3.0 / double(frames.size());
    return summary;
}

std::optional<Losses> RunMeasurement::losses() const {
    if (frames.empty() || !frames.front().accuracy) return std::nullopt;
    Losses losses;
    uint64_t most = 0;
    for (const FrameMeasurement& frame : frames) {
        losses.coveredPixels += frame.accuracy->coveredPixels;
        losses.missedPixels += frame.accuracy->missedPixels;
        losses.missedBeyondSnapping += frame.missedBeyondSnapping;
        losses.beyondSnapping = losses.beyondSnapping || frame.ownRaster || facing != referenceFacing;
        losses.largestHolePixels = std::max(losses.largestHolePixels, frame.accuracy->largestHolePixels);
        if (frame.accuracy->missedPixels <= most) continue;
        most = frame.accuracy->missedPixels;
        losses.worstPose = frame.pose;
    }
    return losses;
}

bool RunMeasurement::promiseBroken() const {
    if (promise == Promise::Approximate) return false;
    return std::any_of(frames.begin(), frames.end(), [&](const FrameMeasurement& frame) {
        if (frame.ownRaster || facing != referenceFacing) return frame.missedBeyondSnapping > 0;
        return frame.accuracy && frame.accuracy->missedPixels > 0;
    });
}

}  // namespace cullscope
