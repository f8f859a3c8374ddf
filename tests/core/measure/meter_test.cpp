#include "core/measure/meter.h"

#include "core/base/error.h"
#include "core/measure/accuracy.h"
#include "core/measure/summary.h"
#include "tests/support/cut_scenes.h"
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
            ASSERT_EQ(frame.frameTimes.size(), 3u);
            EXPECT_EQ(frame.frameMilliseconds, quantile(frame.frameTimes, 0.5));
            EXPECT_GT(frame.frameMilliseconds, 0.0);
            EXPECT_LE(frame.cullMilliseconds, frame.frameMilliseconds);
            ASSERT_TRUE(frame.accuracy.has_value());
            EXPECT_GT(frame.accuracy->coveredPixels, 0u);
            EXPECT_EQ(frame.accuracy->submittedTriangles, frame.submitted.triangles);
            EXPECT_EQ(frame.submitted, (Submitted{frame.consideredTriangles, 0}));
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
        for (const RatioEstimate& ratio : {summary.ratioToTriangles, summary.ratioToFrontFaces, summary.speedupVsTriangles}) {
            EXPECT_LE(ratio.ci95[0], ratio.ratio);
            EXPECT_GE(ratio.ci95[1], ratio.ratio);
        }
        ASSERT_TRUE(summary.missedPixelRate.has_value());
    }
    EXPECT_EQ(result.runs[0].summary.culledFraction, 0.0);
    EXPECT_GT(result.runs[1].summary.culledFraction, 0.1) << "the walk sees all of it";
    const RatioEstimate one{1.0, {1.0, 1.0}};
    EXPECT_EQ(result.runs[0].summary.ratioToTriangles, one) << "a baseline against itself";
    EXPECT_EQ(result.runs[2].summary.ratioToFrontFaces, one);
    EXPECT_EQ(result.runs[0].summary.speedupVsTriangles, one);
}

TEST(Measure, baselinesRunAlongUnasked) {
    const MeasureResult result = measure(smallExperiment({"frustum"}));
    ASSERT_EQ(result.runs.size(), 1u) << "baselines run along, but are not reported";
    const Summary& summary = result.runs[0].summary;
    for (const RatioEstimate& ratio :
         {summary.ratioToTriangles, summary.ratioToFrontFaces, summary.speedupVsTriangles, summary.speedupVsFrontFaces})
        EXPECT_GT(ratio.ratio, 0.0);
}

TEST(Measure, baselinesThatAreWantedHaveRunsBehindTheOthers) {
    MeasureRequest experiment = smallExperiment({"backface", "frustum"});
    experiment.baselinesToo = true;
    const MeasureResult result = measure(experiment);
    ASSERT_EQ(result.runs.size(), 3u);
    ASSERT_EQ(result.request.strategies.size(), 3u) << "a command that repeats the result names them";
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(result.runs[i].strategy.id, (std::array{"backface", "frustum", "all"})[i]);
        EXPECT_EQ(result.request.strategies[i].id, result.runs[i].strategy.id);
        EXPECT_TRUE(result.runs[i].summary.missedPixelRate.has_value());
    }
    experiment.strategies.clear();
    EXPECT_EQ(measure(experiment).runs.size(), 2u) << "they alone";
}

TEST(Baselines, areBuiltOfOneRoleOrOfAll) {
    StructureStore structures;
    const MeasureRequest experiment = smallExperiment({"all", "frustum"});
    const auto built = [&](std::optional<BaselineRole> role) {
        std::vector<std::string> ids;
        for (const Contestant& baseline : baselinesBeside(experiment.strategies, experiment.scene, structures, role)) {
            EXPECT_FALSE(baseline.askedFor);
            EXPECT_EQ(baseline.strategy->scenePointer(), experiment.scene);
            ids.push_back(baseline.request.id);
        }
        return ids;
    };
    using Ids = std::vector<std::string>;
    EXPECT_EQ(built({}), Ids{"backface"});
    EXPECT_EQ(built(BaselineRole::FrontFaces), Ids{"backface"});
    EXPECT_EQ(built(BaselineRole::Triangles), Ids{}) << "which is asked for";
}

