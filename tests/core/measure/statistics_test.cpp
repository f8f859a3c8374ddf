#include "core/measure/statistics.h"
#include "core/measure/meter.h"

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

TEST(BootstrapMean, meanAndIntervalAreThoseOfTheory) {
    EXPECT_EQ(bootstrapMean({}).mean, 0.0);
    const RatioEstimate constant = bootstrapMean({2, 2, 2, 2});
    EXPECT_EQ(constant.mean, 2.0);
    EXPECT_EQ(constant.ci95, (std::array{2.0, 2.0}));

    // 0 … 99: mean 49.5, standard error 28.87/10; the 95 % interval is ±1.96 of it, within the accuracy of 2000 resamples.
    std::vector<double> ramp(100);
    for (size_t i = 0; i < 100; ++i) ramp[i] = double(i);
    const RatioEstimate estimate = bootstrapMean(ramp);
    EXPECT_DOUBLE_EQ(estimate.mean, 49.5);
    EXPECT_NEAR(estimate.ci95[0], 49.5 - 1.96 * 2.887, 0.5);
    EXPECT_NEAR(estimate.ci95[1], 49.5 + 1.96 * 2.887, 0.5);
    EXPECT_EQ(bootstrapMean(ramp).ci95, estimate.ci95) << "the seed is not fixed";
}

}  // namespace
}  // namespace cullscope::statistics_test
