#include "core/visibility/strategy_request.h"
#include "tests/fuzz/support.h"
#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {
namespace {

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines(1);
    for (const char letter : text)
        if (letter == '\n')
            lines.emplace_back();
        else
            lines.back() += letter;
    return lines;
}

}  // namespace

/// A line for each time that the option was given.
void strategy_text(std::string_view input) {
    std::vector<StrategyRequest> strategies;
    if (!accepted({ErrorKind::Usage}, [&] { strategies = strategiesFromText(linesOf(input)); })) return;
    for (const StrategyRequest& strategy : strategies) {
        const StrategyRequest again = strategyFromText(strategyText(strategy));
        require(again.id == strategy.id && again.parameters == strategy.parameters,
                "a strategy that is written is read back as another one");
        (void)strategyLabel(strategy);
    }
    (void)missingBaselines(strategies);
}

}  // namespace cullscope::fuzz
