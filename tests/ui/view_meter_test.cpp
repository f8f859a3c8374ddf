// The figures in a view's header: of which frames they are, and that they are those of a table and of cullbench.
#include "ui/session/view_meter.h"

#include <gtest/gtest.h>

#include <QTest>
#include <nlohmann/json.hpp>

#include "core/experiments/experiment.h"
#include "core/experiments/result_file.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/small_experiment.h"
#include "ui/models/metrics_words.h"
#include "ui/statistics/result_table_model.h"

namespace cullscope::ui::view_meter_test {
namespace {

constexpr int kPatience = 60'000;  // ms

struct Frames : ViewState {
    uint64_t drawn = 0;
    [[nodiscard]] std::unique_ptr<ViewState> clone() const override { return std::make_unique<Frames>(*this); }
};

/// The how manieth frame of its memory each decision was, in the order of the decisions.
using Noted = std::vector<uint64_t>;

/// Draws one triangle less in every frame of its memory, so that no two frames are alike, and notes its decisions. `unsteady`:
/// one less in every frame of all, so that not even the frames that repeat one are like it.
class Dwindling final : public StrategyWith<Structure, Frames> {
public:
    explicit Dwindling(std::shared_ptr<Noted> noted, bool unsteady) : m_noted(std::move(noted)), m_unsteady(unsteady) {}
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<Frames>(); }

protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
    void decide(FrameContext& frame, const Structure& /*structure*/, Frames& state,
                const ParameterSet& /*parameters*/) const override {
        m_noted->push_back(++state.drawn);
        DrawList list = everything(frame.scene(), Facing::TwoSided);
        list.ranges.front().indexCount -= uint32_t(3 * (m_unsteady ? m_noted->size() : state.drawn));
        frame.draw(std::move(list));
    }
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }

private:
    std::shared_ptr<Noted> m_noted;
    bool m_unsteady;
};

BuiltStrategyPointer dwindling(const ScenePointer& scene, std::shared_ptr<Noted> noted, bool unsteady = false) {
    RegisteredStrategy strategy;
    strategy.info.id = "dwindling";
    strategy.info.remembers = true;
    strategy.strategy = std::make_shared<Dwindling>(std::move(noted), unsteady);
    const ParameterSet parameters(strategy.info.parameters);
    return std::make_shared<const BuiltStrategy>(strategy, parameters, strategy.strategy->build(scene, parameters, {}));
}

/// Every strategy's n-th frame takes a made-up time: half as long again for `backface`, and never twice the same.
TimingProtocol madeUpTimes() {
    TimingProtocol protocol;
    protocol.warmUp = 0;  // of a view it is the frame that it shows
    protocol.fixedRepetitions = 7;
    protocol.madeUpTime = [counts = std::make_shared<std::map<std::string, int>>()](const BuiltStrategy& strategy) {
        const int frame = (*counts)[strategy.id()]++;
        return (strategy.id() == "backface" ? 6.0 : 4.0) + 0.25 * (frame * 5 % 7) + 0.01 * frame;
    };
    return protocol;
}

/// A meter of views, and the figures that it delivered.
class ViewMeterTest : public testing::Test {
protected:
    ViewMeterTest() {
        gpu.run([&] { buffers = gpu.upload(experiment.scene); });
    }

    [[nodiscard]] MetricsSubject subject(const BuiltStrategyPointer& strategy, size_t pose) const {
        return {buffers, strategy, experiment.path.camera(pose), experiment.size};
    }
    /// All that a meter says of a view, in its order.
    [[nodiscard]] std::vector<ViewMetrics> measured(const MetricsSubject& what, const TimingProtocol& protocol) {
        ViewMeter meter(gpu, frames, structures, protocol);
        std::vector<ViewMetrics> said;
        QObject::connect(&meter, &ViewMeter::measured, [&](int, const ViewMetrics& figures) { said.push_back(figures); });
        meter.measure({{0, what}});
        EXPECT_TRUE(QTest::qWaitFor([&] { return !said.empty() && said.back().timed; }, kPatience));
        return said;
    }

