#include <gtest/gtest.h>

#include "core/measure/frame_measurement.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::meter_rounds_test {
namespace {

/// A memory that counts the frames drawn with it and its ancestors.
struct Count : ViewState {
    int frames = 0;
    [[nodiscard]] std::unique_ptr<ViewState> clone() const override { return std::make_unique<Count>(*this); }
};

/// Draws nothing and counts.
class Counting final : public StrategyWith<Structure, Count> {
public:
    [[nodiscard]] ViewStatePointer begin(const Structure& /*structure*/) const override { return std::make_unique<Count>(); }

protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
    void decide(FrameContext& /*frame*/, const Structure& /*structure*/, Count& state,
                const ParameterSet& /*parameters*/) const override {
        ++state.frames;
    }
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Approximate;
    }
};

BuiltStrategyPointer counting(const ScenePointer& scene, bool remembers) {
    RegisteredStrategy strategy;
    strategy.info.id = "counting";
    strategy.info.remembers = remembers;
    strategy.strategy = std::make_shared<Counting>();
    const ParameterSet parameters(strategy.info.parameters);
    return std::make_shared<const BuiltStrategy>(strategy, parameters, strategy.strategy->build(scene, parameters, {}));
}

int framesOf(const ViewStatePointer& memory) { return static_cast<const Count&>(*memory).frames; }

/// Entrants of which the second's picture is twice and the third's three times as wide as the first's.
class Rounds : public testing::Test {
protected:
    Rounds() : experiment(smallExperiment({"all"})), buffers(experiment.scene, Upload::Vbo) {}

    void add(const BuiltStrategyPointer& strategy, size_t windows = 1) {
        const View view(experiment.path.camera(0), {8 * (int(entrants.size()) + 1), 8});
        entrants.push_back({&buffers, strategy, view, {}});
        for (size_t i = 0; i < windows; ++i) entrants.back().memories.push_back(strategy->begin());
    }
    /// Runs the rounds to their end; `order` and `pictures` say whose frames were drawn, and into which pictures of them.
    TimedRounds run(const TimingProtocol& protocol) {
        TimedRounds rounds(std::move(entrants), protocol);
        while (!rounds.complete()) step(rounds);
        return rounds;
    }
    void step(TimedRounds& rounds) {
        rounds.step(GlEnvironment::renderer(), [this](const Viewport& size, size_t picture) -> Framebuffer& {
            order += char('A' + size.width / 8 - 1);
            pictures.push_back(picture);
            targets.push_back(std::make_unique<Framebuffer>(size));
            return *targets.back();
        });
    }

    MeasureRequest experiment;
    SceneBuffers buffers;
    std::vector<TimedFrames> entrants;
    std::string order;
    std::vector<size_t> pictures;
    std::vector<std::unique_ptr<Framebuffer>> targets;
};

TEST_F(Rounds, everyOtherRoundRunsBackwards) {
    for (int i = 0; i < 3; ++i) add(counting(experiment.scene, false));
    TimingProtocol protocol;
    protocol.fixedRepetitions = 3;
    TimedRounds rounds = run(protocol);
    EXPECT_EQ(order,
              "CBA"
              "ABC"
              "CBA"
              "ABC")
        << "a warm-up and three rounds";
    for (const TimedFrames& entrant : rounds.entrants()) {
        EXPECT_EQ(entrant.frameMilliseconds.size(), 3u) << "the warm-up does not count";
        EXPECT_EQ(entrant.cullMilliseconds.size(), 3u);
    }
    rounds.step(GlEnvironment::renderer(), [](const Viewport&, size_t) -> Framebuffer& { throw std::logic_error("drawn"); });
}

TEST_F(Rounds, goOnWithoutAnEntrantThatIsDropped) {
    for (int i = 0; i < 3; ++i) add(counting(experiment.scene, false));
    TimingProtocol protocol;
    protocol.fixedRepetitions = 2;
    TimedRounds rounds(std::move(entrants), protocol);
    step(rounds);
    EXPECT_EQ(rounds.next(), 1u);
    rounds.dropNext();
    while (!rounds.complete()) step(rounds);
    EXPECT_EQ(order, "CAACCA") << "the warm-up begins with the last one";
    EXPECT_TRUE(rounds.entrants()[1].dropped);
    EXPECT_EQ(rounds.entrants()[0].frameMilliseconds.size(), 2u);
    EXPECT_TRUE(rounds.entrants()[1].frameMilliseconds.empty());
    entrants.clear();
    add(counting(experiment.scene, false));
    TimedRounds alone(std::move(entrants), protocol);
    alone.dropNext();
    EXPECT_TRUE(alone.complete()) << "nothing is left";
}

