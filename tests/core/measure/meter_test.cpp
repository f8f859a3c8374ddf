#include "core/measure/meter.h"

#include "core/base/error.h"
#include "core/measure/accuracy.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::meter_test {
namespace {

TEST(Measure, fieldsFitTogether) {
    MeasureRequest experiment = smallExperiment({"all", "frustum", "backface"});
    const MeasureResult result = measure(experiment);
    EXPECT_FALSE(result.interrupted);
    EXPECT_FALSE(result.gl.renderer.empty());
    ASSERT_EQ(result.runs.size(), 3u);
    for (const RunMeasurement& run : result.runs) {
        SCOPED_TRACE(run.strategy.id);
        ASSERT_EQ(run.frames.size(), 3u);
        for (size_t pose = 0; pose < 3; ++pose) {
            const FrameMeasurement& frame = run.frames[pose];
            EXPECT_EQ(frame.pose, pose);
            EXPECT_EQ(frame.repetitions, 3);
            EXPECT_GT(frame.frameMilliseconds, 0.0);
            EXPECT_LE(frame.cullMilliseconds, frame.frameMilliseconds);
            ASSERT_TRUE(frame.accuracy.has_value());
            EXPECT_GT(frame.accuracy->coveredPixels, 0u);
            EXPECT_EQ(frame.accuracy->submittedTriangles, frame.consideredTriangles);
            EXPECT_EQ(frame.missedBeyondSnapping, 0u);
            EXPECT_TRUE(run.facing != run.referenceFacing || frame.accuracy->missedPixels == 0);
        }
        EXPECT_FALSE(run.promiseBroken());
        const Summary& summary = run.summary;
        EXPECT_LE(summary.fpsMin, summary.fpsOverall);
        EXPECT_LE(summary.fpsOverall, summary.fpsMean * (1 + 1e-12)) << "the harmonic mean is never above the arithmetic";
        EXPECT_LE(summary.fpsMean, summary.fpsMax);
        EXPECT_LE(summary.frameMillisecondsMedian, summary.frameMillisecondsP95);
        EXPECT_LE(summary.frameMillisecondsP95, summary.frameMillisecondsP99);
        EXPECT_GE(summary.cullShare, 0.0);
        EXPECT_LE(summary.cullShare, 1.0);
        EXPECT_LE(summary.speedupVsAllCi95[0], summary.speedupVsAll);
        EXPECT_GE(summary.speedupVsAllCi95[1], summary.speedupVsAll);
        ASSERT_TRUE(summary.missedPixelRate.has_value());
    }
    EXPECT_EQ(result.runs[0].summary.culledFraction, 0.0);
    EXPECT_GT(result.runs[1].summary.culledFraction, 0.1) << "the walk sees all of it";
    EXPECT_EQ(result.runs[0].summary.speedupVsAll, 1.0) << "a baseline against itself";
    EXPECT_EQ(result.runs[2].summary.speedupVsBackface, 1.0);
}

TEST(Measure, baselinesRunAlongUnasked) {
    const MeasureResult result = measure(smallExperiment({"frustum"}));
    ASSERT_EQ(result.runs.size(), 1u) << "baselines run along, but are not reported";
    EXPECT_GT(result.runs[0].summary.speedupVsAll, 0.0);
    EXPECT_GT(result.runs[0].summary.speedupVsBackface, 0.0);
}

TEST(Measure, accuracyIsNotMeasuredWhereItIsOff) {
    MeasureRequest experiment = smallExperiment({"all"});
    experiment.accuracy = false;
    const MeasureResult result = measure(experiment);
    EXPECT_FALSE(result.runs[0].frames[0].accuracy.has_value());
    EXPECT_FALSE(result.runs[0].summary.missedPixelRate.has_value());
    EXPECT_FALSE(result.runs[0].promiseBroken());
}

TEST(Measure, stopKeepsWhatWasMeasured) {
    // Stopped from the progress report of the third pose: two complete poses stay.
    std::stop_source source;
    Progress progress;
    progress.stop = source.get_token();
    int reports = 0;
    progress.report = [&](double share, std::string_view stage) {
        EXPECT_GE(share, 0.0);
        EXPECT_LE(share, 1.0);
        EXPECT_FALSE(stage.empty());
        if (++reports == 3) source.request_stop();
    };
    const MeasureResult result = measure(smallExperiment({"frustum", "all"}), progress);
    EXPECT_TRUE(result.interrupted);
    ASSERT_EQ(result.runs.size(), 2u);
    for (const RunMeasurement& run : result.runs) {
        EXPECT_EQ(run.frames.size(), 2u);
        EXPECT_GT(run.summary.fpsMean, 0.0);
    }
}

TEST(Measure, resultSoFarHasEveryPoseAndASummary) {
    size_t calls = 0;
    const MeasureResult result = measure(smallExperiment({"frustum", "all"}), {}, [&](const auto& resultSoFar) {
        const MeasureResult partial = resultSoFar();
        ++calls;
        EXPECT_EQ(partial.interrupted, calls < 3);
        EXPECT_FALSE(partial.gl.renderer.empty());
        ASSERT_EQ(partial.runs.size(), 2u);
        for (const RunMeasurement& run : partial.runs) {
            ASSERT_EQ(run.frames.size(), calls);
            EXPECT_EQ(run.frames.back().pose, calls - 1);
            EXPECT_GT(run.summary.fpsOverall, 0.0);
        }
    });
    EXPECT_EQ(calls, 3u);
    EXPECT_FALSE(result.interrupted);
}

TEST(Measure, stopAfterTheLastPoseDoesNotCountAsInterrupted) {
    std::stop_source source;
    Progress progress;
    progress.stop = source.get_token();
    size_t calls = 0;
    const MeasureResult result = measure(smallExperiment({"all"}), progress, [&](const auto&) {
        if (++calls == 3) source.request_stop();
    });
    EXPECT_FALSE(result.interrupted) << "everything was measured";
    EXPECT_EQ(result.runs[0].frames.size(), 3u);
}

TEST(Measure, stopBeforeTheFirstPoseGivesRunsWithoutFrames) {
    std::stop_source source;
    source.request_stop();
    Progress progress;
    progress.stop = source.get_token();
    const MeasureResult result = measure(smallExperiment({"frustum"}), progress);
    EXPECT_TRUE(result.interrupted);
    ASSERT_EQ(result.runs.size(), 1u);
    EXPECT_TRUE(result.runs[0].frames.empty());
}

TEST(Measure, nothingToMeasureIsRefused) {
    MeasureRequest noStrategies = smallExperiment({});
    EXPECT_THROW((void)measure(noStrategies), Error);
    MeasureRequest noPoses = smallExperiment({"all"});
    noPoses.path.poses.clear();
    EXPECT_THROW((void)measure(noPoses), Error);
    MeasureRequest noTriangles = smallExperiment({"all"});
    noTriangles.scene = std::make_shared<Scene>("empty", std::vector<MeshPointer>{}, std::vector<Instance>{});
    EXPECT_THROW((void)measure(noTriangles), Error);
}

TEST(Measure, windowsAndRepetitionsAreHeeded) {
    MeasureRequest experiment = smallExperiment({"all"});
    experiment.timing.fixedRepetitions = 0;
    experiment.timing.leastRepetitions = 3;
    experiment.timing.mostRepetitions = 5;
    experiment.windows = 4;
    const MeasureResult result = measure(experiment);
    for (const FrameMeasurement& frame : result.runs[0].frames) {
        EXPECT_GE(frame.repetitions, 3);
        EXPECT_LE(frame.repetitions, 5);
        EXPECT_EQ(frame.consideredTriangles, experiment.scene->triangleCount()) << "of one window";
    }
}

TEST(Measure, fewRepetitionsAreEnough) {
    MeasureRequest experiment = smallExperiment({"all"});
    experiment.timing.fixedRepetitions = 0;
    experiment.timing.leastRepetitions = 1;
    experiment.timing.mostRepetitions = 4;
    EXPECT_EQ(measure(experiment).runs[0].frames.size(), 3u);
}

TEST(RunMeasurement, brokenPromiseIsTold) {
    RunMeasurement run;
    run.promise = Promise::Conservative;
    run.frames.resize(2);
    EXPECT_FALSE(run.promiseBroken());
    run.frames[1].accuracy = Accuracy{};
    EXPECT_FALSE(run.promiseBroken());
    run.frames[1].accuracy->missedPixels = 1;
    EXPECT_TRUE(run.promiseBroken());
    run.promise = Promise::Exact;
    EXPECT_TRUE(run.promiseBroken());
    run.promise = Promise::Approximate;
    EXPECT_FALSE(run.promiseBroken());
    run.promise = Promise::Conservative;
    run.facing = Facing::Front;
    EXPECT_FALSE(run.promiseBroken()) << "front faces against both sides: only what snapping does not explain counts";
    run.frames[0].missedBeyondSnapping = 1;
    EXPECT_TRUE(run.promiseBroken());
}

}  // namespace
}  // namespace cullscope::test::meter_test
