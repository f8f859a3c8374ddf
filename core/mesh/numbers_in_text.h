#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cullscope {

/// Removes the next word (separated by spaces, tabs and other blanks) from the front of `text` and returns it; empty where there
/// is none.
[[nodiscard]] std::string_view takeWord(std::string_view& text);

/// A real number in C notation, correctly rounded; NaN and infinities as spelled by C and by Microsoft's libraries. Numbers
/// outside of double's range become infinite or zero. False where the word as a whole is not a number.
[[nodiscard]] bool parseReal(std::string_view word, double& value);

/// A decimal integer; false where the word as a whole is not one or does not fit.
[[nodiscard]] bool parseInteger(std::string_view word, int64_t& value);

/// `text` for use in a message: at most 40 characters, unprintable ones replaced.
[[nodiscard]] std::string shownWord(std::string_view text);

/// Whether `text` starts with `start`, ignoring case.
[[nodiscard]] bool startsWithIgnoringCase(std::string_view text, std::string_view start);

}  // namespace cullscope
