#pragma once

#include <array>
#include <vector>

namespace cullscope {

/// Mean of the ratios of all poses and its bootstrap 95 % interval (percentile method, 2000 resamples, fixed seed).
struct RatioEstimate {
    double mean = 0.0;
    std::array<double, 2> ci95{};
};
[[nodiscard]] RatioEstimate bootstrapMean(const std::vector<double>& ratios);

/// The quantile of the values at a share in [0, 1], interpolated linearly between ranks; 0 for no values.
[[nodiscard]] double quantile(std::vector<double> values, double share);

}  // namespace cullscope