    /// The result of `cullbench measure`, in the GPU thread's context.
    [[nodiscard]] MeasureResult measuredOnPath() {
        MeasureResult result;
        gpu.run([&] { result = measure(experiment); });
        return result;
    }

    MeasureRequest experiment = test::smallExperiment({"frustum"});
    std::shared_ptr<StructureStore> structures = std::make_shared<StructureStore>();
    ViewFramesPointer frames = std::make_shared<ViewFrames>();
    GpuThread gpu;
    SceneBuffersPointer buffers;
};

TEST_F(ViewMeterTest, repeatsTheFrameThatTheViewShowsAndDecidesNoOtherThanThoseThatItTimes) {
    const auto noted = std::make_shared<Noted>();
    const BuiltStrategyPointer strategy = dwindling(experiment.scene, noted);
    TimingProtocol protocol;
    protocol.fixedRepetitions = 3;
    const uint64_t triangles = experiment.scene->triangleCount();
    // The second camera's frame has the first one's for its past.
    for (uint64_t frame = 1; frame <= 2; ++frame) {
        SCOPED_TRACE("frame " + std::to_string(frame));
        noted->clear();
        const MetricsSubject what = subject(strategy, frame);
        const FrameRequest request{what.buffers, what.strategy, what.culling, what.size, 0};
        ViewFramePointer shown;
        gpu.run([&] { shown = frames->of(request, gpu.renderer()); });
        const std::vector<ViewMetrics> said = measured(what, protocol);
        ASSERT_EQ(said.size(), 2u) << "the errors, and then the speed";
        EXPECT_FALSE(said[0].timed);
        EXPECT_FALSE(said[0].speedup.has_value());
        for (const ViewMetrics& figures : said) {
            EXPECT_EQ(figures.frame, shown) << "one log for picture, panels and states";
            EXPECT_EQ(figures.accuracy.submittedTriangles, triangles - frame);
            EXPECT_EQ(figures.consideredTriangles, triangles - frame);
            const auto& counts = figures.states->counts;
            EXPECT_EQ(counts[size_t(TriangleState::Visible)] + counts[size_t(TriangleState::InVain)], triangles - frame);
        }
        EXPECT_EQ(*noted, Noted(1 + 3, frame)) << "the frame that is shown, and three repetitions of it, which are timed";
        EXPECT_EQ(frames->decided(0), frame);
    }
}

TEST_F(ViewMeterTest, judgesTheFirstFrameThatItTimesAsATableDoesAndNotTheOneThatTheViewShows) {
    const auto noted = std::make_shared<Noted>();
    const MetricsSubject what = subject(dwindling(experiment.scene, noted, true), 0);
    TimingProtocol protocol;
    protocol.fixedRepetitions = 3;
    const uint64_t triangles = experiment.scene->triangleCount();
    for (const ViewMetrics& figures : measured(what, protocol)) {
        EXPECT_EQ(figures.frame->log.consideredTriangles(), triangles - 1) << "the frame of the picture and the panels";
        EXPECT_EQ(figures.accuracy.submittedTriangles, triangles - 2) << "the first timed one";
        EXPECT_EQ(figures.consideredTriangles, triangles - 2);
    }
    EXPECT_EQ(noted->size(), 1u + 3u);
}

TEST_F(ViewMeterTest, aFrameThatIsNotShownYetIsDecidedForTheFiguresAndIsTheOneOfThePicture) {
    const MetricsSubject what = subject(dwindling(experiment.scene, std::make_shared<Noted>()), 0);
    TimingProtocol protocol;
    protocol.fixedRepetitions = 1;
    const ViewMetrics figures = measured(what, protocol).back();
    ViewFramePointer shown;
    gpu.run([&] { shown = frames->of({what.buffers, what.strategy, what.culling, what.size, 0}, gpu.renderer()); });
    EXPECT_EQ(figures.frame, shown);
    EXPECT_EQ(frames->decided(0), 1u);
}

