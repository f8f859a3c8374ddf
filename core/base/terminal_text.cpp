#include "core/base/terminal_text.h"

namespace cullscope {
namespace {

constexpr std::string_view kReplacement = "?";

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

}  // namespace

std::string terminalText(std::string_view text) {
    std::string shown;
    shown.reserve(text.size());
    while (!text.empty()) {
        const size_t bytes = characterBytes(text);
        const std::string_view character = text.substr(0, bytes);
        shown += bytes == 0 || isControl(character) ? kReplacement : character;
        text.remove_prefix(bytes == 0 ? 1 : bytes);
    }
    return shown;
}

}  // namespace cullscope
