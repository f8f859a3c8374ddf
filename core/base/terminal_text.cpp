#include "core/base/terminal_text.h"

#include <array>
#include <cstdio>

namespace cullscope {
namespace {

constexpr std::string_view kReplacement = "?";

struct Character {
    std::string_view bytes;  ///< the byte alone where `valid` is false
    bool valid;              ///< UTF-8
};

unsigned byteAt(std::string_view text, size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; }

/// The number of bytes of the UTF-8 character at the text's beginning (RFC 3629, table 3-7 of Unicode); 0 where there is none.
size_t characterBytes(std::string_view text) {
    const unsigned first = byteAt(text, 0), second = byteAt(text, 1);
    if (first < 0x80) return 1;
    if (first < 0xC2 || first > 0xF4) return 0;
    // The second byte excludes longer forms than needed, surrogates, and what lies beyond U+10FFFF.
    const unsigned least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    const unsigned most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    if (second < least || second > most) return 0;
    const size_t bytes = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
    for (size_t i = 2; i < bytes; ++i)
        if ((byteAt(text, i) & 0xC0) != 0x80) return 0;
    return bytes;
}

/// Of U+0000 to U+001F, U+007F, and U+0080 to U+009F.
bool isControl(std::string_view character) {
    const unsigned first = byteAt(character, 0);
    if (character.size() == 2) return first == 0xC2 && byteAt(character, 1) < 0xA0;
    return character.size() == 1 && (first == 0x7F || (first < 0x20 && first != '\n' && first != '\t'));
}

bool isLineEndOrTab(std::string_view character) { return character == "\n" || character == "\t"; }

/// The text with each character as `written(character)` gives it.
template <typename Written>
std::string rewritten(std::string_view text, const Written& written) {
    std::string result;
    result.reserve(text.size());
    while (!text.empty()) {
        const size_t bytes = characterBytes(text);
        const Character character{text.substr(0, bytes == 0 ? 1 : bytes), bytes != 0};
        result += written(character);
        text.remove_prefix(character.bytes.size());
    }
    return result;
}

}  // namespace

std::string terminalText(std::string_view text) {
    return rewritten(text, [](const Character& character) {
        return !character.valid || isControl(character.bytes) ? kReplacement : character.bytes;
    });
}

std::string terminalLine(std::string_view text) {
    return rewritten(text, [](const Character& character) {
        const bool shown = character.valid && !isControl(character.bytes) && !isLineEndOrTab(character.bytes);
        return shown ? character.bytes : kReplacement;
    });
}

std::string plainName(std::string_view name) {
    return rewritten(name, [](const Character& character) {
        // In encodings of one byte a letter the controls above U+0080 are these bytes.
        const bool obeyed =
            character.valid ? isControl(character.bytes) || isLineEndOrTab(character.bytes) : byteAt(character.bytes, 0) < 0xA0;
        return obeyed ? std::string_view("_") : character.bytes;
    });
}

std::string plainJson(std::string_view json) {
    return rewritten(json, [](const Character& character) {
        if (!isControl(character.bytes)) return std::string(character.bytes);
        std::array<char, 8> escaped{};
        std::snprintf(escaped.data(), escaped.size(), "\\u%04x", byteAt(character.bytes, character.bytes.size() - 1));
        return std::string(escaped.data());
    });
}

}  // namespace cullscope
