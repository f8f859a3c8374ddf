#include "core/measure/statistics.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/random.h"

namespace cullscope {

RatioEstimate bootstrapMean(const std::vector<double>& ratios) {
    if (ratios.empty()) return {};
    const auto n = ratios.size();
    RatioEstimate estimate;
    estimate.mean = std::accumulate(ratios.begin(), ratios.end(), 0.0) / double(n);
    Random random(1);
    std::vector<double> means(2000);
    for (double& mean : means) {
        double sum = 0.0;
        for (size_t i = 0; i < n; ++i) sum += ratios[random.bits() % n];
        mean = sum / double(n);
    }
    estimate.ci95 = {quantile(means, 0.025), quantile(means, 0.975)};
    return estimate;
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0.0;
    std::sort(values.begin(), values.end());
    const double rank = share * double(values.size() - 1);
    const auto below = static_cast<size_t>(rank);
    const size_t above = std::min(below + 1, values.size() - 1);
    return values[below] + (values[above] - values[below]) * (rank - double(below));
}

}  // namespace cullscope
