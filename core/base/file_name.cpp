#include "core/base/file_name.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/base/error.h"

namespace cullscope {
namespace {

/// Limit for the name of a scene or strategy, in bytes; file systems allow 255 for the whole file name.
constexpr size_t kMostNameBytes = 100;

bool isUnsafe(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f || std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
}

/// The longest prefix of at most `bytes` bytes that ends between two UTF-8 characters.
std::string_view shortened(std::string_view text, size_t bytes) {
    if (text.size() <= bytes) return text;
    while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) --bytes;
    return text.substr(0, bytes);
}

std::string safe(std::string_view text) {
    std::string name(text);
    std::replace_if(name.begin(), name.end(), isUnsafe, '-');
    // A file that begins with a dot is hidden; "." and ".." are folders.
    if (name.starts_with('.')) name.front() = '_';
    return name;
}

/// The minimum number of digits of the field {n} or {n:04}; none for another field.
std::optional<size_t> digitsOfCounter(std::string_view field) {
    if (field == "n") return 1;
    if (!field.starts_with("n:")) return std::nullopt;
    std::string_view width = field.substr(2);
    if (width.size() == 2 && width.front() == '0') width.remove_prefix(1);
    if (width.size() != 1 || width.front() < '1' || width.front() > '9') return std::nullopt;
    return static_cast<size_t>(width.front() - '0');
}

std::string filledIn(std::string_view pattern, std::string_view scene, std::string_view strategy, uint64_t number) {
    std::string name;
    while (!pattern.empty()) {
        const size_t open = std::min(pattern.find('{'), pattern.size());
        name += pattern.substr(0, open);
        pattern.remove_prefix(open);
        if (pattern.empty()) break;
        const size_t close = pattern.find('}');
        const std::string_view field = pattern.substr(1, close == std::string_view::npos ? close : close - 1);
        const std::optional<size_t> digits = digitsOfCounter(field);
        if (close == std::string_view::npos || (!digits && field != "scene" && field != "strategy"))
            throwUsage(CULLSCOPE_TR("File names have no field {%1}. There are {scene}, {strategy}, {n} and {n:04}."),
                       {std::string(field)});
        if (digits) {
            const std::string counted = std::to_string(number);
            name += std::string(*digits - std::min(*digits, counted.size()), '0') + counted;
        } else {
            name += shortened(field == "scene" ? scene : strategy, kMostNameBytes);
        }
        pattern.remove_prefix(close + 1);
    }
    return safe(name);
}

bool isTaken(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(std::filesystem::symlink_status(path, ignored));
}

}  // namespace

std::filesystem::path nextFileName(const std::filesystem::path& folder, std::string_view pattern, std::string_view scene,
                                   std::string_view strategy) {
    const bool counts = filledIn(pattern, scene, strategy, 1) != filledIn(pattern, scene, strategy, 2);
    for (uint64_t number = 1;; ++number) {
        const std::filesystem::path path = folder / filledIn(pattern, scene, strategy, number);
        if (!isTaken(path)) return path;
        if (!counts)
            throwUsage(CULLSCOPE_TR("%1 exists already: put {n} into the file name, and every picture gets a number of its own."),
                       {path.string()});
    }
}

}  // namespace cullscope
