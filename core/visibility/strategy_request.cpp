#include "core/visibility/strategy_request.h"

#include "core/base/error.h"

namespace cullscope {

std::pair<std::string, std::string> keyAndValue(std::string_view text) {
    const size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        throwUsage(CULLSCOPE_TR("\"%1\" is not of the form key=value."), {std::string(text)});
    return {std::string(text.substr(0, equals)), std::string(text.substr(equals + 1))};
}

StrategyRequest strategyFromText(std::string_view text) {
    size_t colon = text.find(':');
    StrategyRequest request;
    request.id = text.substr(0, colon);
    request.parameters = ParameterSet(findStrategy(request.id).info.parameters);
    if (request.parameters.declarations().empty() && colon != std::string_view::npos)
        throwUsage(CULLSCOPE_TR("The strategy \"%1\" has no parameters."), {request.id});
    while (colon != std::string_view::npos) {
        const size_t next = text.find(':', colon + 1);
        const auto [key, value] = keyAndValue(text.substr(colon + 1, next == std::string_view::npos ? next : next - colon - 1));
        request.parameters.setFromText(key, value);
        colon = next;
    }
    return request;
}

std::vector<std::string> changedParameters(const ParameterSet& parameters) {
    std::vector<std::string> changed;
    for (const ParameterDeclaration& parameter : parameters.declarations())
        if (const ParameterValue& value = parameters.value(parameter.key); value != parameter.defaultValue)
            changed.push_back(parameter.key + "=" + toText(value));
    return changed;
}

std::string strategyText(const StrategyRequest& strategy, std::string_view separator) {
    std::string text = strategy.id;
    for (const std::string& parameter : changedParameters(strategy.parameters)) text.append(separator).append(parameter);
    return text;
}

}  // namespace cullscope
