#include "core/experiments/sweeps.h"

#include <algorithm>

namespace cullscope {

const std::vector<ParameterSweep>& fronts() {
    static const std::vector<ParameterSweep> kFronts{
        {"spherical", "rows", {"45", "90", "180", "360"}},
        {"spherical", "band", {"2.5", "5", "10", "20"}},
        {"spherical-lossless", "level", {"4", "5", "6", "7", "8", "0"}, "0"},
    };
    return kFronts;
}

std::vector<StrategyRequest> contestants(const std::vector<ParameterSweep>& chosen) {
    std::vector<StrategyRequest> requests;
    for (const ParameterSweep& front : chosen)
        for (const std::string& value : front.values) {
            StrategyRequest request{front.strategy, ParameterSet(findStrategy(front.strategy).info.parameters)};
            request.parameters.setFromText(front.key, value);
            const bool known = std::any_of(requests.begin(), requests.end(), [&](const StrategyRequest& other) {
                return other.id == request.id && other.parameters == request.parameters;
            });
            if (!known) requests.push_back(std::move(request));
        }
    return requests;
}

}  // namespace cullscope
