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

/// The ratio of two contestants' times that took turns, by the one estimate (ratioOfTotals): the baseline's median ÷ the
/// subject's.
[[nodiscard]] inline RatioEstimate ratioInTurns(const std::vector<double>& baseline, const std::vector<double>& subject) {
    const ViewTimes times{baseline, subject};
    return ratioOfTotals({&times, 1});
}

/// The milliseconds that a call takes.
template <typename Call>
double timeOf(const Call& call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace cullscope::benchmark
