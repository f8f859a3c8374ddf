// The painter's order within its bounds: of polygons, and of time between two looks whether it shall stop.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "tests/core/spatial/ordered_scene.h"
#include "tests/support/long_mode.h"
#include "tests/support/stopped_work.h"

namespace cullscope::test::painters_order_test {
namespace {

TEST(PaintersOrder, limitCountsWholeTrianglesAndStopsWithASentence) {
    const auto refusal = [](const ScenePointer& scene, uint64_t limit, bool byCentroid = false) -> std::string {
        try {
            return "ordered: " + std::to_string(ordered(scene, {.byCentroid = byCentroid, .limit = limit}).triangles.size());
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Usage);
            return error.what();
        }
    };
    EXPECT_NE(refusal(layers({0, 1, 2}), 2).find("it has 3 triangles. Take fewer triangles, or a higher limit."),
              std::string::npos)
        << "no other way of sorting helps";
    EXPECT_EQ(refusal(layers({0, 1, 2}), 2, true), refusal(layers({0, 1, 2}), 2));
    EXPECT_EQ(refusal(layers({0, 1, 2}), 3), "ordered: 3");
    const ScenePointer meeting = sceneOf({randomTriangles(1, 300, 2.0)});
    EXPECT_NE(refusal(meeting, 1'000).find("more than 1000 polygons"), std::string::npos);
    EXPECT_NE(refusal(meeting, 1'000).find("sort=centroid"), std::string::npos);
    EXPECT_EQ(refusal(meeting, 1'000, true), "ordered: 300") << "what the sentence advises helps";
}

TEST(PaintersOrder, stopsAtTheNextLookWhereverTheSortIs) {
    const ScenePointer scenes[] = {sceneOf({randomTriangles(1, 2'000, 2.0)}), coplanarTriangles(howMany(1'000'000, 60'000))};
    for (const ScenePointer& scene : scenes) {
        CutTriangles triangles(*scene);
        const auto order = [&](const Progress& progress) {
            CutTriangles copy = triangles;
            (void)paintersOrder(copy, *scene, front({320, 240}), {.limit = 100'000'000}, progress);
        };
        for (const uint64_t steps : {10'000, 100'000, 150'000}) {
            const StoppedWork stopped = stoppedAfter(steps, order);
            EXPECT_TRUE(stopped.interrupted) << steps;
            EXPECT_GE(stopped.stepsBefore, steps);
            EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween) << steps;
        }
    }
}

TEST(PaintersOrder, millionCoplanarTrianglesAreSortedWithALookInEveryTenthOfASecond) {
    const ScenePointer scene = coplanarTriangles(howMany(1'000'000, 60'000));
    CutTriangles triangles(*scene);
    const WatchedWork watched;
    const PaintersOrder order = paintersOrder(triangles, *scene, front({320, 240}), {});
    EXPECT_LT(watched.longestGap(), fewSamples() ? 1000.0 : 100.0);
    EXPECT_GT(watched.steps(), scene->triangleCount());
    EXPECT_EQ(order.polygons.size(), scene->triangleCount());
    EXPECT_EQ(triangles.cuts(), 0u);
}

TEST(PaintersOrder, limitRefusesTheFirstCutThatIsTooMany) {
    const ScenePointer piercing = sceneWith({{-1, -1, -1}, {1, -1, 1}, {0, 1, 0}, {-1, -1, 1}, {1, -1, -1}, {0, 1, 0}});
    try {
        (void)ordered(piercing, {.limit = 2});
        FAIL() << "a cut makes a third polygon";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("were cut 0 times"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace cullscope::test::painters_order_test
