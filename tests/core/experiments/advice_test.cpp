// Advice, races of pairs, and the search for the worst view.
#include "core/experiments/advice/adviser.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <set>

#include "core/experiments/advice/race.h"
#include "core/experiments/pairwise.h"
#include "core/experiments/worst/worst_view.h"
#include "core/geometry/random.h"
#include "core/measure/field_figures.h"
#include "core/scene/camera_path.h"
#include "tests/support/gl_environment.h"
#include "tests/support/small_experiment.h"

namespace cullscope::test::advice_test {
namespace {

advice::AdviseRequest requestFor(int poses) {
    const MeasureRequest small = smallExperiment({});
    return {small.scene, cameraPath("walk:" + std::to_string(poses), *small.scene), small.size};
}

TEST(Advice, spreadOrderHasEveryNumberOnceAndItsBeginningsLieEvenly) {
    EXPECT_THAT(advice::spreadOrder(8), testing::ElementsAre(0, 4, 2, 6, 1, 5, 3, 7));
    for (const size_t n : {0, 1, 2, 5, 16, 33}) {
        const std::vector<size_t> order = advice::spreadOrder(n);
        EXPECT_EQ(order.size(), n);
        EXPECT_EQ(std::set<size_t>(order.begin(), order.end()).size(), n);
    }
}

TEST(Advice, candidatesAreEveryStrategyThatNeedsNoFileAndEachValueOfItsSweeps) {
    const std::vector<StrategyRequest> all = advice::candidates();
    const auto has = [&](const std::string& text) { return std::ranges::find(all, strategyFromText(text)) != all.end(); };
    EXPECT_EQ(strategyText(all.front()), "all") << "the others are compared with it";
    for (const char* text :
         {"backface", "all:facing=auto", "frustum", "bsp", "draw-distance:distance=1.5", "octree-query:batch=64"})
        EXPECT_TRUE(has(text)) << text;
    for (const char* text : {"oracle", "recorded"}) EXPECT_FALSE(has(text)) << text;
    std::set<std::string> different;
    for (const StrategyRequest& one : all) different.insert(strategyText(one));
    EXPECT_EQ(different.size(), all.size());
}

/// Its times at eight views, three of each, lie anywhere within `scatter` of `milliseconds`.
advice::Entrant entrantOf(double milliseconds, double scatter, bool everything, uint64_t seed) {
    Random random(seed);
    advice::Entrant entrant;
    entrant.eligible = entrant.racing = true;
    entrant.figures.everything = everything;
    entrant.times.assign(8, std::vector<double>(3));
    for (std::vector<double>& view : entrant.times)
        for (double& time : view) time = random.between(milliseconds - scatter, milliseconds + scatter);
    return entrant;
}

TEST(Advice, drawingEverythingIsChosenWhereTheIntervalOfTheFastestDoesNotExcludeIt) {
    std::vector<advice::Entrant> entrants{entrantOf(12.0, 0.1, true, 1), entrantOf(10.0, 3.0, true, 2),
                                          entrantOf(9.9, 3.0, false, 3)};
    EXPECT_EQ(advice::everythingWhereAsFast(entrants, &entrants[2]), &entrants[1]) << "the fastest way of drawing everything";
    entrants[2] = entrantOf(5.0, 0.1, false, 4);
    EXPECT_EQ(advice::everythingWhereAsFast(entrants, &entrants[2]), &entrants[2]) << "it is faster for certain";
    entrants[2] = entrantOf(9.9, 3.0, false, 3);
    entrants[1].racing = false;
    EXPECT_EQ(advice::everythingWhereAsFast(entrants, &entrants[2]), &entrants[2]) << "the race found it slower";
}

TEST(Advice, oneThatLeftIsSetBesideTheChoiceAtTheViewsOfBoth) {
    // Drawing everything takes twice as long at the first two views. Who left after these saved most there; the choice, too.
    std::vector<advice::Entrant> entrants{entrantOf(10.0, 0.0, true, 1), entrantOf(5.5, 0.0, false, 3),
                                          entrantOf(5.0, 0.0, false, 2), entrantOf(2.0, 0.0, false, 4)};
    for (size_t view : {0, 1}) {
        entrants[0].times[view].assign(3, 20.0);
        // In its one turn another program took the processor, of the choice as well.
        entrants[1].times[view].assign(1, 11.0);
        entrants[2].times[view].front() = 10.0;
    }
    for (size_t view = 2; view < 8; ++view) entrants[1].times[view].clear();
    entrants[1].racing = entrants[0].racing = false;
    // Who was tried at the first views alone, while these took long.
    entrants.push_back(entrantOf(1.0, 0.0, false, 5));
    entrants[4].racing = false;
    entrants[4].times.assign(8, {});
    for (size_t i : {0, 2, 4}) entrants[i].probes = {{i == 4 ? 30.0 : 10.0}, {i == 0 ? 80.0 : 10.0}, {}, {}, {}, {}, {}, {}};
    entrants[4].probes[1] = {30.0};
    entrants[3].figures.limit = true;
    advice::setTimes(entrants, &entrants[2]);
    const advice::AdvisedStrategy &choice = entrants[2].figures, &left = entrants[1].figures;
    EXPECT_NEAR(choice.ratioToAll->ratio, 2.5, 1e-9);
    EXPECT_EQ(left.views, 2u);
    EXPECT_NEAR(left.ratioToAll->ratio, 2.5 / 1.1, 1e-9) << "and not 20 / 11";
    EXPECT_NEAR(left.frameMilliseconds, 5.5, 1e-9);
    EXPECT_NEAR(entrants[4].figures.ratioToAll->ratio, 2.5 / 3.0, 1e-9) << "and not 90 / 60";
    EXPECT_EQ(entrants[0].figures.ratioToAll->ratio, 1.0) << "drawing everything is drawn to the end";
    ASSERT_TRUE(left.headroomShare && choice.headroomShare);
    EXPECT_LT(left.headroomShare->ratio, choice.headroomShare->ratio);
    EXPECT_NEAR(choice.headroomShare->ratio, (1.0 - 5.0 / 12.5) / (1.0 - 2.0 / 12.5), 1e-9);
}

TEST(Advice, whatIsFasterThanTheLimitIsNotSaidToHaveNothingToGain) {
    advice::Advice advice;
    advice.request = requestFor(1);
    advice.strategies.emplace_back();
    advice.strategies[0].strategy = strategyFromText("depth-buffer");
    advice.strategies[0].ratioToAll = RatioEstimate{2.26, {2.0, 2.5}};
    advice.best = 0;
    advice.limitRatio = 1.2;
    EXPECT_THAT(advice::adviceText(advice), testing::AllOf(testing::HasSubstr("more than drawing exactly what is visible"),
                                                           testing::Not(testing::HasSubstr("No culling could gain"))));
    EXPECT_TRUE(nlohmann::json::parse(advice::adviceJson(advice))["strategies"][0]["lost_pixels"].is_null()) << "not judged";
}

TEST(Advice, answersWithAStrategyThatLosesNothingAndSaysWhatBecameOfEachOther) {
    const advice::Advice advice = advice::advise(requestFor(4));
    ASSERT_TRUE(advice.best);
    const advice::AdvisedStrategy& best = advice.strategies[*advice.best];
    EXPECT_NE(best.promise, Promise::Approximate);
    EXPECT_EQ(best.judgedViews, 4u);
    EXPECT_EQ(best.lostPixels, 0u);
    EXPECT_TRUE(best.ratioToAll);
    EXPECT_EQ(advice.strategies.size(), advice::candidates().size() + 1) << "and the limit of culling";
    EXPECT_TRUE(advice.limitRatio);
    size_t lossy = 0;
    for (const advice::AdvisedStrategy& strategy : advice.strategies) {
        EXPECT_FALSE(advice::standingWords(strategy).empty()) << strategyText(strategy.strategy);
        if (strategy.promise == Promise::Approximate && strategy.views > 0) {
            ++lossy;
            EXPECT_EQ(strategy.standing, advice::Standing::Loses) << strategyText(strategy.strategy);
        }
    }
    EXPECT_GT(lossy, 2u);
    EXPECT_THAT(advice::adviceText(advice), testing::HasSubstr("(< 3/4)"));
    const auto json = nlohmann::json::parse(advice::adviceJson(advice));
    EXPECT_EQ(json["recommended"], strategyText(best.strategy));
    EXPECT_EQ(json["strategies"].size(), advice.strategies.size());
    EXPECT_EQ(TradePlot(advice::tradePoints(advice), tradeFigure("ratio_to_all"), tradeFigure(kUsualUp)).empty(), false);
    const std::vector<const advice::AdvisedStrategy*> shown = advice::pictured(advice);
    ASSERT_FALSE(shown.empty());
    EXPECT_EQ(shown.front(), &best);
    std::set<std::string> once;
    for (const advice::AdvisedStrategy* one : shown) {
        EXPECT_NE(one->standing, advice::Standing::FarBehind) << strategyText(one->strategy);
        if (!one->everything) EXPECT_TRUE(once.insert(one->strategy.id).second) << strategyText(one->strategy);
    }
    EXPECT_LT(shown.size(), advice::tradePoints(advice).size()) << "values that the table has alone";
}

TEST(Advice, whatMayLoseSomethingIsChosenOnlyWithinTheAllowedLoss) {
    advice::AdviseRequest request = requestFor(2);
    request.maxMissed = 1.0;
    const advice::Advice advice = advice::advise(request);
    ASSERT_TRUE(advice.best);
    for (const advice::AdvisedStrategy& strategy : advice.strategies)
        if (strategy.promise == Promise::Approximate && strategy.views > 0)
            EXPECT_NE(strategy.standing, advice::Standing::Loses) << "everything may be lost";
    request.maxMissed = 1e-9;
    const advice::Advice strict = advice::advise(request);
    ASSERT_TRUE(strict.best);
    EXPECT_LE(strict.strategies[*strict.best].missedRate().value(), 1e-9);
}

TEST(Advice, aStopGivesWhatWasKnownByThen) {
    std::stop_source stop;
    stop.request_stop();
    const advice::Advice advice = advice::advise(requestFor(2), {nullptr, stop.get_token()});
    EXPECT_TRUE(advice.interrupted);
    EXPECT_FALSE(advice.best);
    EXPECT_THAT(advice::adviceText(advice), testing::HasSubstr("Nothing was measured"));
}

TEST(Pairs, eachIsComparedWithEachInBothOrders) {
    MeasureResult result;
    const auto add = [&](const std::string& id, std::vector<double> times) {
        RunMeasurement run;
        run.strategy = request(id);
        for (const double time : times) {
            run.frames.emplace_back();
            run.frames.back().frameMilliseconds = time;
            run.frames.back().frameTimes = {time};
        }
        result.runs.push_back(std::move(run));
    };
    add("all", {10.0, 12.0, 8.0});
    add("frustum", {5.0, 6.0, 4.0});
    add("backface", {10.0, 11.0, 9.0});
    const std::vector<PairOfRuns> pairs = pairsOf(result);
    ASSERT_EQ(pairs.size(), 6u);
    EXPECT_EQ(pairs[0].one, 0u);
    EXPECT_EQ(pairs[0].other, 1u);
    EXPECT_DOUBLE_EQ(pairs[0].ratio.ratio, 0.5) << "all is half as fast";
    EXPECT_DOUBLE_EQ(pairs[0].difference.ratio, -5.0);
    EXPECT_TRUE(pairs[0].decided());
    EXPECT_DOUBLE_EQ(pairs[2].ratio.ratio, 2.0);
    EXPECT_DOUBLE_EQ(pairs[2].difference.ratio, 5.0);
    EXPECT_FALSE(pairs[1].decided()) << "all and backface take the same time in the whole";
    EXPECT_THAT(pairText(pairs[1]), testing::StartsWith("≈ 1.00"));
    EXPECT_THAT(pairsText(result), testing::HasSubstr("2.00 [2.00, 2.00]"));
    EXPECT_EQ(std::ranges::count(pairsCsv(result), '\n'), 7);
}

TEST(WorstView, findsTheSideFromWhichAStrategyLoses) {
    // Seen from nearer than the distance nothing is lost; along +x an object stands out, so that its far side is beyond it.
    worst::WorstRequest request;
    request.scene = smallExperiment({}).scene;
    request.strategy = strategyFromText("draw-distance:distance=2.6");
    request.size = {64, 48};
    request.views = 120;
    const worst::WorstResult result = worst::worstView(request);
    ASSERT_FALSE(result.views.empty());
    EXPECT_LE(result.views.size(), 120u);
    const worst::TriedView& worst = result.views[result.worst];
    EXPECT_GT(worst.lostPixels, 0u);
    for (const worst::TriedView& view : result.views) EXPECT_LE(view.value, worst.value);
    // The parts of the map lie beside each other and cover all directions.
    double area = 0.0;
    for (const worst::TriedView& view : result.views)
        if (view.replaced == 0) area += (view.right - view.left) * (view.top - view.bottom);
    EXPECT_NEAR(area, 360.0 * 180.0, 1e-6);
    // Few views are spread over all directions, too, and from inside.
    for (const size_t few : {1, 2, 30, 60}) {
        request.views = few;
        const worst::WorstResult coarse = worst::worstView(request);
        EXPECT_LE(coarse.views.size(), few);
        area = 0.0;
        for (const worst::TriedView& view : coarse.views)
            if (view.replaced == 0) area += (view.right - view.left) * (view.top - view.bottom);
        EXPECT_NEAR(area, 360.0 * 180.0, 1e-6) << few << " views";
    }
    // Each point of the map belongs to one part that was not divided.
    const worst::TriedView* there = result.at({worst.azimuth(), worst.elevation()});
    ASSERT_NE(there, nullptr);
    EXPECT_EQ(there->replaced, 0u);
    EXPECT_LE(there->left, worst.azimuth());
    EXPECT_GE(there->top, worst.elevation());
    // The first pose of the file is the worst view, found again by a measurement.
    MeasureRequest again;
    again.scene = request.scene;
    again.strategies = {request.strategy};
    again.size = request.size;
    again.path = result.path(1);
    again.timing.fixedRepetitions = 1;
    EXPECT_NEAR(double(measure(again).runs.front().frames.front().lostPixels), double(worst.lostPixels),
                0.02 * double(worst.coveredPixels))
        << "but for the depth range of the path";
}

TEST(WorstView, saysThatNothingWasLostAsSoManyViews) {
    worst::WorstRequest request;
    request.scene = smallExperiment({}).scene;
    request.strategy = strategyFromText("frustum");
    request.size = {32, 24};
    request.views = 80;
    const worst::WorstResult result = worst::worstView(request);
    EXPECT_THAT(worst::worstText(result), testing::HasSubstr("lost nothing in 80 views (< 3/80)"));
    EXPECT_FALSE(worst::worstMap(result).bars.empty());
    request.of = worst::Of::Ratio;
    request.views = 12;
    const worst::WorstResult ratio = worst::worstView(request);
    EXPECT_FALSE(result.confirmed) << "losses are counted, not estimated";
    // What is stated was drawn after the search, of one of its five least values.
    ASSERT_TRUE(ratio.confirmed);
    EXPECT_TRUE(ratio.confirmed->hasInterval);
    EXPECT_LE(ratio.confirmed->ci95[0], ratio.confirmed->ratio);
    EXPECT_GE(ratio.confirmed->ci95[1], ratio.confirmed->ratio);
    EXPECT_LT(std::ranges::count_if(ratio.views, [&](const auto& view) { return view.value < ratio.views[ratio.worst].value; }),
              5);
    const auto json = nlohmann::json::parse(worst::worstJson(ratio));
    EXPECT_EQ(json["poses"][0]["eye"][0], ratio.views[ratio.worst].pose.eye.x) << "the first pose is the one that is stated";
    EXPECT_TRUE(json["views"][0]["covered_pixels"].is_null()) << "none is counted where times are compared";
    EXPECT_THAT(worst::worstText(ratio), testing::ContainsRegex("[0-9]+\\.[0-9]+ \\[[0-9]+\\.[0-9]+, "));
    request.of = worst::Of::Missed;
    request.views = 3;
    EXPECT_THAT(worst::worstText(worst::worstView(request)), testing::HasSubstr("lost nothing in 2 views.")) << "3/2 is no bound";
}

}  // namespace
}  // namespace cullscope::test::advice_test
