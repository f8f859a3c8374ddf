// What FrameContext can say beyond what the registered strategies need: five small strategies, each judged, replayed, explained
// and measured as any other, without a line about them outside their file.
#include <numeric>
#include <set>

#include "core/base/error.h"
#include "core/image/view_picture.h"
#include "core/measure/meter.h"
#include "core/visibility/why.h"
#include "tests/core/measure/own_counts.h"
#include "tests/core/measure/small_strategies_bench.h"

namespace cullscope::test::small_strategies_test {
namespace {

/// Judges and counts frames of random views (200 in a long run); `frame(view)` makes the frame that is judged. `counts`: what
/// the strategy leaves out is counted; `leftOut`: as what.
template <typename Frame>
void expectNothingWrong(Bench& bench, bool counts, const Frame& frame, TriangleState leftOut = TriangleState::Hidden) {
    Random random(5);
    uint64_t wrong = 0, covered = 0;
    for (uint64_t i = 0; i < howMany(200, 20); ++i) {
        SCOPED_TRACE("view " + std::to_string(i));
        const View view = somewhere(random);
        const FrameLog log = frame(view);
        const Reference truth = bench.truth(view);
        wrong += wrongPixels(bench, log, truth);
        covered += truth.coveredPixels;
        EXPECT_EQ(triangleStates(*bench.scene, log, truth.visible()).counts, ownCounts(*bench.scene, log, truth, leftOut));
        const std::vector<bool> drawn = drawnByCommands(*bench.scene, log);
        const auto given = uint64_t(std::ranges::count(drawn, true));
        EXPECT_EQ(log.consideredTriangles(), given);
        const auto& culled = log.counters.culledTriangles;
        EXPECT_EQ(std::accumulate(culled.begin(), culled.end(), uint64_t{0}), counts ? drawn.size() - given : 0u);
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(covered, 0u);
}

void noPast(const View& /*view*/) {}

/// Picture, replay, colours by verdict and the explanation of a few triangles. `prepare(view)` gives the view the
/// past that a frame without losses needs.
template <typename Prepare>
void expectReplays(Bench& bench, const Prepare& prepare) {
    Random random(9);
    for (int i = 0; i < 5; ++i) {
        SCOPED_TRACE("view " + std::to_string(i));
        const View view = somewhere(random);
        prepare(view);
        const auto [own, log] = bench.drawn(view);
        const Picture again = bench.replayed(view, log, {0, 0, kSize});
        EXPECT_TRUE(own.depth == again.depth && own.colour == again.colour) << "the replay is another picture";
        // From elsewhere, and coloured by verdict.
        const View aside = somewhere(random);
        Framebuffer target(kSize);
        prepare(view);
        const FrameLog recorded = bench.decide(view);
        const Reference truth = bench.truth(view);
        const TriangleStates states = triangleStates(*bench.scene, recorded, truth.visible());
        drawViewPicture(GlEnvironment::renderer(), bench.buffers, *bench.built, recorded, aside, &states, {"verdicts"}, {},
                        target);
        // A sliver that only the raster's snapping shows is not in a picture of rays.
        EXPECT_LE(states.counts[size_t(TriangleState::WronglyCulled)], hasOwnRaster(recorded) ? 3u : 0u);
        const std::optional<PickedTriangle> picked = GlEnvironment::renderer().pick(bench.buffers, view, recorded, 80, 60);
        const uint32_t shown = truth.triangle[size_t(60) * size_t(kSize.width) + 80];
        if (picked && shown != 0) {
            EXPECT_EQ(picked->triangle, shown - 1);
        }
        for (uint64_t triangle = 0; triangle < bench.scene->triangleCount(); triangle += 701) {
            const std::vector<WhyStep> steps = why(*bench.built, recorded, triangle);
            ASSERT_FALSE(steps.empty());
            const bool given = std::ranges::any_of(steps, [](const WhyStep& step) {
                return step.sentence.english() == "The triangle is given to OpenGL." ||
                       step.sentence.english() == "The triangle is in the picture that the strategy made.";
            });
            EXPECT_EQ(given, std::ranges::any_of(drawnTriangles(*bench.scene, recorded).ranges, [&](const DrawRange& range) {
                          const uint64_t first = bench.scene->firstTriangle(range.instance) + range.firstIndex / 3;
                          return first <= triangle && triangle < first + range.indexCount / 3;
                      }));
        }
    }
}

MeasureResult measured(const RegisteredStrategy& strategy, const ScenePointer& scene, std::vector<Camera> poses) {
    MeasureRequest request;
    request.scene = scene;
    request.strategies = {
        {strategy.info.id, ParameterSet(strategy.info.parameters), std::make_shared<const RegisteredStrategy>(strategy)}};
    for (const Camera& camera : poses) {
        request.path.poses.push_back({camera.eye, camera.target, camera.up});
        request.path.fovy = camera.fovy;
        request.path.nearDistance = camera.nearDistance;
        request.path.farDistance = camera.farDistance;
    }
    request.size = kSize;
    request.timing.fixedRepetitions = 2;
    return measure(request);
}

Camera lookingFrom(const Vec3& eye, const Vec3& target = Vec3(0.0), double fovyDegrees = 40) {
    return {eye, target, {0, 1, 0}, Angle::fromDegrees(fovyDegrees), 0.1, 100.0};
}

void expectMeasured(const RegisteredStrategy& strategy) {
    const MeasureResult result = measured(strategy, spheres(), {lookingFrom({0, 1, 12}), lookingFrom({0, 1, 12})});
    ASSERT_EQ(result.runs.size(), 1u);
    const RunMeasurement& run = result.runs.front();
    ASSERT_EQ(run.frames.size(), 2u);
    EXPECT_FALSE(run.promiseBroken());
    for (const FrameMeasurement& frame : run.frames) {
        ASSERT_TRUE(frame.accuracy);
        EXPECT_GT(frame.consideredTriangles, 0u);
        EXPECT_EQ(frame.ownRaster ? frame.missedBeyondSnapping : frame.accuracy->missedPixels, 0u);
    }
}

TEST(SmallStrategies, ownTrianglesInAnOrderOfTheirOwnShowWhatIsVisible) {
    Bench bench(backToFront());
    expectNothingWrong(bench, false, [&](const View& view) { return bench.decide(view); });
    expectReplays(bench, noPast);
    expectMeasured(backToFront());
}

TEST(SmallStrategies, pictureMadeOnTheProcessorIsShownAndJudged) {
    Bench bench(tracedPicture());
    expectNothingWrong(bench, false, [&](const View& view) { return bench.decide(view); });
    expectReplays(bench, noPast);
    expectMeasured(tracedPicture());
}

TEST(SmallStrategies, halfIsDrawnAndTheRestGoesOnWithTheAnswers) {
    Bench bench(halfThenAsk());
    uint64_t left = 0;
    expectNothingWrong(bench, true, [&](const View& view) {
        FrameLog log = bench.decide(view);
        left += log.counters.culledTriangles[size_t(Cause::Hidden)];
        return log;
    });
    EXPECT_GT(left, 0u) << "nothing was ever hidden";
    expectReplays(bench, noPast);
    expectMeasured(halfThenAsk());
}

TEST(SmallStrategies, memoryOfAViewThatStandsLosesNothing) {
    Bench bench(lastFrame());
    uint64_t left = 0;
    const auto prepare = [&](const View& view) {
        bench.state = bench.built->begin();
        return bench.decide(view);
    };
    expectNothingWrong(bench, true, [&](const View& view) {
        const FrameLog before = prepare(view);
        EXPECT_EQ(before.consideredTriangles(), bench.scene->triangleCount()) << "without a past everything is drawn";
        FrameLog log = bench.decide(view);
        // What it draws are the objects that OpenGL hit in the frame before.
        std::set<uint32_t> objects;
        for (const DrawRange& range : std::get<DrawList>(log.commands.front()).ranges) objects.insert(range.instance);
        EXPECT_EQ(objects, objectsHit(*bench.scene, before));
        left += log.counters.culledTriangles[size_t(Cause::Hidden)];
        return log;
    });
    EXPECT_GT(left, 0u) << "nothing was ever hidden";
    expectReplays(bench, prepare);
    expectMeasured(lastFrame());
}

TEST(SmallStrategies, memoryOfAViewThatJumpsShowsItsLossAndMeasureCountsIt) {
    // The first two poses see the front of one row of spheres, the others that of the next row.
    const Camera left = lookingFrom({-2.4, 1.2, 12}, {-2.4, 1.2, 0}, 8), right = lookingFrom({2.4, 1.2, 12}, {2.4, 1.2, 0}, 8);
    const std::vector<Camera> poses{left, left, right, right};
    const RegisteredStrategy strategy = lastFrame();
    const RunMeasurement run = measured(strategy, spheres(), poses).runs.front();
    ASSERT_EQ(run.frames.size(), 4u);
    EXPECT_EQ(run.frames[0].accuracy->missedPixels, 0u);
    EXPECT_EQ(run.frames[1].accuracy->missedPixels, 0u);
    EXPECT_GT(run.frames[2].accuracy->missedPixels, 0u);
    EXPECT_EQ(run.frames[3].accuracy->missedPixels, 0u);
    // The same frames, drawn one after the other.
    Bench bench(strategy);
    for (size_t pose = 0; pose < poses.size(); ++pose) {
        const View view(poses[pose], kSize);
        const auto [own, log] = bench.drawn(view);
        EXPECT_EQ(wrongPixels(bench, log, bench.truth(view)), run.frames[pose].accuracy->missedPixels) << pose;
        EXPECT_EQ(log.consideredTriangles(), run.frames[pose].consideredTriangles) << pose;
        EXPECT_EQ(bench.replayed(view, log, {0, 0, kSize}), own) << "a replay asks nothing and shows the same loss, at " << pose;
    }
}

TEST(SmallStrategies, whatAComputeShaderChoseIsReadBackAndJudged) {
    Bench bench(chosenByGpu());
    uint64_t left = 0;
    expectNothingWrong(
        bench, true,
        [&](const View& view) {
            FrameLog log = bench.decide(view);
            left += bench.scene->triangleCount() - log.consideredTriangles();
            return log;
        },
        TriangleState::OutsideFrustum);
    EXPECT_GT(left, 0u) << "nothing was ever outside";
    expectReplays(bench, noPast);
    expectMeasured(chosenByGpu());
}

TEST(SmallStrategies, pictureOfAnotherSizeIsRefused) {
    class Small final : public StrategyWith<Structure> {
    protected:
        void fill(Structure& /*structure*/, const ParameterSet& /*parameters*/, const Progress& /*progress*/) const override {}
        void decide(FrameContext& frame, const Structure& /*structure*/, ViewState& /*state*/,
                    const ParameterSet& /*parameters*/) const override {
            auto picture = std::make_shared<FinishedPicture>();
            picture->size = {8, 8};
            picture->triangle.assign(64, 0);
            picture->depth.assign(64, 0.0f);
            frame.show(std::move(picture));
        }
        [[nodiscard]] Promise promiseOf(const Structure& /*structure*/, const ParameterSet& /*parameters*/,
                                        Facing /*facing*/) const override {
            return Promise::Approximate;
        }
    };
    Bench bench({{"small", "", "", "", {}}, std::make_shared<Small>()});
    EXPECT_THROW((void)bench.decide(View(lookingFrom({0, 1, 12}), kSize)), Error);
}

}  // namespace
}  // namespace cullscope::test::small_strategies_test
