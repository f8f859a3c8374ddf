#pragma once

#include <array>
#include <vector>

namespace cullscope {

/// Mean of per-pose ratios and its bootstrap 95 % interval (percentile method, 2000 resamples, fixed seed).
struct RatioEstimate {
    double mean = 0.0;
    std::array<double, 2> ci95{};
};
[[nodiscard]] RatioEstimate bootstrapMean(const std::vector<double>& ratios);

/// The value below which a share of the values lies (linear between ranks); 0 for none.
[[nodiscard]] double quantile(std::vector<double> values, double share);

}  // namespace cullscope
