#include "core/image/exr_header.h"

#include <array>
#include <cstdint>
#include <fstream>

namespace cullscope {
namespace {

constexpr std::streamoff kFirstHeader = 8;  ///< behind the magic number and the version with its flags
constexpr size_t kLongestName = 255;

/// Passes over a name with its final zero; its length, or none where it has no end.
size_t passName(std::istream& in) {
    size_t length = 0;
    while (in.get() > 0)
        if (++length > kLongestName) in.setstate(std::ios::failbit);
    return length;
}

/// A little-endian number.
uint32_t nextNumber(std::istream& in) {
    std::array<char, 4> bytes{};
    in.read(bytes.data(), bytes.size());
    uint32_t value = 0;
    for (size_t i = bytes.size(); i-- > 0;) value = value << 8 | uint8_t(bytes[i]);
    return value;
}

}  // namespace

bool attributeExceedsFile(const std::filesystem::path& file) {
    std::error_code unknown;
    const uintmax_t bytes = std::filesystem::file_size(file, unknown);
    std::ifstream in(file, std::ios::binary);
    in.seekg(kFirstHeader);
    // Attributes until an empty name, and in files of several parts another header until one that begins with an empty name.
    for (bool afterHeader = true; in && !unknown;) {
        if (passName(in) == 0) {
            if (afterHeader) return false;
            afterHeader = true;
            continue;
        }
        afterHeader = false;
        passName(in);  // of its type
        const uint32_t size = nextNumber(in);
        const std::streamoff begin = in.tellg();
        if (!in) return false;
        if (size > bytes - uintmax_t(begin)) return true;
        in.seekg(begin + std::streamoff(size));
    }
    return false;
}

}  // namespace cullscope
