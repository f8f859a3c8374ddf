// Measurements that go on without a strategy: one that refuses the scene or a view, and one that takes too long. And the order of
// the turns over a path.
#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/measure/meter.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::meter_refusals_test {
namespace {

using testing::ElementsAre;

struct Turns : ViewState {
    int drawn = 0;
    [[nodiscard]] std::unique_ptr<ViewState> clone() const override { return std::make_unique<Turns>(*this); }
};

/// Draws everything, so many frames long; none: cannot be built.
class Weary final : public StrategyWith<Structure, Turns> {
public:
    explicit Weary(int frames) : m_frames(frames) {}
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<Turns>(); }

protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {
        if (m_frames == 0) throwUsage("too large for this strategy");
    }
    void decide(FrameContext& frame, const Structure& /*structure*/, Turns& state,
                const ParameterSet& /*parameters*/) const override {
        if (++state.drawn > m_frames) throwUsage("tired");
        frame.draw(everything(frame.scene(), Facing::TwoSided));
    }
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }

private:
    int m_frames;
};

StrategyRequest weary(const std::string& id, int frames) {
    auto own = std::make_shared<RegisteredStrategy>();
    own->info.id = id;
    own->strategy = std::make_shared<Weary>(frames);
    return {id, ParameterSet(own->info.parameters), own};
}

/// Three poses, a warm-up before the first and one frame at each.
MeasureRequest onceAtEach(std::vector<StrategyRequest> strategies) {
    MeasureRequest experiment = smallExperiment({});
    experiment.strategies = std::move(strategies);
    experiment.timing.fixedRepetitions = 1;
    experiment.timing.warmUpOnce = true;
    return experiment;
}

std::vector<size_t> framesOf(const MeasureResult& result) {
    std::vector<size_t> frames;
    for (const RunMeasurement& run : result.runs) frames.push_back(run.frames.size());
    return frames;
}

TEST(Refusals, standInTheResultAndTheOthersGoOn) {
    MeasureRequest experiment = onceAtEach({weary("never", 0), weary("twice", 2), request("frustum"), weary("once", 1)});
    experiment.refusalsAreResults = true;
    const MeasureResult result = measure(experiment);
    EXPECT_FALSE(result.interrupted);
    ASSERT_EQ(result.runs.size(), 3u) << "what was not built has no run";
    EXPECT_THAT(framesOf(result), ElementsAre(1u, 3u, 0u)) << "the warm-up is a frame, too";
    std::vector<std::string> refused;
    for (const Refusal& refusal : result.refused) refused.push_back(refusal.strategy.id + ": " + refusal.why.english());
    EXPECT_THAT(refused, ElementsAre("never: too large for this strategy", "once: tired", "twice: tired"));
    EXPECT_GT(result.runs[0].summary.ratioToTriangles.ratio, 0.0) << "over the poses that it has";
    for (const RunMeasurement& run : result.runs)
        for (const FrameMeasurement& frame : run.frames) EXPECT_TRUE(frame.accuracy.has_value());
}

TEST(Refusals, endAMeasurementThatDoesNotAskForThem) {
    EXPECT_THROW((void)measure(onceAtEach({weary("never", 0)})), Error);
    EXPECT_THROW((void)measure(onceAtEach({weary("twice", 2)})), Error);
    EXPECT_THAT(framesOf(measure(onceAtEach({weary("always", 4)}))), ElementsAre(3u));
}

TEST(Refusals, ofAllStrategiesLeaveEmptyRuns) {
    MeasureRequest experiment = onceAtEach({weary("once", 1)});
    experiment.refusalsAreResults = true;
    experiment.secondsOfAStrategy = 0.0;
    const MeasureResult result = measure(experiment);
    EXPECT_FALSE(result.interrupted);
    EXPECT_THAT(framesOf(result), ElementsAre(0u));
}

TEST(SecondsOfAStrategy, endItsRunAfterThePoseInWhichTheyAreOver) {
    MeasureRequest experiment = onceAtEach({request("frustum"), request("frustum-octree")});
    experiment.timing.fixedRepetitions = 2;
    experiment.timing.madeUpTime = [](const BuiltStrategy& strategy) { return strategy.id() == "frustum" ? 250.0 : 10.0; };
    experiment.secondsOfAStrategy = 0.9;
    const MeasureResult result = measure(experiment);
    EXPECT_THAT(framesOf(result), ElementsAre(2u, 3u)) << "two frames of a quarter of a second at each pose";
    EXPECT_TRUE(result.refused.empty());
    EXPECT_FALSE(result.interrupted);
}

TEST(Turns, areReversedFromPoseToPoseAndWarmedUpOnce) {
    MeasureRequest experiment = onceAtEach({request("frustum")});
    std::string order;
    experiment.timing.madeUpTime = [&](const BuiltStrategy& strategy) {
        order += strategy.id().front();
        return 1.0;
    };
    (void)measure(experiment);
    // frustum, all and backface: the warm-up, and each of three poses.
    EXPECT_EQ(order,
              "baf"
              "fab"
              "baf"
              "fab");
    order.clear();
    experiment.timing.warmUpOnce = false;
    (void)measure(experiment);
    EXPECT_EQ(order,
              "baf"
              "fab"
              "fab"
              "baf"
              "baf"
              "fab");
}

TEST(Measure, keepsTheTimesOfCullsAndWhatFramesNeed) {
    MeasureRequest experiment = smallExperiment({"depth-buffer", "frustum-octree"});
    const MeasureResult result = measure(experiment);
    for (const RunMeasurement& run : result.runs)
        for (const FrameMeasurement& frame : run.frames) {
            ASSERT_EQ(frame.cullTimes.size(), 3u);
            EXPECT_EQ(frame.cullMilliseconds, quantile(frame.cullTimes, 0.5));
            EXPECT_GT(frame.nodesVisited, 0u);
            EXPECT_GT(frame.frameBytes, 0u);
        }
    const uint64_t pixels = uint64_t(experiment.size.width) * uint64_t(experiment.size.height);
    EXPECT_GE(result.runs[0].frames[0].frameBytes, 8 * pixels) << "its picture's depths and triangles";
}

}  // namespace
}  // namespace cullscope::test::meter_refusals_test