/// The times of a real measurement of one pose, played back in the order in which each strategy's frames took them.
TimingProtocol playedBack(const MeasureResult& recorded) {
    TimingProtocol protocol;
    protocol.warmUp = 0;
    auto times = std::make_shared<std::map<std::string, std::vector<double>>>();
    for (const RunMeasurement& run : recorded.runs) {
        (*times)[run.strategy.id] = run.frames.front().frameTimes;
        protocol.fixedRepetitions = run.frames.front().repetitions;
    }
    protocol.madeUpTime = [times, next = std::map<std::string, size_t>()](const BuiltStrategy& strategy) mutable {
        const std::vector<double>& own = times->at(strategy.id());
        return own.at(next[strategy.id()]++ % own.size());
    };
    return protocol;
}

TEST_F(ViewMeterTest, headersRatioIsTheTablesAndCullbenchsToTheDigitForTheSameRecordedFrames) {
    // What `cullbench measure` does: frames that were really drawn and timed, of two strategies beside the baselines.
    experiment.strategies = {test::request("frustum"), test::request("frustum-octree")};
    experiment.path.poses.resize(1);
    experiment.timing.fixedRepetitions = 7;
    experiment.baselinesToo = experiment.limitToo = true;
    const MeasureResult recorded = measuredOnPath();
    const auto json = nlohmann::json::parse(resultJson(recorded));
    // What a table does with the same frames.
    Experiment shown;
    shown.axes = {{"strategy", "strategy", Axis::Kind::Strategy, {std::string("frustum"), std::string("frustum-octree")}}};
    shown.settings = settingsOf(shown.axes);
    shown.columns = columnsOf(shown.axes);
    shown.columns.push_back({"ratio_to_same_sides", "ratio"});
    ResultTable table = emptyTable(shown);
    addRuns(table, shown, shown.settings.front(), recorded);
    for (size_t run = 0; run < 2; ++run) {
        const std::string& id = recorded.runs[run].strategy.id;
        const BuiltStrategyPointer strategy =
            buildStrategy(id, ParameterSet(findStrategy(id).info.parameters), experiment.scene, *structures);
        const ViewMetrics header = measured(subject(strategy, 0), playedBack(recorded)).back();
        ASSERT_TRUE(header.speedup.has_value());
        EXPECT_EQ(*header.speedup, recorded.runs[run].summary.ratioToOwnRule) << id;
        EXPECT_EQ(*header.speedup, std::get<RatioEstimate>(table.value(run, "ratio_to_same_sides"))) << id;
        EXPECT_EQ(json["runs"][run]["summary"]["ratio_to_same_sides"], header.speedup->ratio) << id;
        EXPECT_EQ(json["runs"][run]["summary"]["ratio_to_same_sides_ci95"], header.speedup->ci95) << id;
        EXPECT_EQ(resultRows(recorded)[run].speedup, header.speedup) << "the desktop's table";
        EXPECT_LT(header.speedup->ci95[0], header.speedup->ci95[1]) << "real times differ";
        ASSERT_TRUE(header.headroom.has_value()) << "what any culling could gain here at most, and its share";
        EXPECT_EQ(header.headroom->most, recorded.limit->summary.ratioToOwnRule) << id;
        EXPECT_EQ(header.headroom->share, recorded.runs[run].summary.headroomShare) << id;
        EXPECT_EQ(liveRows({{QStringLiteral("A"), {id, {}}, header.promise, header}})[0].headroomShare, header.headroom->share);
    }
}

