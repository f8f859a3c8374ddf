#include "ui/jobs/experiment_runner.h"

#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include "core/base/error.h"
#include "tests/support/small_experiment.h"

namespace cullscope::ui::experiment_runner_test {
namespace {

constexpr int kPatience = 60'000;  // ms
constexpr int kTenthOfASecond = 100;

bool waitUntil(const std::function<bool()>& condition) { return QTest::qWaitFor(condition, kPatience); }

MeasureRequest request(const std::string& path, const std::vector<std::string>& strategies) {
    MeasureRequest request = test::smallExperiment(strategies);
    request.path = cameraPath(path, *request.scene);
    request.baselinesToo = true;
    return request;
}

/// An experiment with enough poses to stop it in the middle.
MeasureRequest longRequest() { return request("walk:5000", {"frustum"}); }

/// A runner with the signals that it emitted.
class Runner : public ::testing::Test {
protected:
    Runner() {
        QObject::connect(&runner, &ExperimentRunner::partial,
                         [this](const MeasureResult& result) { partials.push_back(result); });
        QObject::connect(&runner, &ExperimentRunner::finished,
                         [this](const MeasureResult& result) { results.push_back(result); });
        QObject::connect(&runner, &ExperimentRunner::failed, [this](const Message& message) { failures.push_back(message); });
        QObject::connect(&runner, &ExperimentRunner::cancelled, [this] { ++cancellations; });
    }

