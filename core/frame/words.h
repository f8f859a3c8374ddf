#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cullscope {

/// A value that a sentence of Words names. Numbers stay numbers, so that a user interface writes them as the user's language
/// does.
struct Term {
    enum class Form {
        Name,    ///< a text that is shown as it is, such as an object's name
        Marked,  ///< an English text that is marked for translation
        Count,   ///< a whole number
        Length,  ///< in scene or mesh units, or a ratio: three significant digits
        Angle,   ///< in radians; shown in degrees, rounded to 0.01°
        Share    ///< a fraction of 1; shown in per cent
    };
    Form form = Form::Name;
    std::string text{};   ///< of a Name and of a Marked one
    double number = 0.0;  ///< of all others

    [[nodiscard]] static Term name(std::string text) { return {Form::Name, std::move(text)}; }
    /// A number in a name, such as that of a row: without separators between thousands.
    [[nodiscard]] static Term plain(uint64_t number) { return name(std::to_string(number)); }
    [[nodiscard]] static Term marked(std::string text) { return {Form::Marked, std::move(text)}; }
    [[nodiscard]] static Term count(uint64_t number) { return {Form::Count, {}, double(number)}; }
    [[nodiscard]] static Term length(double number) { return {Form::Length, {}, number}; }
    [[nodiscard]] static Term angle(double radians) { return {Form::Angle, {}, radians}; }
    [[nodiscard]] static Term share(double number) { return {Form::Share, {}, number}; }

    [[nodiscard]] std::string english() const;
    bool operator==(const Term&) const = default;
};

/// A Message (base/message.h) whose arguments may be numbers: an English text, marked for translation, with the placeholders
/// `%1`, `%2`, … and what stands for them.
struct Words {
    std::string text{};
    std::vector<Term> terms{};

    [[nodiscard]] bool empty() const { return text.empty(); }
    [[nodiscard]] std::string english() const;
    bool operator==(const Words&) const = default;
};

}  // namespace cullscope
