// Views measured together: which frame is judged, which are timed, and which take turns as one.
#include "core/measure/view_rounds.h"

#include <algorithm>

#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::view_rounds_test {
namespace {

struct Frames : ViewState {
    uint32_t drawn = 0;
    [[nodiscard]] std::unique_ptr<ViewState> clone() const override { return std::make_unique<Frames>(*this); }
};

/// A decision that was made: the how manieth frame of its memory, and whether it was recorded.
using Noted = std::vector<std::pair<uint32_t, bool>>;

/// Leaves the last object out, and of the first one a triangle more in every frame of its memory, so that no two frames are
/// alike; `unsteady`: in every frame of all, so that not even the frames that repeat one are like it.
class Dwindling final : public StrategyWith<Structure, Frames> {
public:
    explicit Dwindling(std::shared_ptr<Noted> noted, bool unsteady) : m_noted(std::move(noted)), m_unsteady(unsteady) {}
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<Frames>(); }

protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
    void decide(FrameContext& frame, const Structure& /*structure*/, Frames& state,
                const ParameterSet& /*parameters*/) const override {
        m_noted->emplace_back(++state.drawn, frame.recording());
        DrawList list = everything(frame.scene(), Facing::TwoSided);
        list.ranges.pop_back();
        list.ranges.front().indexCount -= 3 * (m_unsteady ? uint32_t(m_noted->size()) : state.drawn);
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

BuiltStrategyPointer dwindling(const ScenePointer& scene, const std::shared_ptr<Noted>& noted, bool unsteady = false) {
    RegisteredStrategy strategy;
    strategy.info.id = "dwindling";
    strategy.info.remembers = true;
    strategy.strategy = std::make_shared<Dwindling>(noted, unsteady);
    const ParameterSet parameters(strategy.info.parameters);
    return std::make_shared<const BuiltStrategy>(strategy, parameters, strategy.strategy->build(scene, parameters, {}));
}

class Views : public testing::Test {
protected:
    Views() : experiment(smallExperiment({})), buffers(std::make_shared<SceneBuffers>(experiment.scene, Upload::Vbo)) {
        protocol.fixedRepetitions = 3;
        protocol.madeUpTime = [this](const BuiltStrategy& strategy) {
            turns.push_back(strategy.id());
            return 1.0;
        };
        baseline = ViewBaselines().under(Facing::Front, experiment.scene, structures);
    }

    [[nodiscard]] View view(size_t pose = 0) const { return {experiment.path.camera(pose), experiment.size}; }
    [[nodiscard]] BuiltStrategyPointer built(const std::string& id) {
        return buildStrategy(id, ParameterSet(findStrategy(id).info.parameters), experiment.scene, structures);
    }
    /// A view that shows a frame of a strategy, decided with a copy of `memory`.
    [[nodiscard]] ViewSubject shown(const BuiltStrategyPointer& strategy, const View& at, ViewStatePointer memory) const {
        const ViewStatePointer after = memory->clone();
        GpuFrame frame(GlEnvironment::renderer(), *buffers, at, true);
        strategy->draw(frame, *after);
        ViewSubject subject{buffers, strategy, at, {}};
        subject.memories.push_back(std::move(memory));
        subject.shown = std::make_shared<const FrameLog>(frame.take());
        subject.baseline = baseline;
        return subject;
    }
    /// Measures; `judged` says which subjects were judged in which steps, from 1.
    [[nodiscard]] ViewRounds measured(std::vector<ViewSubject> subjects) {
        ViewRounds rounds(std::move(subjects), protocol);
        for (size_t step = 1; !rounds.complete(); ++step)
            if (const auto subject = rounds.step(GlEnvironment::renderer(), references, targetOf))
                judged.emplace_back(step, *subject);
        return rounds;
    }

    MeasureRequest experiment;
    std::shared_ptr<const SceneBuffers> buffers;
    StructureStore structures;
    BuiltStrategyPointer baseline;
    TimingProtocol protocol;
    References references;
    Framebuffer target{experiment.size};
    TimedRounds::TargetOf targetOf = [this](const Viewport&, size_t) -> Framebuffer& { return target; };
    std::vector<std::pair<size_t, size_t>> judged;
    std::vector<std::string> turns;  ///< whose frame was timed, the warm-up among them
};

TEST_F(Views, theFirstTimedFrameIsJudgedWithTheShownOnesMemoryBeforeTheOthers) {
    const auto noted = std::make_shared<Noted>();
    const BuiltStrategyPointer strategy = dwindling(experiment.scene, noted);
    auto memory = std::make_unique<Frames>();
    memory->drawn = 4;  // a past
    std::vector<ViewSubject> subjects;
    subjects.push_back(shown(strategy, view(), std::move(memory)));
    const std::shared_ptr<const FrameLog> log = subjects.front().shown;
    const ViewRounds rounds = measured(std::move(subjects));
    EXPECT_EQ(*noted, (Noted{{5, true}, {5, false}, {5, false}, {5, false}})) << "the shown frame, and three that are timed";
    EXPECT_EQ(judged, (std::vector<std::pair<size_t, size_t>>{{4, 0}})) << "its errors are known before its speed is";
    EXPECT_EQ(turns, (std::vector<std::string>{"backface",  // the warm-up of the one that no view shows
                                               "dwindling", "backface", "backface", "dwindling", "dwindling", "backface"}));
    ViewFigures figures = rounds.figures(0);
    EXPECT_EQ(figures.consideredTriangles, log->consideredTriangles());
    EXPECT_EQ(figures.submitted, submittedBy(*experiment.scene, *log));
    const auto& counts = figures.states->counts;
    EXPECT_EQ(counts[size_t(TriangleState::Visible)] + counts[size_t(TriangleState::InVain)], log->consideredTriangles());
    EXPECT_FALSE(figures.timed);
    rounds.addTimes(0, figures);
    EXPECT_TRUE(figures.timed);
    EXPECT_EQ(figures.frameMilliseconds, 1.0);
    EXPECT_EQ(figures.speedup->ratio, 1.0);
}

TEST_F(Views, theJudgedFrameIsTheTimedOneAndNotTheOneThatIsShown) {
    const auto noted = std::make_shared<Noted>();
    std::vector<ViewSubject> subjects;
    const BuiltStrategyPointer strategy = dwindling(experiment.scene, noted, true);
    subjects.push_back(shown(strategy, view(), strategy->begin()));
    const uint64_t ofShownFrame = subjects.front().shown->consideredTriangles();
    const ViewRounds rounds = measured(std::move(subjects));
    EXPECT_EQ(noted->size(), 4u);
    const ViewFigures& figures = rounds.figures(0);
    EXPECT_EQ(figures.accuracy.submittedTriangles, ofShownFrame - 1);
    EXPECT_EQ(figures.consideredTriangles, ofShownFrame - 1);
    EXPECT_EQ(figures.submitted.triangles, ofShownFrame - 1);
    EXPECT_EQ(rounds.measurement(0).accuracy->submittedTriangles, ofShownFrame - 1) << "as a table has it";
    const auto& counts = figures.states->counts;
    EXPECT_EQ(counts[size_t(TriangleState::Visible)] + counts[size_t(TriangleState::InVain)], ofShownFrame)
        << "the states colour the picture, which is of the shown frame";
}

TEST_F(Views, lostObjectsAndHolesAreOfTheFrameThatIsJudged) {
    std::vector<ViewSubject> subjects;
    const BuiltStrategyPointer strategy = dwindling(experiment.scene, std::make_shared<Noted>());
    // From where the object that is left out lies in the middle.
    const auto last = uint32_t(experiment.scene->instances().size() - 1);
    Camera camera = experiment.path.camera(0);
    camera.target = experiment.scene->instanceSphere(last).centre;
    camera.eye = camera.target + Vec3(0.0, 6.0, 0.1);
    subjects.push_back(shown(strategy, View(camera, experiment.size), strategy->begin()));
    const ViewRounds rounds = measured(std::move(subjects));
    const ViewFigures& figures = rounds.figures(0);
    ASSERT_FALSE(figures.lostObjects.empty());
    EXPECT_EQ(figures.lostObjects.front().instance, last) << "most pixels first";
    uint64_t ofObjects = 0, ofHoles = 0;
    for (const LostObject& object : figures.lostObjects) ofObjects += object.pixels;
    for (const Hole& hole : figures.holes) ofHoles += hole.pixels;
    EXPECT_GT(figures.accuracy.missedPixels, 100u);
    EXPECT_EQ(ofObjects, figures.accuracy.missedPixels);
    EXPECT_EQ(ofHoles, figures.accuracy.missedPixels);
    EXPECT_EQ(figures.holes.front().pixels, figures.accuracy.largestHolePixels);
}

TEST_F(Views, withoutAShownFrameTheFirstCountedOneIsJudgedInTheEnd) {
    const auto noted = std::make_shared<Noted>();
    std::vector<ViewSubject> subjects;
    subjects.push_back({buffers, dwindling(experiment.scene, noted), view(), {}});
    subjects.back().memories.push_back(subjects.back().strategy->begin());
    ViewRounds rounds = measured(std::move(subjects));
    EXPECT_EQ(*noted, (Noted{{1, false}, {1, false}, {1, false}, {1, false}})) << "a warm-up, and three that count";
    EXPECT_EQ(judged, (std::vector<std::pair<size_t, size_t>>{{5, 0}}));
    const FrameMeasurement figures = rounds.measurement(0);
    EXPECT_EQ(figures.accuracy->submittedTriangles, figures.consideredTriangles);
    EXPECT_GT(figures.accuracy->coveredPixels, 0u);
    EXPECT_EQ(static_cast<const Frames&>(*rounds.takeMemories(0).front()).drawn, 1u);
}

TEST_F(Views, theSameWorkTakesItsTurnsOnceAndEachViewIsJudgedAfterTheFirst) {
    const BuiltStrategyPointer frustum = built("frustum"), remembering = dwindling(experiment.scene, std::make_shared<Noted>());
    std::vector<ViewSubject> subjects;
    for (const BuiltStrategyPointer& strategy : {frustum, baseline, frustum, remembering, remembering})
        subjects.push_back(shown(strategy, view(), strategy->begin()));
    subjects.push_back(shown(frustum, view(1), frustum->begin()));
    subjects.back().judged = false;
    (void)measured(std::move(subjects));
    // The first turn: the warm-up of the other place's baseline, then the six that are timed.
    EXPECT_EQ(judged, (std::vector<std::pair<size_t, size_t>>{{8, 0}, {9, 1}, {10, 2}, {11, 3}, {12, 4}}));
    // The baseline of the first place is a view's own; that of the second place has a warm-up.
    EXPECT_EQ(std::ranges::count(turns, "frustum"), 3 * 2) << "at two places";
    EXPECT_EQ(std::ranges::count(turns, "backface"), 3 * 2 + 1);
    EXPECT_EQ(std::ranges::count(turns, "dwindling"), 3 * 2) << "each with its own memory";
}

/// The triangles that a frame drew, each command by itself.
std::vector<TriangleIntervals> drawnBy(const Scene& scene, const FrameLog& log) {
    std::vector<TriangleIntervals> drawn{submittedIntervals(scene, drawnTriangles(scene, log))};
    for (const Command& command : log.commands)
        if (const auto* list = std::get_if<DrawList>(&command)) drawn.push_back(submittedIntervals(scene, *list));
    return drawn;
}

TEST_F(Views, everyStrategysTimedFrameRepeatsTheRecordedOneThatIsShown) {
    std::vector<StrategyRequest> requests{request("octree-query")};
    requests.front().parameters.setFromText("latency", "1");
    for (const RegisteredStrategy& registered : strategies())
        if (!unavailable(registered.info, GlEnvironment::info())) requests.push_back(request(registered.info.id));
    for (const StrategyRequest& asked : requests) {
        SCOPED_TRACE(asked.id);
        const BuiltStrategyPointer strategy = buildStrategy(asked.id, asked.parameters, experiment.scene, structures);
        ViewStatePointer memory = strategy->begin();
        for (size_t pose = 0; pose < 3; ++pose) {
            ViewSubject subject = shown(strategy, view(pose), std::move(memory));
            TimedFrames timed{buffers.get(), strategy, subject.view, std::move(subject.memories), true};
            std::vector<TimedFrames> entrants;
            entrants.push_back(std::move(timed));
            TimedRounds rounds(std::move(entrants), protocol);
            while (!rounds.complete()) rounds.step(GlEnvironment::renderer(), targetOf);
            TimedFrames& entrant = rounds.entrants().front();
            EXPECT_TRUE(subject.shown->recorded && !entrant.log.recorded);
            EXPECT_EQ(entrant.log.commands.size(), subject.shown->commands.size());
            EXPECT_EQ(drawnBy(*experiment.scene, entrant.log), drawnBy(*experiment.scene, *subject.shown)) << "at pose " << pose;
            memory = std::move(entrant.takeMemories().front());
        }
    }
}

}  // namespace
}  // namespace cullscope::test::view_rounds_test
