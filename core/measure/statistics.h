#pragma once

#include <array>
#include <optional>
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

/// The frame times of one view in milliseconds: of something and of the limit, and of what each is compared with. Those at one
/// place were taken in the same turn.
struct TimesBesideLimit {
    std::vector<double> baseline, subject, baselineOfLimit, limit;
};

/// Which share of the time that could be saved is saved, over all views: (1 − subject ÷ baseline) ÷ (1 − limit ÷ its baseline), a
/// view's times being the medians of its repetitions. 1: as much as the limit; below 0: slower than the baseline. The interval is
/// a bootstrap over the views and, within each, over the turns (percentile method, 2000 resamples, fixed seed); a single view
/// with one turn has none. None where so little can be saved that 97.5 % of the resamples do not agree that there is something.
[[nodiscard]] std::optional<RatioEstimate> shareOfHeadroom(std::span<const TimesBesideLimit> views);

/// How many resamples a bootstrap takes.
inline constexpr size_t kResamples = 2000;
/// The percentiles 2.5 and 97.5 of resampled values: a 95 % interval.
[[nodiscard]] std::array<double, 2> middle95(const std::vector<double>& values);

/// The quantile of the values at a share in [0, 1], interpolated linearly between ranks; 0 for no values.
[[nodiscard]] double quantile(std::vector<double> values, double share);

}  // namespace cullscope
