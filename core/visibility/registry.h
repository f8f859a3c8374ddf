#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "core/visibility/strategy.h"

namespace cullscope {

/// A strategy with its properties.
struct RegisteredStrategy {
    StrategyInfo info;
    std::shared_ptr<const Strategy> strategy;
};

/// Every strategy, in the order in which lists show them. A new strategy needs one pair of files, and one line in
/// registry.cpp.
[[nodiscard]] const std::vector<RegisteredStrategy>& strategies();

/// The strategies that others are compared with, from the weakest to the strongest.
[[nodiscard]] std::vector<const StrategyInfo*> baselines();
/// The strategy with a role; not BaselineRole::None.
[[nodiscard]] const StrategyInfo& baselineOf(BaselineRole role);
/// The strategy that says what any culling could gain at most.
[[nodiscard]] const StrategyInfo& limitOfCulling();

/// What strategies declare to show, each id once, in the order of the registry. Where several strategies declare it, as the one
/// with the most colourings does.
[[nodiscard]] const std::vector<const Show*>& declaredShows();
/// Those of one kind.
[[nodiscard]] std::vector<const Show*> declaredShows(Show::Kind kind);
/// What a view's picture shows or not: commonShows with the declared overlays before the last one.
[[nodiscard]] const std::vector<const Show*>& pictureShows();
/// The same in the order in which the command line and pictures' texts name them.
[[nodiscard]] const std::vector<const Show*>& namedShows();
/// The ids of the strategies that declare a show, and of those that have a colouring of it, separated by commas.
[[nodiscard]] std::string strategiesShowing(std::string_view id, std::string_view colouring = {});

/// The strategy with this id. Throws Error(Usage) naming the known ids where there is none.
[[nodiscard]] const RegisteredStrategy& findStrategy(std::string_view id);

}  // namespace cullscope
