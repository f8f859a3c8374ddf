// What any culling could gain, and each strategy's share of it.
#include "core/measure/meter.h"
#include "core/measure/summary.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::headroom_test {
namespace {

TEST(Measure, limitGivesEveryRunAShareOfWhatCanBeSaved) {
    MeasureRequest experiment = smallExperiment({"frustum", "backface"});
    EXPECT_FALSE(measure(experiment).limit) << "not measured unasked";
    experiment.limitToo = true;
    for (const bool baselines : {false, true}) {
        experiment.baselinesToo = baselines;
        const MeasureResult result = measure(experiment);
        ASSERT_TRUE(result.limit);
        EXPECT_EQ(result.limit->strategy.id, limitOfCulling().id);
        EXPECT_EQ(result.limit->frames.size(), experiment.path.poses.size());
        for (const FrameMeasurement& frame : result.limit->frames) {
            ASSERT_TRUE(frame.accuracy) << "it is judged as the strategies are";
            EXPECT_EQ(frame.lostPixels, 0u);
        }
        EXPECT_EQ(result.runs.size(), baselines ? 4u : 2u);
        EXPECT_EQ(std::ranges::count(result.runs, limitOfCulling().id, [](const auto& run) { return run.strategy.id; }),
                  baselines ? 1 : 0);
        if (!result.limit->summary.headroomShare) continue;  // of such a small scene it is not certain that time can be saved
        EXPECT_NEAR(result.limit->summary.headroomShare->ratio, 1.0, 1e-12);
        for (const RunMeasurement& run : result.runs) EXPECT_TRUE(run.summary.headroomShare) << run.strategy.id;
    }
}

TEST(Summary, shareOfTheHeadroomIsThatOfTheTotalTimes) {
    const auto runOf = [](const std::string& id, std::vector<double> milliseconds) {
        RunMeasurement run;
        run.strategy = request(id);
        run.ownRule = request("all");
        for (const double time : milliseconds) {
            run.frames.emplace_back();
            run.frames.back().frameMilliseconds = time;
            run.frames.back().frameTimes = {time};
        }
        return run;
    };
    const std::vector<RunMeasurement> runs{runOf("frustum", {6.0, 6.0}), runOf("all", {10.0, 8.0}),
                                           runOf(limitOfCulling().id, {2.0, 1.0})};
    const ScenePointer scene = sceneOf({starMesh(7, 500)});
    const Summary summary = summaryOf(runs[0], runs, *scene);
    ASSERT_TRUE(summary.headroomShare);
    EXPECT_NEAR(summary.headroomShare->ratio, (1.0 - 12.0 / 18.0) / (1.0 - 3.0 / 18.0), 1e-12);
    EXPECT_FALSE(summaryOf(runs[0], {runs[0], runs[1]}, *scene).headroomShare) << "without the limit";
}

}  // namespace
}  // namespace cullscope::test::headroom_test