    GpuThread gpu;
    std::shared_ptr<StructureStore> structures = std::make_shared<StructureStore>();
    ExperimentRunner runner{&gpu, structures};
    std::vector<MeasureResult> partials, results;
    std::vector<Message> failures;
    int cancellations = 0;
};

TEST_F(Runner, measuresBesideTheWindowWithTheBaselines) {
    runner.start(request("walk:4", {"frustum"}));
    EXPECT_TRUE(runner.running());
    EXPECT_TRUE(results.empty()) << "start waited for the experiment";
    ASSERT_TRUE(waitUntil([this] { return !results.empty() || !failures.empty(); }));
    ASSERT_TRUE(failures.empty()) << failures.front().english();
    EXPECT_FALSE(runner.running());
    const MeasureResult& result = results.front();
    EXPECT_FALSE(result.interrupted);
    ASSERT_EQ(result.runs.size(), 3u);
    EXPECT_EQ(result.runs[0].strategy.id, "frustum");
    EXPECT_EQ(result.runs[1].strategy.id, "all");
    EXPECT_EQ(result.runs[2].strategy.id, "backface");
    for (const RunMeasurement& run : result.runs) {
        EXPECT_EQ(run.frames.size(), 4u);
        EXPECT_EQ(run.frames.front().repetitions, 3);
    }
}

TEST_F(Runner, baselineThatIsAskedForIsNotMeasuredTwice) {
    runner.start(request("walk:2", {"backface", "frustum", "all"}));
    ASSERT_TRUE(waitUntil([this] { return !results.empty(); }));
    EXPECT_EQ(results.front().runs.size(), 3u);
}

TEST_F(Runner, experimentsOfOneSceneShareItsStructuresUntilTheyAreLeft) {
    MeasureRequest experiment = request("walk:2", {"frustum"});
    const auto built = [&] {
        const size_t before = results.size();
        runner.start(experiment);
        EXPECT_TRUE(waitUntil([&] { return results.size() > before; }));
        return structures->built();
    };
    EXPECT_EQ(built(), 3u);
    experiment.windows = 2;
    EXPECT_EQ(built(), 3u);
    runner.leaveStructures();
    EXPECT_EQ(built(), 6u);
    experiment = request("walk:2", {"frustum"});
    EXPECT_EQ(built(), 9u) << "another scene";
}

TEST_F(Runner, showsThePosesMeasuredSoFarAtMostTenTimesASecond) {
    runner.start(longRequest());
    QElapsedTimer clock;
    clock.start();
    ASSERT_TRUE(waitUntil([this] { return partials.size() >= 4; }));
    // Four partial results are separated by three intervals.
    EXPECT_GE(clock.elapsed(), 3 * kTenthOfASecond - 20);
    for (size_t i = 0; i < partials.size(); ++i) {
        EXPECT_TRUE(partials[i].interrupted);
        ASSERT_FALSE(partials[i].runs.empty());
        EXPECT_GT(partials[i].runs[0].summary.fpsOverall, 0.0);
        EXPECT_GT(partials[i].runs[0].frames.size(), i == 0 ? 0 : partials[i - 1].runs[0].frames.size());
    }
}

TEST_F(Runner, cancelIsAnsweredAtOnceAndKeepsWhatWasMeasured) {
    runner.start(longRequest());
    ASSERT_TRUE(waitUntil([this] { return !partials.empty(); }));
    const size_t seen = partials.back().runs[0].frames.size();
    runner.cancel();
    EXPECT_FALSE(runner.running());
    EXPECT_EQ(cancellations, 1);
    const size_t partialsBefore = partials.size();
    ASSERT_TRUE(waitUntil([this] { return !results.empty(); }));
    EXPECT_TRUE(results.front().interrupted);
    EXPECT_GE(results.front().runs[0].frames.size(), seen);
    EXPECT_LT(results.front().runs[0].frames.size(), 5000u);
    EXPECT_EQ(partials.size(), partialsBefore) << "a partial result after the cancelling";
    runner.cancel();
    EXPECT_EQ(cancellations, 1) << "nothing was under way";
}

TEST_F(Runner, cancelBeforeTheFirstPoseGivesAnEmptyResult) {
    runner.start(longRequest());
    runner.cancel();
    ASSERT_TRUE(waitUntil([this] { return !results.empty() || !failures.empty(); }));
    EXPECT_TRUE(failures.empty());
    EXPECT_TRUE(results.front().interrupted);
    EXPECT_EQ(results.front().request.path.poses.size(), 5000u);
}

TEST_F(Runner, newerExperimentTakesThePlaceOfTheOlder) {
    runner.start(longRequest());
    ASSERT_TRUE(waitUntil([this] { return !partials.empty(); }));
    partials.clear();
    runner.start(request("orbit:3", {"all", "backface"}));
    ASSERT_TRUE(waitUntil([this] { return !results.empty(); }));
    ASSERT_EQ(results.size(), 1u);
    EXPECT_EQ(results.front().request.path.name, "orbit:3");
    EXPECT_FALSE(results.front().interrupted);
    for (const MeasureResult& partial : partials) EXPECT_EQ(partial.request.path.name, "orbit:3") << "stale";
}

TEST_F(Runner, cancelledExperimentIsSilentOnceAnotherWasStarted) {
    runner.start(longRequest());
    runner.cancel();
    runner.start(request("orbit:3", {"all"}));
    ASSERT_TRUE(waitUntil([this] { return !results.empty(); }));
    EXPECT_EQ(results.size(), 1u);
    EXPECT_EQ(results.front().request.path.name, "orbit:3");
}

TEST_F(Runner, whatCannotBeMeasuredIsOneSentence) {
    runner.start(request("walk:2", {}));
    ASSERT_TRUE(waitUntil([this] { return !results.empty(); })) << "the baselines alone can be measured";
    MeasureRequest empty = request("walk:2", {"all"});
    empty.path.poses.clear();
    runner.start(empty);
    ASSERT_TRUE(waitUntil([this] { return !failures.empty(); }));
    EXPECT_FALSE(runner.running());
    EXPECT_EQ(failures.front().english(), "The camera path has no poses.");
}

TEST_F(Runner, progressGrowsAndStaysBetweenNothingAndAll) {
    double last = 0.0;
    QString stages;
    QObject::connect(&runner, &ExperimentRunner::progressed, [&](double share, const QString& stage) {
        EXPECT_GE(share, last);
        EXPECT_LE(share, 1.0);
        last = share;
        stages += stage;
    });
    runner.start(longRequest());
    ASSERT_TRUE(waitUntil([&] { return last > 0.0 && !stages.isEmpty(); }));
}

/// The buffers that views draw are those of the experiment, and pictures need not wait for its end.
TEST_F(Runner, sharesTheUploadAndTheThread) {
    const MeasureRequest asked = longRequest();
    SceneBuffersPointer uploaded;
    gpu.run([&] { uploaded = gpu.upload(asked.scene); });
    runner.start(asked, uploaded);
    ASSERT_TRUE(waitUntil([this] { return !partials.empty(); }));
    bool drawn = false;
    gpu.post([&] { drawn = true; }, Urgency::Picture);
    ASSERT_TRUE(waitUntil([&] { return drawn; }));
    EXPECT_TRUE(runner.running()) << "the picture waited for the experiment";
    runner.cancel();
    ASSERT_TRUE(waitUntil([this] { return !results.empty(); }));
    EXPECT_TRUE(waitUntil([&] { return uploaded.use_count() == 1; })) << "the experiment keeps the buffers";
}

TEST(ExperimentRunner, mayBeDestroyedInTheMiddle) {
    GpuThread gpu;
    ExperimentRunner runner(&gpu, std::make_shared<StructureStore>());
    runner.start(longRequest());
    QTest::qWait(50);
}

}  // namespace
}  // namespace cullscope::ui::experiment_runner_test