TEST_F(ViewMeterTest, headersRatioIsThatOfATableAndOfCullbenchForTheSameView) {
    const CameraPath path = experiment.path;
    const BuiltStrategyPointer strategy =
        buildStrategy("frustum", ParameterSet(findStrategy("frustum").info.parameters), experiment.scene, *structures);
    std::vector<double> ratios;
    for (size_t pose = 0; pose < path.poses.size(); ++pose) {
        const ViewMetrics header = measured(subject(strategy, pose), madeUpTimes()).back();
        // cullbench measures by `measure` and writes `resultJson`.
        experiment.path.poses = {path.poses[pose]};
        experiment.timing = madeUpTimes();
        const MeasureResult table = measuredOnPath();
        experiment.path = path;
        ASSERT_TRUE(header.speedup.has_value());
        EXPECT_EQ(*header.speedup, table.runs[0].summary.ratioToOwnRule) << "at pose " << pose;
        EXPECT_EQ(resultRows(table).front().speedup, header.speedup);
        EXPECT_EQ(header.frameMilliseconds, table.runs[0].summary.frameMillisecondsMedian);
        const auto json = nlohmann::json::parse(resultJson(table));
        EXPECT_EQ(json["runs"][0]["summary"]["ratio_to_same_sides"], header.speedup->ratio);
        EXPECT_EQ(json["runs"][0]["summary"]["ratio_to_same_sides_ci95"], header.speedup->ci95);
        EXPECT_EQ(header.accuracy.missedPixels, table.runs[0].frames[0].accuracy->missedPixels);
        EXPECT_EQ(header.submitted, table.runs[0].frames[0].submitted);
        EXPECT_DOUBLE_EQ(header.submittedShare(), 1.0 - table.runs[0].summary.culledFraction);
        // The better a strategy's × is, the more frames it draws in a second beside the same baseline.
        EXPECT_GT(header.speedup->ratio, 1.0);
        EXPECT_LT(header.speedup->ci95[0], header.speedup->ci95[1]);
        ratios.push_back(header.speedup->ratio);
    }
    // Over all views the table has one ratio of total times, which lies among those of the views.
    experiment.timing = madeUpTimes();
    const double all = measuredOnPath().runs[0].summary.ratioToOwnRule.ratio;
    EXPECT_GE(all, *std::ranges::min_element(ratios) - 0.1);
    EXPECT_LE(all, *std::ranges::max_element(ratios) + 0.1);
}

TEST_F(ViewMeterTest, headersSubmittedShareIsThatOfATableAndOfAResultFileThoughTrianglesAreCut) {
    experiment.scene = test::copiesOf(test::threeBars(), {test::translation({-2, 0, 0}), test::translation({2, 0, 0})});
    gpu.run([&] { buffers = gpu.upload(experiment.scene); });
    experiment.strategies = {test::request("bsp")};
    experiment.path = cameraPath("fibonacci:1", *experiment.scene);
    experiment.timing = madeUpTimes();
    const BuiltStrategyPointer strategy =
        buildStrategy("bsp", ParameterSet(findStrategy("bsp").info.parameters), experiment.scene, *structures);
    const ViewMetrics header = measured(subject(strategy, 0), madeUpTimes()).back();
    const MeasureResult table = measuredOnPath();
    EXPECT_GT(header.submitted.fragments, header.sceneTriangles);
    EXPECT_EQ(header.submittedShare(), 1.0);
    EXPECT_TRUE(metricsLine(header).contains(QStringLiteral("100"))) << metricsLine(header).toStdString();
    EXPECT_EQ(header.submitted, table.runs[0].frames[0].submitted);
    EXPECT_EQ(resultRows(table).front().submittedShare, header.submittedShare());
    const auto frame = nlohmann::json::parse(resultJson(table))["runs"][0]["frames"][0];
    EXPECT_EQ(frame["submitted_triangles"], header.submitted.triangles);
    EXPECT_EQ(frame["submitted_fragments"], header.submitted.fragments);
}

}  // namespace
}  // namespace cullscope::ui::view_meter_test