TEST_F(Rounds, nothingToTimeIsComplete) { EXPECT_TRUE(run({}).entrants().empty()); }

TEST_F(Rounds, aBudgetEndsThemAfterTheLeast) {
    add(counting(experiment.scene, false));
    TimingProtocol protocol;
    protocol.leastRepetitions = 4;
    protocol.budgetSeconds = 0.0;
    EXPECT_EQ(run(protocol).entrants()[0].frameMilliseconds.size(), 4u);
}

TEST_F(Rounds, unsteadyTimesEndWithTheMost) {
    add(counting(experiment.scene, false));
    TimingProtocol protocol;
    protocol.warmUp = 0;
    protocol.mostRepetitions = 7;
    protocol.steadyWithin = -1.0;
    EXPECT_EQ(run(protocol).entrants()[0].frameMilliseconds.size(), 7u);
    EXPECT_EQ(order, "AAAAAAA");
}

TEST_F(Rounds, steadyOrLongFramesEndThemWithTheLeast) {
    TimingProtocol steady;
    steady.steadyWithin = 1e9;
    TimingProtocol longFrames;
    longFrames.steadyWithin = -1.0;
    longFrames.longFrameMilliseconds = 0.0;
    longFrames.leastRepetitions = 5;
    add(counting(experiment.scene, false));
    EXPECT_EQ(run(steady).entrants()[0].frameMilliseconds.size(), 3u);
    entrants.clear();
    add(counting(experiment.scene, false));
    EXPECT_EQ(run(longFrames).entrants()[0].frameMilliseconds.size(), 5u);
}

TEST_F(Rounds, whatRemembersDrawsEveryRepetitionWithTheMemoryThatItCameWith) {
    add(counting(experiment.scene, true));
    add(counting(experiment.scene, false));
    TimingProtocol protocol;
    protocol.fixedRepetitions = 3;
    TimedRounds rounds = run(protocol);
    const std::vector<ViewStatePointer> remembered = rounds.entrants()[0].takeMemories();
    ASSERT_EQ(remembered.size(), 1u);
    EXPECT_EQ(framesOf(remembered[0]), 1) << "repetitions of one frame";
    const std::vector<ViewStatePointer> others = rounds.entrants()[1].takeMemories();
    ASSERT_EQ(others.size(), 1u);
    EXPECT_EQ(framesOf(others[0]), 4);
}

TEST_F(Rounds, theFirstCountedFrameIsTheOneThatIsJudged) {
    add(counting(experiment.scene, true));
    TimingProtocol protocol;
    protocol.fixedRepetitions = 3;
    protocol.madeUpTime = [turn = 0.0](const BuiltStrategy&) mutable { return turn++; };
    TimedRounds rounds(std::move(entrants), protocol);
    Framebuffer target(Viewport{8, 8});
    const auto step = [&] {
        rounds.step(GlEnvironment::renderer(), [&](const Viewport&, size_t) -> Framebuffer& { return target; });
    };
    step();
    EXPECT_FALSE(rounds.counted()) << "the warm-up";
    step();
    EXPECT_TRUE(rounds.counted());
    const double culled = rounds.entrants()[0].log.cullMilliseconds;
    while (!rounds.complete()) step();
    EXPECT_EQ(rounds.entrants()[0].frameMilliseconds, (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(rounds.entrants()[0].log.cullMilliseconds, culled);
    EXPECT_EQ(rounds.entrants()[0].cullMilliseconds.front(), culled);
    EXPECT_EQ(measurementOf(rounds.entrants()[0]).frameMilliseconds, 2.0);
}

TEST_F(Rounds, aFrameHasSeveralPictures) {
    add(counting(experiment.scene, true), 4);
    TimingProtocol protocol;
    protocol.warmUp = 0;
    protocol.fixedRepetitions = 2;
    TimedRounds rounds = run(protocol);
    EXPECT_EQ(pictures, (std::vector<size_t>{0, 1, 2, 3, 0, 1, 2, 3}));
    EXPECT_EQ(rounds.entrants()[0].frameMilliseconds.size(), 2u);
    for (const ViewStatePointer& memory : rounds.entrants()[0].takeMemories()) EXPECT_EQ(framesOf(memory), 1);
}

}  // namespace
}  // namespace cullscope::test::meter_rounds_test
