#pragma once

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace cullscope {

using ParameterValue = std::variant<bool, int64_t, double, std::string>;

enum class ParameterType {
    Boolean,
    Integer,
    Real,
    Choice,
    File  ///< the name of a file, or nothing
};

/// When a parameter is read.
enum class ParameterUse {
    Culling,  ///< in every frame: a change of it builds nothing
    Building  ///< when the structure is built
};

/// The declaration of one parameter of a strategy; forms, the command line, sweeps and result files are derived from it.
struct ParameterDeclaration {
    struct Choice {
        std::string id;           ///< on the command line and in files
        std::string description;  ///< English, marked for translation
    };
    std::string key;
    ParameterType type = ParameterType::Real;
    ParameterValue defaultValue;
    double minimum = 0.0;  ///< of numbers, inclusive
    double maximum = 0.0;
    std::string unit;         ///< "", "px", "°", …
    std::string description;  ///< one English sentence, marked for translation
    std::vector<Choice> choices;
    ParameterUse use = ParameterUse::Culling;
    /// Of numbers whose size matters and not their difference: a slider goes by the logarithm from here on to the maximum, and
    /// its first position is the minimum, which may be 0. 0: by the difference, or as the range suggests.
    double logarithmicFrom = 0.0;
};

[[nodiscard]] ParameterDeclaration choiceParameter(std::string key, std::string defaultId, std::string description,
                                                   std::vector<ParameterDeclaration::Choice> choices);
[[nodiscard]] ParameterDeclaration booleanParameter(std::string key, bool defaultValue, std::string description);

/// The name of a file, which is read when building; none by default.
[[nodiscard]] ParameterDeclaration fileParameter(std::string key, std::string description);

/// The same parameter, read when building.
[[nodiscard]] ParameterDeclaration readWhenBuilding(ParameterDeclaration declaration);

/// The same parameter, with ParameterDeclaration::logarithmicFrom.
[[nodiscard]] ParameterDeclaration bySize(ParameterDeclaration declaration, double from);

/// Values of declared parameters; always complete and in range.
class ParameterSet {
public:
    ParameterSet() = default;
    /// All parameters at their defaults.
    explicit ParameterSet(const std::vector<ParameterDeclaration>& declarations);

    /// Throws Error(Usage) naming the key and the allowed values.
    void set(std::string_view key, const ParameterValue& value);
    void setFromText(std::string_view key, std::string_view text);

    [[nodiscard]] const ParameterValue& value(std::string_view key) const;
    [[nodiscard]] const std::string& choice(std::string_view key) const { return std::get<std::string>(value(key)); }
    [[nodiscard]] double real(std::string_view key) const { return std::get<double>(value(key)); }
    [[nodiscard]] int64_t integer(std::string_view key) const { return std::get<int64_t>(value(key)); }
    [[nodiscard]] bool boolean(std::string_view key) const { return std::get<bool>(value(key)); }
    [[nodiscard]] const std::vector<ParameterDeclaration>& declarations() const { return m_declarations; }

    /// "key=value" of the parameters that are read when building, separated by spaces.
    [[nodiscard]] std::string buildText() const;

    bool operator==(const ParameterSet& other) const { return m_values == other.m_values; }

private:
    [[nodiscard]] const ParameterDeclaration& declaration(std::string_view key) const;

    std::vector<ParameterDeclaration> m_declarations;
    std::map<std::string, ParameterValue, std::less<>> m_values;
};

[[nodiscard]] std::string toText(const ParameterValue& value);

}  // namespace cullscope
