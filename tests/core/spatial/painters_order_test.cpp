// The painter's order: of scenes whose order is known, by each of Newell's tests, and with what waits for itself cut.
#include <gmock/gmock.h>

#include <set>

#include "tests/core/spatial/ordered_scene.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/long_mode.h"
#include "tests/support/ordered_samples.h"

namespace cullscope::test::painters_order_test {
namespace {

using testing::ElementsAre;

TEST(PaintersOrder, layersComeFromFarToNear) {
    EXPECT_THAT(ordered(layers({0.5f, -2, 1, -1, 0})).triangles, ElementsAre(1, 3, 4, 0, 2));
    EXPECT_THAT(ordered(layers({0, 0, 0})).triangles, ElementsAre(2, 1, 0)) << "in one place the lowest number is on top";
}

TEST(PaintersOrder, tilesInOnePlaneNeedNoCut) {
    const Ordered result = ordered(hardScene(2));
    EXPECT_EQ(result.count(NewellTest::Cycle) + result.count(NewellTest::Pierce), 0u);
    EXPECT_EQ(result.triangles.size(), hardScene(2)->triangleCount());
}

/// Two triangles, the first one farther, of which one test alone decides.
struct Pair {
    const char* name;
    NewellTest decides;
    std::vector<Vec3f> corners;
};

const std::vector<Pair>& pairs() {
    static const std::vector<Pair> kPairs{
        {"Q is nearer", NewellTest::Depth, {{-1, -1, -1}, {1, -1, -1}, {0, 1, -.5f}, {-1, -1, 0}, {1, -1, 0}, {0, 1, .5f}}},
        {"apart in x",
         NewellTest::ExtentX,
         {{-3, -3, -1}, {-2, -3, .5f}, {-2, -1, -1}, {-1, -3, -.5f}, {-.3f, -3, 1}, {-.3f, -1, -.5f}}},
        {"apart in y",
         NewellTest::ExtentY,
         {{-3, -3, -1}, {-3, -2, .5f}, {-1, -2, -1}, {-3, -1, -.5f}, {-3, -.3f, 1}, {-1, -.3f, -.5f}}},
        {"P is behind Q's plane",
         NewellTest::BehindQ,
         {{-1, -.8f, -1}, {1, -.8f, -.3f}, {0, .8f, -.6f}, {-1, -1, -.5f}, {1, -1, .5f}, {0, 1, 0}}},
        {"Q is before P's plane",
         NewellTest::BeforeP,
         {{-1, -1, -1}, {1, -1, .5f}, {0, 1, -.25f}, {.2f, -.5f, .3f}, {.6f, -.5f, .4f}, {.4f, .5f, .9f}}},
        {"projections are apart",
         NewellTest::Projections,
         {{-1, -1, -1}, {1, -1, .6f}, {-1, 1, -.2f}, {1.1f, -.8f, -.3f}, {1.1f, 1.1f, .6f}, {-.8f, 1.1f, -.6f}}}};
    return kPairs;
}

/// That the two numbers of a step decide its test as they are said to.
void expectCompared(const NewellStep& step) {
    const bool passed = step.kind == NewellStep::Kind::Compared;
    switch (step.test) {
        case NewellTest::Depth:
            EXPECT_EQ(step.second <= step.first, passed) << "Q's farthest depth and P's nearest one";
            break;
        case NewellTest::ExtentX:
        case NewellTest::ExtentY:
            EXPECT_GE(std::min(step.first, step.second), 0.0) << "pixels";
            EXPECT_LE(std::max(step.first, step.second), 320.0);
            if (!passed) {
                EXPECT_LT(step.first, step.second) << "what both have";
            }
            break;
        case NewellTest::BehindQ:
            EXPECT_FALSE(std::signbit(step.first) || std::signbit(step.second)) << "never -0";
            if (passed) {
                EXPECT_EQ(step.first, 0.0) << "P before the plane of Q";
            }
            break;
        case NewellTest::BeforeP:
            EXPECT_FALSE(std::signbit(step.first) || std::signbit(step.second)) << "never -0";
            if (passed) {
                EXPECT_EQ(step.second, 0.0) << "Q behind the plane of P";
            }
            break;
        case NewellTest::Projections:
            EXPECT_EQ(step.byDepth ? step.second <= 0.0 : step.first <= step.second, passed);
            break;
        case NewellTest::Swap:
        case NewellTest::Cycle:
            EXPECT_GT(std::min(step.first, step.second), 0.0) << "depths";
            break;
        case NewellTest::Pierce:
            EXPECT_LT(step.first, 0.0);
            EXPECT_GT(step.second, 0.0);
    }
}

TEST(PaintersOrder, eachOfNewellsTestsDecidesOnce) {
    for (const Pair& pair : pairs()) {
        SCOPED_TRACE(pair.name);
        // The corners turned the other way round, too: which side is the front plays no part.
        std::vector<Vec3f> turned = pair.corners;
        std::swap(turned[0], turned[1]);
        std::swap(turned[4], turned[5]);
        for (const auto& corners : {pair.corners, turned}) {
            const Ordered result = ordered(sceneWith(corners));
            EXPECT_THAT(result.triangles, ElementsAre(0, 1));
            EXPECT_EQ(result.comparisons(), 1u);
            EXPECT_EQ(result.count(pair.decides), 1u);
            using Kind = NewellStep::Kind;
            const auto failed = size_t(pair.decides);
            ASSERT_EQ(result.steps.size(), failed + 5) << "P, what failed, what decided, P is drawn, and the other one";
            EXPECT_EQ(result.steps[0].kind, Kind::Taken);
            EXPECT_EQ(result.steps[0].p, 0u);
            EXPECT_NEAR(result.steps[0].first, 7.0, 1e-9) << "the farthest depth";
            for (size_t test = 0; test < failed; ++test) {
                EXPECT_EQ(result.steps[1 + test].kind, Kind::Failed);
                EXPECT_EQ(size_t(result.steps[1 + test].test), test) << "in the order of their numbers";
            }
            for (size_t test = 0; test <= failed; ++test) expectCompared(result.steps[1 + test]);
            EXPECT_EQ(result.steps[failed + 1].kind, Kind::Compared);
            EXPECT_EQ(result.steps[failed + 1].test, pair.decides);
            EXPECT_EQ(result.steps[failed + 2].kind, Kind::Drawn);
            EXPECT_EQ(result.steps[failed + 2].p, 0u);
            EXPECT_EQ(result.steps[failed + 3].kind, Kind::Taken);
            EXPECT_EQ(result.steps[failed + 4].kind, Kind::Drawn);
        }
    }
}

TEST(PaintersOrder, qIsTakenFirstWhereNoTestLetsPComeBefore) {
    const Ordered result =
        ordered(sceneWith({{-3, -1, -2}, {1, -1, .6f}, {1, 1, .6f}, {0, -.5f, -.8f}, {.8f, -.5f, -.7f}, {.8f, .2f, -.6f}}));
    EXPECT_THAT(result.triangles, ElementsAre(1, 0)) << "the first one reaches farther, and lies before the second";
    EXPECT_EQ(result.count(NewellTest::Swap), 1u);
    EXPECT_EQ(result.count(NewellTest::BehindQ), 1u) << "the second one passes where the first one waits";
}

TEST(PaintersOrder, cycleIsCutAndKeepsItsAreas) {
    const Ordered result = ordered(sceneOf({threeBars()}));
    EXPECT_GE(result.count(NewellTest::Cycle), 1u);
    EXPECT_GT(result.triangles.size(), 6u);
    for (const double share : result.shares) EXPECT_NEAR(share, 1.0, 1e-9);
    EXPECT_EQ(result.order.unresolved, 0u);
}

TEST(PaintersOrder, trianglesThatPassThroughEachOtherAreCut) {
    const Ordered result = ordered(sceneWith({{-1, -1, -1}, {1, -1, 1}, {0, 1, 0}, {-1, -1, 1}, {1, -1, -1}, {0, 1, 0}}));
    EXPECT_EQ(result.count(NewellTest::Pierce), 1u);
    EXPECT_GE(result.triangles.size(), 3u);
    for (const double share : result.shares) EXPECT_NEAR(share, 1.0, 1e-9);
}

TEST(PaintersOrder, everyTriangleIsDrawnOnceInItsParts) {
    for (uint64_t seed = 0; seed < howMany(60, 24); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const ScenePointer scene = hardScene(seed);
        const Vec3 eye = 3.0 * random.direction();
        const Ordered result =
            ordered(scene, {}, View({eye, Vec3(0.0), random.direction(), Angle::fromDegrees(60), 0.05, 100}, {100, 100}));
        for (const double share : result.shares) EXPECT_NEAR(share, 1.0, 1e-9);
        EXPECT_EQ(std::set(result.order.polygons.begin(), result.order.polygons.end()).size(), result.order.polygons.size());
    }
}

TEST(PaintersOrder, planesCutAPolygonOnceHoweverItsCornersAreRounded) {
    // Of these scenes some have slivers whose rounded corners lie across a plane that has cut them.
    for (uint64_t seed = 5; seed < howMany(600, 200); seed += 6) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Random random(seed);
        const Vec3 eye = random.between(2.5, 4.0) * random.direction();
        const Vec3 target = 0.3 * random.direction();
        const View view({eye, target, random.direction(), Angle::fromDegrees(45), 0.05, 100}, {160, 120});
        const Ordered result = ordered(hardScene(seed, true), {.limit = 20'000}, view);
        for (const double share : result.shares) EXPECT_NEAR(share, 1.0, 1e-9);
    }
}

TEST(PaintersOrder, centroidsAloneAreSortedByTheirDistance) {
    const Ordered result =
        ordered(sceneWith({{-3, -1, -2}, {1, -1, .6f}, {1, 1, .6f}, {0, -.5f, -.8f}, {.8f, -.5f, -.7f}, {.8f, .2f, -.6f}}),
                {.byCentroid = true});
    EXPECT_THAT(result.triangles, ElementsAre(1, 0));
    EXPECT_EQ(result.comparisons(), 0u);
}

TEST(PaintersOrder, everyComparisonIsWatchedFromItsFirstTestToTheOneThatEndsIt) {
    for (uint64_t seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Ordered result = ordered(hardScene(seed), {}, front({320, 240}));
        std::array<uint64_t, kNewellTests> decided{};
        std::optional<NewellStep> before;  // a test that failed
        for (const NewellStep& step : result.steps) {
            const bool fails = step.kind == NewellStep::Kind::Failed;
            if (before) {
                ASSERT_TRUE(fails || step.kind == NewellStep::Kind::Compared) << "another test follows";
                EXPECT_EQ(step.p, before->p);
                EXPECT_EQ(step.q, before->q);
                EXPECT_TRUE(step.test > before->test || (step.byDepth && step.test == before->test));
            } else if (fails) {
                EXPECT_EQ(step.test, NewellTest::Depth) << "a comparison begins with the depths";
            }
            before = fails ? std::optional(step) : std::nullopt;
            if (step.kind == NewellStep::Kind::Compared) ++decided[size_t(step.test)];
            if (fails || step.kind == NewellStep::Kind::Compared) expectCompared(step);
        }
        EXPECT_EQ(decided, result.order.tests);
        const auto drawn = [&](NewellStep::Cause cause) {
            return uint64_t(std::ranges::count_if(result.steps, [&](const NewellStep& step) {
                return step.kind == NewellStep::Kind::Drawn && step.cause == cause;
            }));
        };
        EXPECT_EQ(drawn(NewellStep::Cause::NoSamples), result.order.unordered);
        EXPECT_EQ(drawn(NewellStep::Cause::GivenUp), result.order.unresolved);
        EXPECT_EQ(drawn(NewellStep::Cause::ByCentroid), 0u);
    }
}

TEST(PaintersOrder, nearestPolygonIsDrawnLastAtEverySample) {
    for (uint64_t seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        for (const ScenePointer& scene : {hardScene(seed), sceneOf({randomTriangles(seed, 30, 1.5)})}) {
            const Ordered result = ordered(scene, {}, front({40, 30}));
            EXPECT_EQ(wrongSamples(result.corners, front({40, 30})), 0u);
            for (const double share : result.shares) EXPECT_NEAR(share, 1.0, 1e-9);
        }
    }
}

TEST(PaintersOrder, polygonThatWaitedIsTakenAgain) {
    const Ordered result =
        ordered(sceneWith({{-3, -1, -2}, {1, -1, .6f}, {1, 1, .6f}, {0, -.5f, -.8f}, {.8f, -.5f, -.7f}, {.8f, .2f, -.6f}}));
    std::vector<uint32_t> again;
    for (const NewellStep& step : result.steps)
        if (step.kind == NewellStep::Kind::Again) again.push_back(step.p);
    EXPECT_THAT(again, ElementsAre(0));
}

TEST(PaintersOrder, whatCoversNoSampleIsCountedAndDrawnFirst) {
    const Ordered result = ordered(layers({0, 1, 20}));
    EXPECT_EQ(result.order.unordered, 1u) << "behind the eye";
    EXPECT_THAT(result.triangles, ElementsAre(2, 0, 1));
}

TEST(PaintersOrder, mirroredObjectKeepsTheFrontOfItsTriangles) {
    // The corners of both run counter-clockwise in their mesh; the transform of the second one turns them over.
    const MeshPointer square = squareMesh(1, 0);
    const ScenePointer scene = sceneOf({square, square}, {Mat4(1.0), translation({0, 0, 1}) * scaling({-1, 1, 1})});
    EXPECT_EQ(ordered(scene, {.facing = Facing::Front}).order.unordered, 0u) << "both face the eye";
}

TEST(PaintersOrder, testThatFailsNamesWhatBothExtentsHave) {
    const Ordered result = ordered(sceneWith(pairs()[4].corners));
    ASSERT_EQ(result.steps[2].test, NewellTest::ExtentX);
    const auto pixel = [](double x, double z) { return 50.0 + 50.0 * std::sqrt(3.0) * x / (6.0 - z); };
    EXPECT_NEAR(result.steps[2].first, pixel(.2, .3), 1e-4) << "the narrow one lies within the wide one";
    EXPECT_NEAR(result.steps[2].second, pixel(.6, .4), 1e-4);
}

}  // namespace
}  // namespace cullscope::test::painters_order_test
