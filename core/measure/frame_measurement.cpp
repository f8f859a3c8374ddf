#include "core/measure/frame_measurement.h"

#include <algorithm>

namespace cullscope {

FrameMeasurement measurementOf(const TimedFrames& timed) {
    FrameMeasurement figures;
    figures.frameMilliseconds = quantile(timed.frameMilliseconds, 0.5);
    figures.cullMilliseconds = quantile(timed.cullMilliseconds, 0.5);
    figures.frameTimes = timed.frameMilliseconds;
    figures.cullTimes = timed.cullMilliseconds;
    figures.repetitions = static_cast<int>(timed.frameMilliseconds.size());
    figures.stages = timed.log.stages;
    figures.submitted = submittedBy(timed.strategy->scene(), timed.log);
    figures.consideredTriangles = timed.log.consideredTriangles();
    figures.culledTriangles = timed.log.counters.culledTriangles;
    figures.parts = timed.log.counters.parts;
    figures.figures = timed.log.counters.figures;
    figures.nodesVisited = timed.log.counters.nodesVisited;
    figures.frameBytes = timed.log.frameBytes();
    return figures;
}

void addLosses(FrameMeasurement& figures, const JudgedFrame& judged, std::vector<LostObject> lost) {
    figures.accuracy = judged.accuracy;
    figures.ownRaster = judged.ownRaster;
    figures.missedBeyondSnapping = judged.missedBeyondSnapping.value_or(0);
    figures.lostPixels = judged.lostPixels();
    figures.wronglyNearerPixels = judged.extraBeyondSnapping.value_or(judged.accuracy.extraPixels);
    figures.lostObjects = std::move(lost);
}

RatioEstimate ratioOver(std::span<const FrameMeasurement> baseline, std::span<const FrameMeasurement> subject) {
    std::vector<ViewTimes> views;
    for (size_t i = 0; i < std::min(baseline.size(), subject.size()); ++i)
        views.push_back({baseline[i].frameTimes, subject[i].frameTimes});
    return ratioOfTotals(views);
}

}  // namespace cullscope
