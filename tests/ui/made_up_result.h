#pragma once

#include "core/experiments/sweeps.h"
#include "core/measure/accuracy.h"
#include "tests/support/small_experiment.h"

namespace cullscope::ui {

/// The measurement of one frame with made-up values.
inline FrameMeasurement frame(size_t pose, double milliseconds, uint64_t missed) {
    FrameMeasurement measured;
    measured.pose = pose;
    measured.frameMilliseconds = milliseconds;
    measured.cullMilliseconds = milliseconds / 4;
    measured.repetitions = 3;
    measured.consideredTriangles = measured.submitted.triangles = 100;
    measured.accuracy = Accuracy{};
    measured.accuracy->coveredPixels = 1'000'000;
    measured.accuracy->missedPixels = missed;
    return measured;
}

inline RunMeasurement run(const std::string& id, double milliseconds, const std::vector<uint64_t>& missed) {
    RunMeasurement made;
    made.strategy = test::request(id);
    made.promise = Promise::Conservative;
    uint64_t all = 0;
    for (size_t pose = 0; pose < missed.size(); ++pose) {
        made.frames.push_back(frame(pose, milliseconds, missed[pose]));
        all += missed[pose];
    }
    made.summary.fpsOverall = made.summary.fpsMin = made.summary.fpsMax = 1000.0 / milliseconds;
    made.summary.cullShare = 0.25;
    made.summary.culledFraction = 0.6;
    made.summary.missedPixelRate = double(all) / 1e6 / double(missed.size());
    made.summary.ratioToOwnRule = made.summary.ratioToFrontFaces = {8.0 / milliseconds, {7.0 / milliseconds, 9.0 / milliseconds}};
    made.summary.ratioToTriangles = {10.0 / milliseconds, {9.0 / milliseconds, 11.0 / milliseconds}};
    return made;
}

/// Results of three strategies over four poses; `frustum` loses pixels at two of them.
inline MeasureResult madeUpResult() {
    MeasureResult result;
    result.request = test::smallExperiment({"all", "backface", "frustum"});
    result.request.path = cameraPath("fibonacci:4", *result.request.scene);
    result.gl.renderer = "<renderer & co>";
    result.runs = {run("all", 10.0, {0, 0, 0, 0}), run("backface", 8.0, {0, 0, 0, 0}), run("frustum", 4.0, {0, 5, 12, 0})};
    result.request.strategies[2].parameters.setFromText("box", "length");
    result.runs[2].strategy = result.request.strategies[2];
    return result;
}

/// The table of a measurement whose strategies no sweep varies.
inline ResultTable tableOf(const MeasureResult& result) {
    const Experiment experiment = sweepExperiment({});
    ResultTable table = emptyTable(experiment);
    addRuns(table, experiment, experiment.settings.front(), result);
    return table;
}

}  // namespace cullscope::ui
