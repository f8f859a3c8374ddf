#pragma once

#include <string>
#include <vector>

#include "core/measure/meter.h"

namespace cullscope {

/// The most strategies that are raced.
inline constexpr size_t kMostRaced = 8;

/// Two strategies of a measurement beside each other, over the views that both have.
struct PairOfRuns {
    size_t one = 0, other = 0;    ///< runs of the result
    RatioEstimate ratio;          ///< the other's total time ÷ that of the one: how many times as fast the one is
    RatioEstimate difference;     ///< milliseconds a view that the one takes less; bootstrap over the views
    double lostDifference = 0.0;  ///< of a million covered pixels, so many more are missed by the one; 0 where not judged

    /// Whether the ratio's interval excludes that they are equally fast.
    [[nodiscard]] bool decided() const { return ratio.hasInterval && (ratio.ci95[0] > 1.0 || ratio.ci95[1] < 1.0); }
};

/// Every pair of different runs that have frames, in both orders: by one, then by other.
[[nodiscard]] std::vector<PairOfRuns> pairsOf(const MeasureResult& result);

/// "1.31 [1.22, 1.40]"; a pair that is not decided has "≈" before it.
[[nodiscard]] std::string pairText(const PairOfRuns& pair);
[[nodiscard]] std::string pairsText(const MeasureResult& result);
[[nodiscard]] std::string pairsJson(const MeasureResult& result);
[[nodiscard]] std::string pairsCsv(const MeasureResult& result);

}  // namespace cullscope
