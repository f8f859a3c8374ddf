#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace cullscope {

/// Takes the next word (separated by spaces, tabs and other blanks) off the front of `text`; empty when there is none.
[[nodiscard]] std::string_view takeWord(std::string_view& text);

/// A real number in C notation, correctly rounded; NaN and infinities in the spellings of C and of Microsoft's libraries.
/// Numbers beyond double become infinite or zero. False where the whole word is no number.
[[nodiscard]] bool parseReal(std::string_view word, double& value);

/// A decimal integer; false where the whole word is none or does not fit.
[[nodiscard]] bool parseInteger(std::string_view word, int64_t& value);

/// `text` fit for a message: at most 40 characters, everything unprintable replaced.
[[nodiscard]] std::string shownWord(std::string_view text);

/// Whether `text` starts with `start`, upper and lower case alike.
[[nodiscard]] bool startsWithIgnoringCase(std::string_view text, std::string_view start);

}  // namespace cullscope
