#pragma once

#include <chrono>
#include <functional>
#include <vector>

#include "core/measure/statistics.h"

namespace cullscope::benchmark {

/// The numbers of each contestant, by round: all take their turn in every round, so that what else the machine does meets them
/// alike. The first `warmUp` rounds do not count.
[[nodiscard]] inline std::vector<std::vector<double>> inTurns(const std::vector<std::function<double()>>& contestants, int rounds,
                                                              int warmUp = 0) {
    std::vector<std::vector<double>> numbers(contestants.size());
    for (int round = -warmUp; round < rounds; ++round)
        for (size_t i = 0; i < contestants.size(); ++i) {
            const double number = contestants[i]();
            if (round >= 0) numbers[i].push_back(number);
        }
    return numbers;
}

[[nodiscard]] inline double medianOf(const std::vector<double>& values) { return quantile(values, 0.5); }

/// The ratios of the numbers of two contestants, by round.
[[nodiscard]] inline std::vector<double> ratiosOf(const std::vector<double>& upper, const std::vector<double>& lower) {
    std::vector<double> ratios;
    for (size_t i = 0; i < upper.size(); ++i) ratios.push_back(upper[i] / lower[i]);
    return ratios;
}

/// The milliseconds that a call takes.
template <typename Call>
double timeOf(const Call& call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace cullscope::benchmark
