#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/visibility/registry.h"

namespace cullscope {

/// A strategy by its id, with its parameters, as requested for drawing or measuring.
struct StrategyRequest {
    std::string id;
    ParameterSet parameters;
    std::shared_ptr<const RegisteredStrategy> own{};  ///< a strategy that is not in the registry; null: found by the id

    bool operator==(const StrategyRequest& other) const { return id == other.id && parameters == other.parameters; }
};
/// The requested strategy. Throws what findStrategy throws.
[[nodiscard]] const RegisteredStrategy& strategyOf(const StrategyRequest& request);

/// Parses a strategy written as `id` or `id:key=value:key=value`; other parameters are at their defaults. Throws Error(Usage)
/// naming an unknown id or key and the known ones.
[[nodiscard]] StrategyRequest strategyFromText(std::string_view text);

/// Several, each with commas in place of colons where one likes, as in scenes. A text that begins with "key=value" goes on with
/// the one before, so that a list taken apart at its commas is read, too: "A:key=value,key=value,B".
[[nodiscard]] std::vector<StrategyRequest> strategiesFromText(const std::vector<std::string>& texts);

/// "key=value" of each parameter that is not at its default.
[[nodiscard]] std::vector<std::string> changedParameters(const ParameterSet& parameters);

/// `strategyFromText` backwards: only what is not at its default is written.
[[nodiscard]] std::string strategyText(const StrategyRequest& strategy);

/// The same for tables and plots: `id key=value key=value`.
[[nodiscard]] std::string strategyLabel(const StrategyRequest& strategy);

/// The baselines that are not among the strategies at their defaults, each at its defaults: with them, every strategy has what it
/// is compared with.
[[nodiscard]] std::vector<StrategyRequest> missingBaselines(const std::vector<StrategyRequest>& strategies);

/// The baseline that draws all triangles by a facing rule: what a strategy with that rule is compared with.
[[nodiscard]] StrategyRequest baselineUnder(Facing rule);

/// "key=value" in its parts. Throws Error(Usage) where there is no '=' or nothing before it.
[[nodiscard]] std::pair<std::string, std::string> keyAndValue(std::string_view text);
/// Of a parameter, whose value is not empty on a command line.
[[nodiscard]] std::pair<std::string, std::string> parameterAndValue(std::string_view text);

}  // namespace cullscope
