#include "core/experiments/sweeps.h"

#include <algorithm>

namespace cullscope {

const std::vector<ParameterSweep>& builtInSweeps() {
    static const std::vector<ParameterSweep> kSweeps{
        {"spherical", "rows", {"45", "90", "180", "360"}},
        {"spherical", "band", {"2.5", "5", "10", "20"}},
        {"spherical-lossless", "level", {"4", "5", "6", "7", "8", "0"}, "0"},
    };
    return kSweeps;
}

std::vector<StrategyRequest> requestsOf(const std::vector<ParameterSweep>& chosen) {
    std::vector<StrategyRequest> requests;
    for (const ParameterSweep& sweep : chosen)
        for (const std::string& value : sweep.values) {
            StrategyRequest request{sweep.strategy, ParameterSet(findStrategy(sweep.strategy).info.parameters)};
            request.parameters.setFromText(sweep.key, value);
            const bool known = std::any_of(requests.begin(), requests.end(), [&](const StrategyRequest& other) {
                return other.id == request.id && other.parameters == request.parameters;
            });
            if (!known) requests.push_back(std::move(request));
        }
    return requests;
}

}  // namespace cullscope
