#include "core/visibility/strategy_request.h"

#include <algorithm>
#include <set>

#include "core/base/error.h"

namespace cullscope {
namespace {

/// With the empty ones.
std::vector<std::string> piecesAtCommas(const std::string& text) {
    std::vector<std::string> pieces(1);
    for (const char character : text) {
        if (character == ',')
            pieces.emplace_back();
        else
            pieces.back() += character;
    }
    return pieces;
}

std::string written(const StrategyRequest& strategy, char separator) {
    std::string text = strategy.id;
    for (const std::string& parameter : changedParameters(strategy.parameters)) text += separator + parameter;
    return text;
}

}  // namespace

std::pair<std::string, std::string> keyAndValue(std::string_view text) {
    const size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        throwUsage(CULLSCOPE_TR("\"%1\" is not of the form key=value."), {std::string(text)});
    return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

std::pair<std::string, std::string> parameterAndValue(std::string_view text) {
    std::pair<std::string, std::string> parameter = keyAndValue(text);
    if (parameter.second.empty()) throwUsage(CULLSCOPE_TR("\"%1\" is not of the form key=value."), {std::string(text)});
    return parameter;
}

const RegisteredStrategy& strategyOf(const StrategyRequest& request) {
    return request.own ? *request.own : findStrategy(request.id);
}

StrategyRequest strategyFromText(std::string_view text) {
    size_t colon = text.find(':');
    StrategyRequest request;
    request.id = text.substr(0, colon);
    request.parameters = ParameterSet(findStrategy(request.id).info.parameters);
    if (request.parameters.declarations().empty() && colon != std::string_view::npos)
        throwUsage(CULLSCOPE_TR("The strategy \"%1\" has no parameters."), {request.id});
    std::set<std::string> given;
    while (colon != std::string_view::npos) {
        const size_t next = text.find(':', colon + 1);
        const auto [key, value] =
            parameterAndValue(text.substr(colon + 1, next == std::string_view::npos ? next : next - colon - 1));
        request.parameters.setFromText(key, value);
        if (!given.insert(key).second) throwUsage(CULLSCOPE_TR("%1: %2 is given twice."), {std::string(text), key});
        colon = next;
    }
    return request;
}

std::vector<StrategyRequest> strategiesFromText(const std::vector<std::string>& texts) {
    std::vector<std::string> strategies;
    for (const std::string& text : texts)
        for (std::string& piece : piecesAtCommas(text)) {
            const size_t equals = piece.find('=');
            if (piece.empty())
                throwUsage(CULLSCOPE_TR("\"%1\" lacks a strategy before or behind a comma. Write A,B without more commas."),
                           {text});
            if (!strategies.empty() && equals != std::string::npos && equals < piece.find(':'))
                strategies.back() += ":" + piece;
            else
                strategies.push_back(std::move(piece));
        }
    std::vector<StrategyRequest> requests;
    for (const std::string& strategy : strategies) requests.push_back(strategyFromText(strategy));
    return requests;
}

std::vector<StrategyRequest> missingBaselines(const std::vector<StrategyRequest>& strategies) {
    std::vector<StrategyRequest> missing;
    for (const RegisteredStrategy& known : cullscope::strategies()) {
        StrategyRequest baseline{known.info.id, ParameterSet(known.info.parameters)};
        if (known.info.baseline != BaselineRole::None && std::ranges::find(strategies, baseline) == strategies.end())
            missing.push_back(std::move(baseline));
    }
    return missing;
}

StrategyRequest baselineUnder(Facing rule) {
    const StrategyInfo& info = baselineOf(rule == Facing::Front ? BaselineRole::FrontFaces : BaselineRole::Triangles);
    StrategyRequest baseline{info.id, ParameterSet(info.parameters)};
    if (rule == Facing::ByObject) baseline.parameters.setFromText("facing", "auto");
    return baseline;
}

std::vector<std::string> changedParameters(const ParameterSet& parameters) {
    std::vector<std::string> changed;
    for (const ParameterDeclaration& parameter : parameters.declarations())
        if (const ParameterValue& value = parameters.value(parameter.key); value != parameter.defaultValue)
            changed.push_back(parameter.key + "=" + toText(value));
    return changed;
}

std::string strategyText(const StrategyRequest& strategy) { return written(strategy, ':'); }

std::string strategyLabel(const StrategyRequest& strategy) { return written(strategy, ' '); }

}  // namespace cullscope
