#include "core/scene/viewport_text.h"

#include <charconv>

namespace cullscope {
namespace {

bool readPixels(std::string_view text, int& pixels) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pixels);
    return error == std::errc() && end == text.data() + text.size() && pixels >= 1 && pixels <= kMostPixels;
}

}  // namespace

std::optional<Viewport> viewportFromText(std::string_view text) {
    const size_t x = text.find_first_of("xX");
    Viewport size;
    if (x == std::string_view::npos || !readPixels(text.substr(0, x), size.width) || !readPixels(text.substr(x + 1), size.height))
        return std::nullopt;
    return size;
}

}  // namespace cullscope
