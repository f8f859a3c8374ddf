#include "core/frame/words.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "core/base/message.h"

namespace cullscope {
namespace {

std::string digits(double number, int significant) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.*g", significant, number);
    return text.data();
}

}  // namespace

std::string Term::english() const {
    switch (form) {
        case Form::Name:
        case Form::Marked:
            return text;
        case Form::Count:
            return std::to_string(uint64_t(number));
        case Form::Length:
            return digits(number, 3);
        case Form::Angle:
            return digits(std::round(number * 180.0 / std::numbers::pi * 100.0) / 100.0, 5) + "°";
        case Form::Share:
            break;
    }
    return digits(100.0 * number, 3) + " %";
}

std::string Words::english() const {
    std::vector<std::string> arguments;
    for (const Term& term : terms) arguments.push_back(term.english());
    return fillIn(text, arguments);
}

}  // namespace cullscope
