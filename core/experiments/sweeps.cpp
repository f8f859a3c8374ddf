#include "core/experiments/sweeps.h"

#include <algorithm>

#include "core/visibility/registry.h"

namespace cullscope {

const std::vector<ParameterSweep>& builtInSweeps() {
    static const std::vector<ParameterSweep> kSweeps = [] {
        std::vector<ParameterSweep> sweeps;
        for (const RegisteredStrategy& strategy : strategies())
            for (const DeclaredSweep& sweep : strategy.info.sweeps)
                sweeps.push_back({strategy.info.id, sweep.key, sweep.values, sweep.automatic});
        return sweeps;
    }();
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
