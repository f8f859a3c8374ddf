#pragma once

#include <array>
#include <span>
#include <vector>

namespace cullscope {

/// How many times as fast something is as a baseline, with a 95 % interval.
struct RatioEstimate {
    double ratio = 0.0;
    std::array<double, 2> ci95{};  ///< twice the ratio where there is none
    bool hasInterval = true;       ///< false: of a single number, which says nothing of its scatter

    bool operator==(const RatioEstimate&) const = default;
};

/// The frame times of one view in milliseconds: those at one place were taken in the same turn.
struct ViewTimes {
    std::vector<double> baseline, subject;
};

/// The one estimate behind every "×": the baseline's total time over the views ÷ the subject's, a view's time being the median of
/// its repetitions. The interval is a bootstrap (percentile method, 2000 resamples, fixed seed) over the views and, within each,
/// over the pairs of repetitions, so that a single view has one, too. A single view with one pair has none. Views without a pair
/// do not count; {0, {0, 0}} for no views.
[[nodiscard]] RatioEstimate ratioOfTotals(std::span<const ViewTimes> views);

/// The mean over the views of the ratio of their frame times, as papers quote it; nearly empty views rule it. The interval is a
/// bootstrap over the views (percentile method, 2000 resamples, fixed seed); a single view has none.
[[nodiscard]] RatioEstimate meanOfRatios(const std::vector<double>& ratios);

/// The quantile of the values at a share in [0, 1], interpolated linearly between ranks; 0 for no values.
[[nodiscard]] double quantile(std::vector<double> values, double share);

}  // namespace cullscope
