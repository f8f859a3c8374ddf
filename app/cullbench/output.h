#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <type_traits>

#include "core/base/terminal_text.h"

namespace cullscope::cullbench {

/// The program that reads standard output has ended: further output would be lost. Not an error.
struct ReaderGone {};

/// Prints a text as a terminal may show it (terminalText). What standard error does not take is lost: the exit status says what
/// happened, too. Where standard output does not take it, throws ReaderGone, or Error(Usage) with the system's reason.
void printText(std::FILE* out, std::string_view text);
/// What was printed reaches standard output; throws as printText.
void flushOutput();

/// Words within a line, which may be names, stay on it (terminalLine); other values are as they are.
template <typename Argument>
decltype(auto) onItsLine(const Argument& argument) {
    if constexpr (std::is_convertible_v<const Argument&, std::string_view>)
        return terminalLine(argument);
    else
        return (argument);
}

/// `printText` of a formatted text.
template <typename... Arguments>
void say(std::FILE* out, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    printText(out, fmt::vformat(format, fmt::make_format_args(onItsLine(arguments)...)));
}
template <typename... Arguments>
void say(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    say(stdout, format, std::forward<Arguments>(arguments)...);
}

}  // namespace cullscope::cullbench
