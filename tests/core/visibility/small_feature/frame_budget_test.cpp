// What `-p hold-fps=` does with the times of frames, by made-up clocks.
#include "core/visibility/small_feature/frame_budget.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::frame_budget_test {
namespace {

using small_feature::FrameBudget;

/// What a frame costs at a strength of culling, in doublings.
using Cost = std::function<double(double doublings)>;

/// A part that culling does not reach, and one that it halves with each doubling.
Cost linear(double fixed, double culled) {
    return [=](double doublings) { return fixed + culled * std::exp2(-doublings); };
}

struct Course {
    double first = 0.0, last = 0.0;  ///< strength
    int over = 0;                    ///< frames over the budget
    int changes = 0;
};
Course follow(FrameBudget& budget, const Cost& cost, double milliseconds, int frames) {
    Course course{budget.doublings()};
    for (int i = 0; i < frames; ++i) {
        const double before = budget.doublings(), took = cost(before);
        budget.follow(took, milliseconds);
        course.over += took > milliseconds ? 1 : 0;
        course.changes += budget.doublings() != before ? 1 : 0;
    }
    course.last = budget.doublings();
    return course;
}

TEST(FrameBudget, comesToTheBudgetAndStaysThere) {
    int held = 0;
    for (const double fixed : {0.0, 2.0, 10.0})
        for (const double culled : {5.0, 25.0, 60.0, 400.0}) {
            const Cost cost = linear(fixed, culled);
            for (const double milliseconds : {16.7, 33.3, 100.0}) {
                FrameBudget budget;
                const Course on = follow(budget, cost, milliseconds, 60);
                const bool canBeHeld = cost(FrameBudget::kMost) <= milliseconds;
                EXPECT_LE(on.over, canBeHeld ? 20 : 60) << fixed << " + " << culled << " in " << milliseconds;
                const Course there = follow(budget, cost, milliseconds, 300);
                EXPECT_EQ(there.changes, 0) << fixed << " + " << culled << " in " << milliseconds;
                EXPECT_TRUE(budget.steady());
                EXPECT_TRUE(cost(there.last) <= milliseconds || !canBeHeld);
                EXPECT_TRUE(cost(there.last) >= FrameBudget::kRoom * milliseconds || there.last == FrameBudget::kLeast);
                held += cost(there.last) >= FrameBudget::kRoom * milliseconds ? 1 : 0;
            }
        }
    EXPECT_GE(held, 20);
}

TEST(FrameBudget, doesNotSwingWhereTheCostHasAStepAtTheBudget) {
    const Cost step = [](double doublings) { return doublings < 1.3 ? 50.0 : 20.0; };
    FrameBudget budget;
    const Course course = follow(budget, step, 33.3, 1000);
    EXPECT_LE(course.over, 40) << "of a thousand frames";
    EXPECT_GE(course.last, 0.5);
}

TEST(FrameBudget, recovers) {
    FrameBudget budget;
    const double first = follow(budget, linear(2.0, 60.0), 33.3, 100).last;
    const Course heavy = follow(budget, linear(2.0, 240.0), 33.3, 100);
    EXPECT_LE(heavy.over, 6);
    EXPECT_NEAR(heavy.last, first + 2.0, 0.4);
    const Course again = follow(budget, linear(2.0, 60.0), 33.3, 200);
    EXPECT_EQ(again.over, 0);
    EXPECT_NEAR(again.last, first, 0.4);
    EXPECT_NEAR(follow(budget, linear(50.0, 1.0), 33.3, 20).last, 0.0, 1.5) << "more of it gains nothing";
    EXPECT_EQ(follow(budget, linear(0.0, 1e-9), 33.3, 400).last, FrameBudget::kLeast);
    EXPECT_LE(follow(budget, linear(2.0, 60.0), 33.3, 30).over, 14);
}

TEST(FrameBudget, oneSlowFrameChangesNothing) {
    FrameBudget budget;
    (void)follow(budget, linear(2.0, 60.0), 33.3, 100);
    const double before = budget.doublings(), usual = 2.0 + 60.0 * std::exp2(-before);
    for (const double milliseconds : {900.0, usual, usual, 900.0, usual, usual}) budget.follow(milliseconds, 33.3);
    EXPECT_EQ(budget.doublings(), before);
    FrameBudget first;
    first.follow(900.0, 33.3);
    EXPECT_EQ(first.doublings(), 0.0);
}

TEST(FrameBudget, aStrengthThatGainsNoTimeIsGivenBack) {
    for (const double within : {0.0, 2.0}) {
        const Cost cost = [=](double doublings) { return doublings < within ? 90.0 : 60.0; };
        FrameBudget budget;
        const Course course = follow(budget, cost, 20.0, 20);
        EXPECT_TRUE(budget.steady());
        EXPECT_NEAR(course.last, within, 0.5);
        EXPECT_EQ(follow(budget, cost, 20.0, 60).changes, 0);
    }
}

TEST(FrameBudget, aViewThatStandsEasesUntilItsTimeFitsTheBudget) {
    for (const double culled : {5.0, 20.0, 40.0, 100.0}) {
        FrameBudget budget;
        // A short move whose frames are slow, for the machine had other things to do.
        (void)follow(
            budget, [](double doublings) { return 150.0 * std::exp2(-0.25 * doublings); }, 33.3, 6);
        EXPECT_GT(budget.doublings(), 1.0);
        const Cost cost = linear(2.0, culled);
        int frames = 0;
        for (; frames < 60 && !(frames > 0 && budget.steady()); ++frames) budget.follow(cost(budget.doublings()), 33.3, true);
        EXPECT_TRUE(budget.steady());
        EXPECT_LE(frames, 40) << culled;
        EXPECT_LE(cost(budget.doublings()), 33.3);
        EXPECT_TRUE(cost(budget.doublings()) >= 0.75 * 33.3 || budget.doublings() == FrameBudget::kLeast) << culled;
    }
}

TEST(FrameBudget, timesThatAreNoneChangeNothing) {
    FrameBudget budget;
    for (const double none : {0.0, -1.0, double(NAN), double(INFINITY)}) budget.follow(none, 33.3);
    budget.follow(50.0, 0.0);
    EXPECT_EQ(budget.doublings(), 0.0);
}

ScenePointer components() {
    Random random(7);
    std::vector<Mat4> places;
    for (int i = 0; i < 600; ++i) {
        const Vec3 place{random.between(-40, 40), random.between(-10, 10), random.between(-40, 40)};
        places.push_back(translation(place) * scaling(Vec3(std::pow(10.0, random.between(-2.0, 0.6)))));
    }
    return copiesOf(sphereMesh(80), places);
}

View aView(int number) {
    return {{{60.0 + 0.01 * number, 20, 60}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.05, 1e3}, {120, 90}};
}

CullerPointer built(const Scene& scene, const std::string& fps) {
    ParameterSet parameters(findStrategy("small-feature").info.parameters);
    parameters.setFromText("outline", "20");
    parameters.setFromText("hold-fps", fps);
    CullerPointer culler = makeCuller("small-feature", parameters);
    culler->build(scene);
    return culler;
}

double figure(const FrameLog& log, std::string_view name) {
    for (const NamedFigure& one : log.counters.figures)
        if (one.name == name) return one.value;
    return -1.0;
}

TEST(HoldFps, movesThresholdAndOutlineUntilTheFramesKeepTheirTime) {
    const ScenePointer scene = components();
    const CullerPointer free = built(*scene, "0"), held = built(*scene, "50");
    const Culled first = held->cull(aView(0));
    EXPECT_EQ(first.drawList.ranges, free->cull(aView(0)).drawList.ranges) << "before a frame was timed";
    EXPECT_EQ(figure(free->cull(aView(0)).log, "threshold_in_force"), -1.0) << "only where it moves";
    EXPECT_EQ(figure(first.log, "threshold_in_force"), 0.002);
    EXPECT_EQ(figure(first.log, "outline_in_force_percent"), 20.0);
    // A clock by which the first frame takes twice its 20 ms.
    const double perTriangle = 40.0 / double(first.consideredTriangles);
    Culled frame = first;
    int over = 0;
    for (int i = 1; i < 150; ++i) {
        held->state().frameMilliseconds = perTriangle * double(frame.consideredTriangles);
        frame = held->cull(aView(i));
        over += i >= 50 && perTriangle * double(frame.consideredTriangles) > 20.0 ? 1 : 0;
    }
    EXPECT_LE(over, 8) << "of a hundred frames";
    EXPECT_GT(figure(frame.log, "threshold_in_force"), 0.002);
    EXPECT_LT(figure(frame.log, "outline_in_force_percent"), 20.0);
    EXPECT_GT(frame.consideredTriangles, 0u);
    // Time to spare: everything is drawn in the end.
    for (int i = 0; i < 150; ++i) {
        held->state().frameMilliseconds = 0.5;
        frame = held->cull(aView(i));
    }
    EXPECT_EQ(figure(frame.log, "outline_in_force_percent"), 100.0);
    EXPECT_EQ(frame.culledTriangles[size_t(Cause::TooSmall)], 0u);
    EXPECT_GT(first.culledTriangles[size_t(Cause::TooSmall)], 0u);
}

TEST(HoldFps, saysWhatIsInForceAndIsNotToldOfFramesWithoutIt) {
    const ScenePointer scene = components();
    const CullerPointer free = built(*scene, "0"), held = built(*scene, "50");
    for (Culler* culler : {free.get(), held.get()}) {
        for (const int view : {0, 1}) {
            (void)culler->cull(aView(view));
            culler->state().frameMilliseconds = 80.0;
        }
    }
    const Culled next = held->cull(aView(2), Recording::On);
    EXPECT_FALSE(held->state().frameMilliseconds) << "each time is told once";
    const auto said = [](const FrameLog& log) {
        return std::ranges::any_of(log.decisions, [](const Decision& decision) {
            return decision.sentence != nullptr && std::string(decision.sentence).starts_with("The frame before took");
        });
    };
    EXPECT_TRUE(said(next.log));
    EXPECT_EQ(next.log.frameBeforeMilliseconds, 80.0);
    EXPECT_EQ(figure(next.log, "threshold_in_force"), 0.008) << "at most two doublings at once";
    ASSERT_EQ(next.log.counters.held.size(), 2u);
    EXPECT_EQ(next.log.counters.held[0].key, "threshold");
    EXPECT_EQ(next.log.counters.held[1].value, 5.0);
    const Culled same = free->cull(aView(0), Recording::On);
    EXPECT_FALSE(said(same.log));
    EXPECT_EQ(same.drawList.ranges, built(*scene, "0")->cull(aView(0)).drawList.ranges);
}

TEST(HoldFps, ofTheOutlineASixteenthRemainsWhateverAFrameTakes) {
    const ScenePointer scene = components();
    const CullerPointer held = built(*scene, "1000");
    double least = 100.0;
    for (int i = 0; i < 40; ++i) {
        const Culled frame = held->cull(aView(i));
        least = std::min(least, figure(frame.log, "outline_in_force_percent"));
        EXPECT_GT(frame.consideredTriangles, 0u);
        // A clock by which culling gains time and never enough.
        held->state().frameMilliseconds = 50.0 + 1e-3 * double(frame.consideredTriangles);
    }
    EXPECT_DOUBLE_EQ(least, 20.0 / 16.0);
}

TEST(HoldFps, aViewThatStandsIsUnsteadyUntilItsTimeFits) {
    const ScenePointer scene = components();
    const CullerPointer free = built(*scene, "0"), held = built(*scene, "50");
    (void)free->cull(aView(0));
    EXPECT_FALSE(free->state().unsteady);
    Culled frame = held->cull(aView(0));
    EXPECT_TRUE(held->state().unsteady);
    const double perTriangle = 40.0 / double(frame.consideredTriangles);
    int frames = 0;
    for (; frames < 60 && held->state().unsteady; ++frames) {
        held->state().frameMilliseconds = perTriangle * double(frame.consideredTriangles);
        frame = held->cull(aView(0));
    }
    EXPECT_LE(frames, 40);
    EXPECT_LE(perTriangle * double(frame.consideredTriangles), 20.0);
}

}  // namespace
}  // namespace cullscope::test::frame_budget_test