TEST(Baselines, areAddedWhereTheyAreMissing) {
    const auto missing = [](const std::vector<std::string>& ids) {
        std::vector<std::string> added;
        for (const StrategyRequest& baseline : missingBaselines(smallExperiment(ids).strategies)) added.push_back(baseline.id);
        return added;
    };
    using Ids = std::vector<std::string>;
    EXPECT_EQ(missing({}), (Ids{"all", "backface"}));
    EXPECT_EQ(missing({"frustum", "all"}), Ids{"backface"});
    EXPECT_EQ(missing({"backface", "frustum", "all"}), Ids{});
    for (const char* id : {"all", "backface"}) EXPECT_NE(findStrategy(id).info.baseline, BaselineRole::None) << id;
}

TEST(Summary, hasTheOneEstimateOverAllViewsAndTheMeanBesideIt) {
    const auto run = [](const std::string& id, const std::vector<std::vector<double>>& times) {
        RunMeasurement made;
        made.strategy = request(id);
        for (const std::vector<double>& view : times) {
            made.frames.emplace_back();
            made.frames.back().frameTimes = view;
            made.frames.back().frameMilliseconds = quantile(view, 0.5);
        }
        return made;
    };
    const std::vector<RunMeasurement> runs{run("all", {{40, 41, 44}, {4, 4, 5}}), run("frustum", {{10, 11, 10}, {0.1, 0.2, 0.1}}),
                                           run("backface", {{20, 22, 21}, {2, 2, 2}})};
    const Summary summary = summaryOf(runs[1], runs, *smallExperiment({}).scene);
    EXPECT_DOUBLE_EQ(summary.ratioToTriangles.ratio, (41 + 4) / (10 + 0.1));
    EXPECT_DOUBLE_EQ(summary.ratioToFrontFaces.ratio, (21 + 2) / (10 + 0.1));
    EXPECT_EQ(summary.ratioToFrontFaces, ratioOver(runs[2].frames, runs[1].frames));
    EXPECT_DOUBLE_EQ(summary.speedupVsTriangles.ratio, (41 / 10.0 + 4 / 0.1) / 2);
    EXPECT_DOUBLE_EQ(summary.speedupVsFrontFaces.ratio, (21 / 10.0 + 2 / 0.1) / 2);
    EXPECT_EQ(summaryOf(runs[1], {runs[1]}, *smallExperiment({}).scene).ratioToTriangles, RatioEstimate())
        << "nothing to compare with";
}

