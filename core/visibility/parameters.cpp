#include "core/visibility/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "core/base/error.h"

namespace cullscope {
namespace {

std::string choicesOf(const ParameterDeclaration& declaration) {
    std::string text;
    for (const ParameterDeclaration::Choice& choice : declaration.choices) text += (text.empty() ? "" : ", ") + choice.id;
    return text;
}

[[noreturn]] void refuse(const ParameterDeclaration& declaration, std::string_view value) {
    const std::string given(value);
    switch (declaration.type) {
        case ParameterType::Boolean:
            throwUsage(CULLSCOPE_TR("%1=%2: %1 is true or false."), {declaration.key, given});
        case ParameterType::Choice:
            throwUsage(CULLSCOPE_TR("%1=%2: %1 is one of %3."), {declaration.key, given, choicesOf(declaration)});
        case ParameterType::Integer:
            throwUsage(CULLSCOPE_TR("%1=%2: %1 is a whole number between %3 and %4."),
                       {declaration.key, given, toText(declaration.minimum), toText(declaration.maximum)});
        case ParameterType::File:
            throwUsage(CULLSCOPE_TR("%1=%2: %1 is the name of a file."), {declaration.key, given});
        case ParameterType::Real:
            break;
    }
    throwUsage(CULLSCOPE_TR("%1=%2: %1 is a number between %3 and %4."),
               {declaration.key, given, toText(declaration.minimum), toText(declaration.maximum)});
}

bool allowed(const ParameterDeclaration& declaration, const ParameterValue& value) {
    switch (declaration.type) {
        case ParameterType::Boolean:
            return std::holds_alternative<bool>(value);
        case ParameterType::Integer: {
            const auto* integer = std::get_if<int64_t>(&value);
            return integer != nullptr && double(*integer) >= declaration.minimum && double(*integer) <= declaration.maximum;
        }
        case ParameterType::Real: {
            const auto* real = std::get_if<double>(&value);
            return real != nullptr && *real >= declaration.minimum && *real <= declaration.maximum;
        }
        case ParameterType::Choice: {
            const auto* id = std::get_if<std::string>(&value);
            return id != nullptr && std::any_of(declaration.choices.begin(), declaration.choices.end(),
                                                [&](const ParameterDeclaration::Choice& choice) { return choice.id == *id; });
        }
        case ParameterType::File:
            return std::holds_alternative<std::string>(value);
    }
    return false;
}

template <typename Number>
std::optional<Number> parsed(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

template <typename Number>
bool parseNumber(std::string_view text, ParameterValue& value) {
    const std::optional<Number> number = parsed<Number>(text);
    if (number) value = *number;
    return number.has_value();
}

bool parseBoolean(std::string_view text, ParameterValue& value) {
    const bool yes = text == "true" || text == "1" || text == "on" || text == "yes";
    const bool no = text == "false" || text == "0" || text == "off" || text == "no";
    value = yes;
    return yes || no;
}

bool parse(ParameterType type, std::string_view text, ParameterValue& value) {
    switch (type) {
        case ParameterType::Boolean:
            return parseBoolean(text, value);
        case ParameterType::Integer:
            return parseNumber<int64_t>(text, value);
        case ParameterType::Real:
            return parseNumber<double>(text, value);
        case ParameterType::Choice:
        case ParameterType::File:
            break;
    }
    value = std::string(text);
    return true;
}

}  // namespace

ParameterDeclaration choiceParameter(std::string key, std::string defaultId, std::string description,
                                     std::vector<ParameterDeclaration::Choice> choices) {
    ParameterDeclaration declaration;
    declaration.key = std::move(key);
    declaration.type = ParameterType::Choice;
    declaration.defaultValue = std::move(defaultId);
    declaration.description = std::move(description);
    declaration.choices = std::move(choices);
    return declaration;
}

ParameterDeclaration booleanParameter(std::string key, bool defaultValue, std::string description) {
    return {std::move(key), ParameterType::Boolean, defaultValue, 0.0, 0.0, "", std::move(description), {}};
}

ParameterDeclaration fileParameter(std::string key, std::string description) {
    return readWhenBuilding({std::move(key), ParameterType::File, std::string(), 0.0, 0.0, "", std::move(description), {}});
}

ParameterDeclaration bySize(ParameterDeclaration declaration, double from) {
    declaration.logarithmicFrom = from;
    return declaration;
}

ParameterSet::ParameterSet(const std::vector<ParameterDeclaration>& declarations) : m_declarations(declarations) {
    for (const ParameterDeclaration& each : m_declarations) m_values[each.key] = each.defaultValue;
}

void ParameterSet::set(std::string_view key, const ParameterValue& value) {
    const ParameterDeclaration& declared = declaration(key);
    if (!allowed(declared, value)) refuse(declared, toText(value));
    m_values[declared.key] = value;
}

void ParameterSet::setFromText(std::string_view key, std::string_view text) {
    const ParameterDeclaration& declared = declaration(key);
    ParameterValue value;
    if (!parse(declared.type, text, value) || !allowed(declared, value)) refuse(declared, text);
    m_values[declared.key] = value;
}

const ParameterValue& ParameterSet::value(std::string_view key) const {
    const auto found = m_values.find(key);
    if (found == m_values.end()) (void)declaration(key);
    return found->second;
}

const ParameterDeclaration& ParameterSet::declaration(std::string_view key) const {
    std::string known;
    for (const ParameterDeclaration& each : m_declarations) {
        if (each.key == key) return each;
        known += (known.empty() ? "" : ", ") + each.key;
    }
    if (known.empty()) throwUsage(CULLSCOPE_TR("There is no parameter \"%1\" here, and no other one."), {std::string(key)});
    throwUsage(CULLSCOPE_TR("There is no parameter \"%1\" here. Known: %2."), {std::string(key), known});
}

std::string toText(const ParameterValue& value) {
    if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
    if (const auto* integer = std::get_if<int64_t>(&value)) return std::to_string(*integer);
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), std::get<double>(value));
    return {buffer.data(), result.ptr};
}

ParameterDeclaration readWhenBuilding(ParameterDeclaration declaration) {
    declaration.use = ParameterUse::Building;
    return declaration;
}

std::string ParameterSet::buildText() const {
    std::string text;
    for (const ParameterDeclaration& declaration : m_declarations)
        if (declaration.use == ParameterUse::Building)
            text += (text.empty() ? "" : " ") + declaration.key + '=' + toText(value(declaration.key));
    return text;
}

}  // namespace cullscope
