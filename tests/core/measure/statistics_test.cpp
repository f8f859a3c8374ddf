#include "core/measure/statistics.h"

#include <cmath>

#include "core/geometry/random.h"
#include "core/measure/meter.h"
#include "tests/support/long_mode.h"

namespace cullscope::statistics_test {
namespace {

TEST(Quantile, interpolatesBetweenRanks) {
    EXPECT_EQ(quantile({}, 0.5), 0.0);
    EXPECT_EQ(quantile({7}, 0.0), 7.0);
    EXPECT_EQ(quantile({7}, 1.0), 7.0);
    EXPECT_EQ(quantile({3, 1, 2}, 0.5), 2.0) << "unsorted";
    EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
    EXPECT_EQ(quantile({1, 2, 3, 4, 5}, 0.25), 2.0);
    EXPECT_EQ(quantile({1, 2, 3, 4, 5}, 0.0), 1.0);
    EXPECT_EQ(quantile({1, 2, 3, 4, 5}, 1.0), 5.0);
    EXPECT_DOUBLE_EQ(quantile({0, 10}, 0.95), 9.5);
}

TEST(MeanOfRatios, meanAndIntervalAreThoseOfTheory) {
    EXPECT_EQ(meanOfRatios({}), RatioEstimate());
    EXPECT_EQ(meanOfRatios({2, 2, 2, 2}), (RatioEstimate{2.0, {2.0, 2.0}}));

    // 0 … 99: mean 49.5, standard error 28.87/10; the 95 % interval is ±1.96 of it, within the accuracy of 2000 resamples.
    std::vector<double> ramp(100);
    for (size_t i = 0; i < 100; ++i) ramp[i] = double(i);
    const RatioEstimate estimate = meanOfRatios(ramp);
    EXPECT_DOUBLE_EQ(estimate.ratio, 49.5);
    EXPECT_NEAR(estimate.ci95[0], 49.5 - 1.96 * 2.887, 0.5);
    EXPECT_NEAR(estimate.ci95[1], 49.5 + 1.96 * 2.887, 0.5);
    EXPECT_EQ(meanOfRatios(ramp).ci95, estimate.ci95) << "the seed is not fixed";
}

/// A sample of the normal distribution (Box and Muller).
double normal(Random& random) {
    constexpr double kFullTurn = 6.283185307179586;
    return std::sqrt(-2.0 * std::log(1.0 - random.unit())) * std::cos(kFullTurn * random.unit());
}

/// A factor with median 1 and some late frames, as frame times have.
double noise(Random& random, double spread) { return std::exp(spread * normal(random)) * (random.unit() < 0.05 ? 1.5 : 1.0); }

/// Times of the baseline alone: views of 1 to 100 ms, each drawn `repetitions` times with 10 % noise.
std::vector<std::vector<double>> baselineTimes(size_t views, size_t repetitions, Random& random) {
    std::vector<std::vector<double>> times(views);
    for (std::vector<double>& view : times) {
        const double milliseconds = std::exp(random.between(0.0, std::log(100.0)));
        for (size_t i = 0; i < repetitions; ++i) view.push_back(milliseconds * noise(random, 0.1));
    }
    return times;
}

TEST(RatioOfTotals, equalTimesAreExactlyOne) {
    Random random(3);
    for (const size_t views : {1u, 2u, 17u, 300u})
        for (const size_t repetitions : {1u, 2u, 3u, 8u}) {
            std::vector<ViewTimes> times;
            for (const std::vector<double>& view : baselineTimes(views, repetitions, random)) times.push_back({view, view});
            EXPECT_EQ(ratioOfTotals(times), (RatioEstimate{1.0, {1.0, 1.0}, views * repetitions > 1}))
                << views << " views, " << repetitions << " times";
        }
}

TEST(RatioOfTotals, aConstantFactorIsFoundWithoutDoubt) {
    Random random(5);
    for (const double factor : {0.01, 0.7, 1.6, 3.0, 250.0})
        for (const size_t views : {1u, 12u}) {
            std::vector<ViewTimes> times;
            for (const std::vector<double>& view : baselineTimes(views, 5, random)) {
                times.push_back({view, view});
                for (double& milliseconds : times.back().subject) milliseconds /= factor;
            }
            const RatioEstimate estimate = ratioOfTotals(times);
            for (const double found : {estimate.ratio, estimate.ci95[0], estimate.ci95[1]})
                EXPECT_NEAR(found, factor, 1e-12 * factor);
        }
}

TEST(RatioOfTotals, nearlyEmptyViewsDoNotRule) {
    // Four views with all of the scene, from 500 to 315 ms, and 36 with next to nothing, from 4 to 0.2 ms.
    std::vector<ViewTimes> times(4, {{500, 501, 499}, {315, 316, 314}});
    times.resize(40, {{4, 4.1, 3.9}, {0.2, 0.21, 0.19}});
    std::vector<double> ratios;
    for (const ViewTimes& view : times) ratios.push_back(view.baseline[0] / view.subject[0]);
    EXPECT_NEAR(meanOfRatios(ratios).ratio, 18.2, 0.1) << "what a mean of ratios says of the same times";
    const RatioEstimate estimate = ratioOfTotals(times);
    EXPECT_NEAR(estimate.ratio, (4 * 500 + 36 * 4) / (4 * 315 + 36 * 0.2), 1e-12);
    EXPECT_NEAR(estimate.ratio, 1.69, 0.01);
    EXPECT_LT(estimate.ci95[1], 3.0);
}

TEST(RatioOfTotals, doesNotDependOnUnitOrDirection) {
    Random random(11);
    std::vector<ViewTimes> times, seconds, exchanged;
    for (const std::vector<double>& view : baselineTimes(9, 4, random)) {
        times.push_back({view, {}});
        for (const double milliseconds : view) times.back().subject.push_back(milliseconds * noise(random, 0.2) / 2);
        seconds.push_back(times.back());
        for (std::vector<double>* each : {&seconds.back().baseline, &seconds.back().subject})
            for (double& value : *each) value /= 1024;
        exchanged.push_back({times.back().subject, times.back().baseline});
    }
    const RatioEstimate estimate = ratioOfTotals(times), backward = ratioOfTotals(exchanged);
    EXPECT_EQ(ratioOfTotals(seconds), estimate);
    EXPECT_EQ(ratioOfTotals(times), estimate) << "the seed is not fixed";
    EXPECT_NEAR(backward.ratio, 1 / estimate.ratio, 1e-12);
    EXPECT_NEAR(backward.ci95[0], 1 / estimate.ci95[1], 1e-3);
    EXPECT_LT(estimate.ci95[0], estimate.ratio);
    EXPECT_GT(estimate.ci95[1], estimate.ratio);
}

TEST(RatioOfTotals, aSingleViewHasAnInterval) {
    const std::vector<ViewTimes> times{{{10, 12, 11, 30, 11}, {5, 5.5, 5.2, 5.1, 9}}};
    const RatioEstimate estimate = ratioOfTotals(times);
    EXPECT_DOUBLE_EQ(estimate.ratio, 11 / 5.2);
    EXPECT_LT(estimate.ci95[0], estimate.ratio);
    EXPECT_GT(estimate.ci95[1], estimate.ratio);
}

TEST(RatioOfTotals, onlyPairsCount) {
    EXPECT_EQ(ratioOfTotals({}), RatioEstimate());
    const std::vector<ViewTimes> nothing{{{}, {}}, {{1, 2}, {}}};
    EXPECT_EQ(ratioOfTotals(nothing), RatioEstimate());
    const std::vector<ViewTimes> some{{{6}, {2}}, {{100}, {}}};
    EXPECT_EQ(ratioOfTotals(some), (RatioEstimate{3.0, {3.0, 3.0}, false}));
}

TEST(RatioOfTotals, intervalHoldsItsEstimateHoweverFewAndScatteredTheTimes) {
    Random random(7);
    for (int experiment = 0; experiment < 300; ++experiment) {
        std::vector<ViewTimes> views(1 + random.bits() % 4);
        for (ViewTimes& view : views) {
            view.baseline.resize(1 + random.bits() % 4);
            view.subject.resize(1 + random.bits() % 4);
            for (std::vector<double>* times : {&view.baseline, &view.subject})
                for (double& time : *times) time = random.between(1.0, 30.0);
        }
        const RatioEstimate estimate = ratioOfTotals(views);
        EXPECT_LE(estimate.ci95[0], estimate.ratio) << experiment;
        EXPECT_GE(estimate.ci95[1], estimate.ratio) << experiment;
    }
}

TEST(RatioOfTotals, aSingleNumberHasNoInterval) {
    const ViewTimes once{{6}, {2}}, twice{{6, 7}, {2, 2}};
    EXPECT_FALSE(ratioOfTotals(std::vector{once}).hasInterval) << "one view, drawn once";
    EXPECT_TRUE(ratioOfTotals(std::vector{twice}).hasInterval);
    EXPECT_TRUE(ratioOfTotals(std::vector{once, once}).hasInterval) << "over the views";
    EXPECT_FALSE(meanOfRatios({3.0}).hasInterval);
    EXPECT_TRUE(meanOfRatios({3.0, 4.0}).hasInterval);
}

/// The share of experiments with a known ratio whose interval holds it. The ratio varies from view to view about it; the views of
/// an experiment are a sample of all, and so are the repetitions of a view.
double coverage(size_t views, size_t repetitions, double variety) {
    constexpr double kRatio = 2.0;
    const uint64_t experiments = test::howMany(400, 400);
    Random random(17);
    int held = 0;
    for (uint64_t experiment = 0; experiment < experiments; ++experiment) {
        std::vector<ViewTimes> times(views);
        for (ViewTimes& view : times) {
            const double subject = std::exp(random.between(0.0, std::log(10.0)));
            const double baseline = subject * kRatio * (1.0 + variety * (2.0 * random.unit() - 1.0));
            for (size_t i = 0; i < repetitions; ++i) {
                view.baseline.push_back(baseline * noise(random, 0.1));
                view.subject.push_back(subject * noise(random, 0.1));
            }
        }
        const RatioEstimate estimate = ratioOfTotals(times);
        if (estimate.ci95[0] <= kRatio && kRatio <= estimate.ci95[1]) ++held;
    }
    return double(held) / double(experiments);
}

TEST(RatioOfTotals, intervalHoldsTheKnownRatioInNineOfTenExperiments) {
    EXPECT_GE(coverage(16, 3, 0.5), 0.9);
    EXPECT_GE(coverage(40, 5, 0.5), 0.9);
    EXPECT_GE(coverage(16, 5, 0.0), 0.9) << "views that all have the same ratio";
    EXPECT_GE(coverage(1, 15, 0.0), 0.9) << "one view";
}

TEST(HeadroomShare, isOneForTheLimitZeroForTheBaselineAndBelowForWhatIsSlower) {
    std::vector<TimesBesideLimit> views;
    for (int i = 0; i < 8; ++i) views.push_back({{10.0 + i}, {0.0}, {10.0 + i}, {0.2 * (10.0 + i)}});
    const auto with = [&](double share) {
        for (TimesBesideLimit& view : views) view.subject = {view.baseline[0] - share * (view.baseline[0] - view.limit[0])};
        return shareOfHeadroom(views);
    };
    for (const double share : {1.0, 0.5, 0.0, -0.25}) {
        const std::optional<RatioEstimate> found = with(share);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->ratio, share, 1e-12);
        EXPECT_NEAR(found->ci95[0], share, 1e-12);
        EXPECT_NEAR(found->ci95[1], share, 1e-12);
    }
}

TEST(HeadroomShare, holdsEachAgainstItsOwnBaseline) {
    // Saves half of its baseline's time, where the limit saves three quarters of its own.
    const std::vector<TimesBesideLimit> views{{{8.0}, {4.0}, {20.0}, {5.0}}, {{2.0}, {1.0}, {4.0}, {1.0}}};
    const std::optional<RatioEstimate> share = shareOfHeadroom(views);
    ASSERT_TRUE(share);
    EXPECT_NEAR(share->ratio, 0.5 / 0.75, 1e-12);
    EXPECT_TRUE(share->hasInterval);
    EXPECT_FALSE(shareOfHeadroom(std::span(views).first(1))->hasInterval);
}

TEST(HeadroomShare, isNotStatedWhereNothingCanBeSavedForCertain) {
    EXPECT_FALSE(shareOfHeadroom({}));
    const std::vector<TimesBesideLimit> none{{{8.0}, {8.0}, {8.0}, {8.0}}, {{8.0}, {8.0}, {8.0}, {9.0}}};
    EXPECT_FALSE(shareOfHeadroom(none));
    // The totals say that a thousandth can be saved; half of the resamples say that nothing can.
    const std::vector<TimesBesideLimit> unsure{{{10.0}, {10.0}, {10.0}, {11.98}}, {{10.0}, {10.0}, {10.0}, {8.0}}};
    EXPECT_FALSE(shareOfHeadroom(unsure));
}

TEST(HeadroomShare, ofOneViewHasTheScatterOfItsTurns) {
    const std::vector<double> all{10.0, 10.2, 9.9, 10.1, 10.0}, half{7.4, 7.6, 7.5, 7.7, 7.5}, limit{5.0, 5.1, 4.9, 5.0, 5.2};
    const std::vector<TimesBesideLimit> certain{{all, half, all, limit}};
    const std::optional<RatioEstimate> share = shareOfHeadroom(certain);
    ASSERT_TRUE(share);
    EXPECT_NEAR(share->ratio, 0.5, 1e-9);
    EXPECT_TRUE(share->hasInterval);
    EXPECT_LT(share->ci95[0], share->ratio);
    EXPECT_GT(share->ci95[1], share->ratio);
    EXPECT_GT(share->ci95[0], 0.4);
    EXPECT_LT(share->ci95[1], 0.6);
    // The median saves something, two of five turns do not.
    const std::vector<TimesBesideLimit> unsure{{all, half, all, {9.5, 9.6, 10.4, 10.9, 9.7}}};
    EXPECT_FALSE(shareOfHeadroom(unsure));
}

}  // namespace
}  // namespace cullscope::statistics_test