TEST(Meter, goesInStepsAndKeepsCompletePoses) {
    const MeasureRequest experiment = smallExperiment({"frustum"});
    StructureStore structures;
    Contestants contestants = buildContestants(experiment, GlEnvironment::info(), structures);
    ASSERT_EQ(contestants.strategies.size(), 3u) << "with the baselines";
    EXPECT_FALSE(contestants.strategies[2].askedFor);
    Meter meter(experiment, std::move(contestants), GlEnvironment::info(),
                std::make_shared<const SceneBuffers>(experiment.scene, experiment.upload));
    // A warm-up and three repetitions of each strategy, and then the losses of the one that was asked for.
    const size_t stepsOfAPose = 3 * (1 + 3) + 1;
    for (size_t steps = 0; !meter.complete(); ++steps) {
        ASSERT_EQ(meter.poses(), steps / stepsOfAPose);
        if (steps == stepsOfAPose + 5) {
            EXPECT_TRUE(meter.resultSoFar().interrupted);
            EXPECT_EQ(meter.resultSoFar().runs[0].frames.size(), 1u);
        }
        meter.step();
    }
    EXPECT_EQ(meter.poses(), 3u);
    EXPECT_FALSE(meter.resultSoFar().interrupted);
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

TEST(Summary, partsOfATriangleAreCulledOnceAndNeverMoreThanAll) {
    const ScenePointer scene = smallExperiment({}).scene;
    const uint64_t triangles = scene->triangleCount();
    RunMeasurement run;
    run.frames.resize(2);
    for (FrameMeasurement& frame : run.frames) frame.frameMilliseconds = 1.0;
    // Cut into more parts than the scene has triangles, of half of which nothing is drawn.
    run.frames[0].consideredTriangles = run.frames[1].consideredTriangles = 3 * triangles;
    run.frames[0].submitted = run.frames[1].submitted = {triangles / 2, 3 * triangles};
    EXPECT_NEAR(summaryOf(run, {run}, *scene).culledFraction, 0.5, 1.0 / double(triangles));
}

TEST(Measure, cutTrianglesAreSubmittedOnceAndTheirPartsAreCountedApart) {
    MeasureRequest experiment = smallExperiment({"bsp", "painter", "frustum"});
    experiment.scene = copiesOf(threeBars(), {translation({-2, 0, 0}), translation({2, 0, 0})});
    experiment.path = cameraPath("fibonacci:2", *experiment.scene);
    const uint64_t triangles = experiment.scene->triangleCount();
    const MeasureResult result = measure(experiment);
    for (const RunMeasurement& run : result.runs) {
        SCOPED_TRACE(run.strategy.id);
        const bool cuts = run.strategy.id != "frustum";
        for (const FrameMeasurement& frame : run.frames) {
            EXPECT_EQ(frame.submitted.triangles, triangles) << "all is in view";
            EXPECT_EQ(frame.submitted.triangles, frame.accuracy->submittedTriangles);
            EXPECT_EQ(frame.submitted.fragments, cuts ? frame.consideredTriangles : 0);
            if (cuts) {
                EXPECT_GT(frame.submitted.fragments, triangles);
            }
        }
        EXPECT_EQ(run.summary.culledFraction, 0.0);
    }
}

TEST(Measure, measurementsOfOneSceneShareItsUploadAndItsStructures) {
    MeasuredScene shared;
    MeasureRequest experiment = smallExperiment({"spherical-lossless", "frustum-octree"});
    const MeasureResult first = measure(experiment, {}, {}, &shared);
    EXPECT_EQ(shared.uploads(), 1u);
    EXPECT_EQ(shared.built(), 4u) << "the baselines among them";
    experiment.windows = 2;
    experiment.strategies.pop_back();
    experiment.strategies.front().parameters.set("cones", false);
    const MeasureResult second = measure(experiment, {}, {}, &shared);
    EXPECT_EQ(shared.uploads(), 1u);
    EXPECT_EQ(shared.built(), 4u) << "another parameter that is read when culling";
    EXPECT_EQ(first.runs[0].structure.buildMilliseconds, second.runs[0].structure.buildMilliseconds);
    experiment.strategies = {request("frustum-octree")};
    (void)measure(experiment, {}, {}, &shared);
    EXPECT_EQ(shared.built(), 4u) << "kept between measurements";
    experiment.upload = Upload::VertexArray;
    experiment.strategies = {request("all")};
    (void)measure(experiment, {}, {}, &shared);
    EXPECT_EQ(shared.uploads(), 2u) << "another format";
    experiment = smallExperiment({"all"});
    (void)measure(experiment, {}, {}, &shared);
    EXPECT_EQ(shared.uploads(), 3u) << "another scene";
    EXPECT_EQ(shared.built(), 6u);
}

TEST(Measure, resultSoFarHasEveryPoseAndASummary) {
    size_t calls = 0;
    const MeasureResult result = measure(smallExperiment({"frustum", "all"}), {}, [&](const Meter& meter) {
        const MeasureResult partial = meter.resultSoFar();
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
