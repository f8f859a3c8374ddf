#include "core/mesh/numbers_in_text.h"

#include <charconv>
#include <limits>

namespace cullscope {
namespace {

bool isBlank(char character) { return character == ' ' || (character >= '\t' && character <= '\r'); }

char lower(char character) { return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character; }

bool hasNegativeExponent(std::string_view word) {
    const size_t exponent = word.find_first_of("eE");
    return exponent != std::string_view::npos && exponent + 1 < word.size() && word[exponent + 1] == '-';
}

}  // namespace

std::string_view takeWord(std::string_view& text) {
    size_t begin = 0;
    while (begin < text.size() && isBlank(text[begin])) ++begin;
    size_t end = begin;
    while (end < text.size() && !isBlank(text[end])) ++end;
    const std::string_view word = text.substr(begin, end - begin);
    text.remove_prefix(end);
    return word;
}

bool parseReal(std::string_view word, double& value) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error == std::errc::invalid_argument) return false;
    if (error == std::errc::result_out_of_range)
        value = hasNegativeExponent(word) ? 0.0 : std::numeric_limits<double>::infinity();
    if (stop == end) return true;
    if (*stop != '#') return false;  // 1.#QNAN, -1.#IND, 1.#INF
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
}

bool parseInteger(std::string_view word, int64_t& value) {
    if (word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+') word.remove_prefix(1);
    const char* end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return error == std::errc() && stop == end;
}

std::string shownWord(std::string_view text) {
    constexpr size_t kLongest = 40;
    std::string shown;
    for (const char character : text.substr(0, kLongest)) shown += character >= ' ' && character <= '~' ? character : '?';
    if (text.size() > kLongest) shown += "...";
    return shown;
}

bool startsWithIgnoringCase(std::string_view text, std::string_view start) {
    if (text.size() < start.size()) return false;
    for (size_t i = 0; i < start.size(); ++i)
        if (lower(text[i]) != lower(start[i])) return false;
    return true;
}

}  // namespace cullscope
