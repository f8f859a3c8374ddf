// The log of a frame: its entries are one sequence, its replay is the frame's picture, and recording changes nothing.

#include "core/mesh/parametric.h"
#include "tests/support/decisions.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/random_views.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test::frames_test {
namespace {

/// Large enough that `spherical-lossless` tests cells; some objects are outside, some are cut.
ScenePointer field() {
    std::vector<Mat4> places;
    for (int i = 0; i < 25; ++i) places.push_back(translation({2.5 * (i % 5) - 5, 0.1 * i, 2.5 * (i / 5) - 5}));
    return copiesOf(starMesh(7, fewSamples() ? 1'000 : 3'000), places);
}

View inTheField() { return {{{0.5, 2, 7}, {0, 0.5, 0}, {0, 1, 0}, Angle::fromDegrees(40), 0.5, 100}, {160, 120}}; }

bool isAvailable(const RegisteredStrategy& registered) { return !unavailable(registered.info, GlEnvironment::info()); }

/// The random sizes go up to 16384 × 1.
Viewport small(const Viewport& size) { return {std::min(size.width, 96), std::min(size.height, 64)}; }

void expectSame(const Command& a, const Command& b) {
    ASSERT_EQ(a.index(), b.index());
    if (const auto* list = std::get_if<DrawList>(&a)) {
        const auto& other = std::get<DrawList>(b);
        EXPECT_EQ(list->ranges, other.ranges);
        EXPECT_EQ(list->facing, other.facing);
        EXPECT_EQ(list->order, other.order);
        EXPECT_EQ(list->depth, other.depth);
    } else if (const auto* own = std::get_if<OwnTrianglesPointer>(&a)) {
        const OwnTriangles& other = *std::get<OwnTrianglesPointer>(b);
        EXPECT_EQ((*own)->triangles, other.triangles);
        EXPECT_TRUE((*own)->positions == other.positions && (*own)->normals == other.normals);
        EXPECT_EQ((*own)->facing, other.facing);
        EXPECT_EQ((*own)->depth, other.depth);
        ASSERT_EQ((*own)->runs.size(), other.runs.size());
        for (size_t i = 0; i < other.runs.size(); ++i) {
            EXPECT_EQ((*own)->runs[i].instance, other.runs[i].instance);
            EXPECT_EQ((*own)->runs[i].first, other.runs[i].first);
            EXPECT_EQ((*own)->runs[i].count, other.runs[i].count);
        }
    } else if (const auto* asked = std::get_if<AskedBoxes>(&a)) {
        EXPECT_EQ(asked->question, std::get<AskedBoxes>(b).question);
        EXPECT_EQ(asked->boxes.size(), std::get<AskedBoxes>(b).boxes.size());
        EXPECT_EQ(asked->hits, std::get<AskedBoxes>(b).hits);
        EXPECT_EQ(asked->ends, std::get<AskedBoxes>(b).ends);
    } else if (const auto* shown = std::get_if<FinishedPicturePointer>(&a)) {
        EXPECT_EQ((*shown)->triangle, std::get<FinishedPicturePointer>(b)->triangle);
        EXPECT_EQ((*shown)->depth, std::get<FinishedPicturePointer>(b)->depth);
    } else {
        ADD_FAILURE() << "no strategy has this command";
    }
}

void expectSameFrame(const FrameLog& a, const FrameLog& b) {
    EXPECT_EQ(a.facing, b.facing);
    EXPECT_EQ(a.counters.culledTriangles, b.counters.culledTriangles);
    EXPECT_EQ(a.counters.nodesVisited, b.counters.nodesVisited);
    EXPECT_EQ(a.counters.bytesTouched, b.counters.bytesTouched);
    ASSERT_EQ(a.counters.parts.size(), b.counters.parts.size());
    for (size_t i = 0; i < a.counters.parts.size(); ++i) {
        EXPECT_EQ(a.counters.parts[i].objects, b.counters.parts[i].objects);
        EXPECT_EQ(a.counters.parts[i].culledTriangles, b.counters.parts[i].culledTriangles);
    }
    ASSERT_EQ(a.counters.figures.size(), b.counters.figures.size());
    for (size_t i = 0; i < a.counters.figures.size(); ++i) {
        EXPECT_EQ(a.counters.figures[i].name, b.counters.figures[i].name);
        EXPECT_EQ(a.counters.figures[i].value, b.counters.figures[i].value) << a.counters.figures[i].name;
    }
    ASSERT_EQ(a.commands.size(), b.commands.size());
    for (size_t i = 0; i < a.commands.size(); ++i) expectSame(a.commands[i], b.commands[i]);
}

/// By entry: whether it is a command.
std::vector<bool> sequenceOf(const FrameLog& log) {
    std::vector<bool> commands;
    size_t before = 0;
    for (const Decision& decision : log.decisions) {
        for (; before < decision.commands; ++before) commands.push_back(true);
        commands.push_back(false);
    }
    for (; before < log.commands.size(); ++before) commands.push_back(true);
    return commands;
}

void expectConsistent(const FrameLog& log) {
    const std::vector<bool> isCommand = sequenceOf(log);
    ASSERT_EQ(log.entries(), isCommand.size());
    size_t commands = 0;
    // Parts are counted and copied, which takes too long for every one of thousands: some of them, and those around commands.
    const size_t step = std::max<size_t>(log.entries() / howMany(50, 50), 1);
    const auto isAtCommand = [&](size_t k) { return (k < isCommand.size() && isCommand[k]) || (k > 0 && isCommand[k - 1]); };
    for (size_t k = 0; k <= log.entries(); ++k) {
        if (k % step == 0 || k == log.entries() || isAtCommand(k)) {
            ASSERT_EQ(log.commandsWithin(k), commands) << k;
            const FrameLog part = log.upTo(k);
            ASSERT_EQ(part.entries(), k);
            ASSERT_EQ(part.commands.size(), commands) << k;
            ASSERT_EQ(part.commandsWithin(k), commands) << k;
        }
        if (k < log.entries()) commands += isCommand[k] ? 1 : 0;
    }
    EXPECT_EQ(log.upTo(log.entries() + 7).entries(), log.entries()) << "there are no more";
}

TEST(Frames, entriesOfEveryStrategysFrameAreOneSequence) {
    const ScenePointer scene = field();
    for (const RegisteredStrategy& registered : strategies()) {
        if (registered.info.glRequirement != GlRequirement::None) continue;
        SCOPED_TRACE(registered.info.id);
        const CullerPointer strategy = coarse(registered);
        strategy->build(*scene);
        const FrameLog log = strategy->cull(inTheField(), Recording::On).log;
        EXPECT_TRUE(log.recorded);
        EXPECT_GE(log.decisions.size(), scene->instances().size());
        EXPECT_EQ(log.commands.size(), 1u);
        EXPECT_TRUE(log.drawsScene() || log.grain() == Grain::Object || !std::holds_alternative<DrawList>(log.commands.front()));
        expectConsistent(log);
    }
}

FrameLog logOf(size_t commands, const std::vector<uint32_t>& decisions) {
    FrameLog log;
    for (size_t i = 0; i < commands; ++i) log.commands.emplace_back(DrawList{Facing::TwoSided, {{uint32_t(i), 0, 6}}});
    for (const uint32_t before : decisions) {
        log.decisions.push_back(ending(Subject::ofObject(before), Decision::Outcome::Drawn));
        log.decisions.back().commands = before;
    }
    return log;
}

TEST(Frames, decisionsBetweenCommandsKeepTheirPlaces) {
    expectConsistent(logOf(0, {}));
    expectConsistent(logOf(3, {}));
    expectConsistent(logOf(0, {0, 0}));
    expectConsistent(logOf(3, {0, 0, 1, 3}));
    expectConsistent(logOf(4, {1, 2, 2, 2, 3}));
    expectConsistent(logOf(2, {2, 2}));
    const FrameLog log = logOf(3, {0, 1, 1, 3});
    EXPECT_EQ(log.upTo(3).commands.size(), 1u) << "a decision, a command, a decision";
    EXPECT_EQ(log.upTo(3).decisions.size(), 2u);
}

/// Draws the objects one at a time, each after the decision about it.
class OneByOne final : public StrategyWith<Structure> {
protected:
    void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
    void decide(FrameContext& frame, const Structure& structure, ViewState& /*state*/,
                const ParameterSet& /*parameters*/) const override {
        for (uint32_t i = 0; i < structure.scene().instances().size(); ++i) {
            if (frame.recording()) frame.say(ending(Subject::ofObject(i), Decision::Outcome::Drawn));
            frame.draw({frame.facing(), {{i, 0, uint32_t(structure.scene().meshOf(i).indices().size())}}});
        }
    }
    [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                    Facing /*facing*/) const override {
        return Promise::Conservative;
    }
};

TEST(Frames, replayOfAPartShowsWhatHadBeenDrawn) {
    const ScenePointer scene = field();
    const SceneBuffers buffers(scene, Upload::Vbo);
    Culler strategy({{"one-by-one", "", "", "", {}}, std::make_shared<OneByOne>()});
    strategy.build(*scene);
    const FrameLog log = strategy.cull(inTheField(), Recording::On).log;
    ASSERT_EQ(log.entries(), 50u);
    expectConsistent(log);
    Framebuffer target(inTheField().viewport());
    for (const size_t entries : {0u, 1u, 2u, 7u, 20u, 50u}) {
        GlEnvironment::renderer().draw(buffers, inTheField(), log.upTo(entries), target);
        DrawList soFar = everything(*scene, log.facing);
        soFar.ranges.resize(entries / 2);
        EXPECT_EQ((Picture{target.readColour(), target.readDepth()}), picture(buffers, inTheField(), soFar)) << entries;
        EXPECT_EQ(drawnTriangles(*scene, log.upTo(entries)).triangleCount(), soFar.triangleCount());
    }
}

/// A frame of a new view that is drawn, and its picture.
struct DrawnFrame {
    FrameLog log;
    Picture picture;
};

DrawnFrame drawnFrame(const BuiltStrategy& strategy, const SceneBuffers& buffers, const View& view, const DrawStyle& style) {
    Framebuffer target(view.viewport());
    GpuFrame frame(GlEnvironment::renderer(), buffers, view, target, style, true);
    const ViewStatePointer state = strategy.begin();
    strategy.draw(frame, *state);
    return {frame.take(), {target.readColour(), target.readDepth()}};
}

Picture replayed(const FrameLog& log, const SceneBuffers& buffers, const View& view, const DrawStyle& style) {
    Framebuffer target(view.viewport());
    GlEnvironment::renderer().draw(buffers, view, log, target, style);
    return {target.readColour(), target.readDepth()};
}

TEST(Frames, replayIsTheFramesPicture) {
    const DrawStyle style{Vec3f(0.9f), 1.0f, Vec3f(0.2f, 0.5f, 0.7f)};
    size_t covered = 0;
    for (uint64_t seed = 0; seed <= howMany(8, 4); ++seed) {
        const ScenePointer scene = seed == 0 ? field() : randomScene(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        Random random(seed);
        for (const RegisteredStrategy& registered : strategies()) {
            if (!isAvailable(registered)) continue;
            SCOPED_TRACE(registered.info.id + " seed " + std::to_string(seed));
            const CullerPointer strategy = coarse(registered);
            strategy->build(*scene);
            for (int i = 0; i < 3; ++i) {
                const RandomView sample = randomView(*scene, random);
                const View view = seed == 0 ? inTheField() : View(sample.camera, small(sample.viewport));
                const auto [log, drawn] = drawnFrame(*strategy->built(), buffers, view, style);
                EXPECT_EQ(replayed(log.upTo(log.entries()), buffers, view, style), drawn) << "view " << i;
                covered += size_t(std::ranges::count_if(drawn.depth, [](float depth) { return depth > 0.0f; }));
                // A frame that is not drawn decides the same, without a past as well.
                GpuFrame undrawn(GlEnvironment::renderer(), buffers, view, true);
                const ViewStatePointer state = strategy->built()->begin();
                strategy->built()->draw(undrawn, *state);
                expectSameFrame(log, undrawn.take());
            }
        }
    }
    EXPECT_GT(covered, fewSamples() ? 10'000u : 50'000u);
}

/// A strategy's frames of a view that is recorded from the first one on, and of a view that never is: each has its memory.
struct TwoViews {
    CullerPointer strategy;
    ViewStatePointer ofRecorded, ofMeasured;

    explicit TwoViews(const RegisteredStrategy& registered, const Scene& scene) : strategy(coarse(registered)) {
        strategy->build(scene);
        ofRecorded = strategy->built()->begin();
        ofMeasured = strategy->built()->begin();
    }
    [[nodiscard]] FrameLog frame(const View& view, const SceneBuffers& buffers, bool recording) const {
        GpuFrame frame(GlEnvironment::renderer(), buffers, view, recording);
        strategy->built()->draw(frame, recording ? *ofRecorded : *ofMeasured);
        return frame.take();
    }
};

TEST(Frames, recordingChangesNothing) {
    int counted = 0;
    for (uint64_t seed = 1; seed <= howMany(20, 20); ++seed) {
        const ScenePointer scene = randomScene(seed);
        const SceneBuffers buffers(scene, Upload::Vbo);
        std::vector<TwoViews> all;
        for (const RegisteredStrategy& registered : strategies())
            if (isAvailable(registered)) all.emplace_back(registered, *scene);
        Random random(seed);
        for (int i = 0; i < 10; ++i) {
            const RandomView sample = randomView(*scene, random);
            const View view(sample.camera, small(sample.viewport));
            for (const TwoViews& views : all) {
                SCOPED_TRACE(views.strategy->built()->id() + " seed " + std::to_string(seed) + " view " + std::to_string(i));
                const FrameLog recorded = views.frame(view, buffers, true), plain = views.frame(view, buffers, false);
                expectSameFrame(recorded, plain);
                EXPECT_TRUE(recorded.recorded && !plain.recorded);
                EXPECT_FALSE(recorded.decisions.empty());
                EXPECT_TRUE(plain.decisions.empty() && plain.objects.empty() && plain.details.empty());
                for (const NamedFigure& figure : plain.counters.figures) {
                    if (figure.name != "plane_tests") continue;
                    EXPECT_EQ(std::ranges::count_if(recorded.decisions, isPlaneTest), int64_t(figure.value));
                    ++counted;
                }
            }
        }
    }
    EXPECT_GT(counted, 0) << "no strategy counts its plane tests";
}

}  // namespace
}  // namespace cullscope::test::frames_test
