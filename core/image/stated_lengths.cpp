#include "core/image/stated_lengths.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>

namespace cullscope {
namespace {

constexpr std::streamoff kVersionPlace = 4;  ///< behind the magic number
constexpr uint32_t kSeveralParts = 0x1000;   ///< a flag of the version
constexpr size_t kLongestName = 255;

/// The types whose values have one length.
constexpr std::array<std::pair<std::string_view, uint32_t>, 24> kLengths{{{"box2f", 16},
                                                                          {"box2i", 16},
                                                                          {"chromaticities", 32},
                                                                          {"compression", 1},
                                                                          {"deepImageState", 1},
                                                                          {"double", 8},
                                                                          {"envmap", 1},
                                                                          {"float", 4},
                                                                          {"int", 4},
                                                                          {"keycode", 28},
                                                                          {"lineOrder", 1},
                                                                          {"m33d", 72},
                                                                          {"m33f", 36},
                                                                          {"m44d", 128},
                                                                          {"m44f", 64},
                                                                          {"rational", 8},
                                                                          {"tiledesc", 9},
                                                                          {"timecode", 8},
                                                                          {"v2d", 16},
                                                                          {"v2f", 8},
                                                                          {"v2i", 8},
                                                                          {"v3d", 24},
                                                                          {"v3f", 12},
                                                                          {"v3i", 12}}};

/// A name, which ends with a zero byte.
std::string nextName(std::istream& in) {
    std::string name;
    for (int letter = in.get(); letter > 0; letter = in.get()) {
        name += char(letter);
        if (name.size() > kLongestName) in.setstate(std::ios::failbit);
    }
    return name;
}

/// A little-endian number.
uint32_t nextNumber(std::istream& in) {
    std::array<char, 4> bytes{};
    in.read(bytes.data(), bytes.size());
    uint32_t value = 0;
    for (size_t i = bytes.size(); i-- > 0;) value = value << 8 | uint8_t(bytes[i]);
    return value;
}

uint64_t lengthOfChannels(std::istream& in) {
    constexpr uint64_t kBesideItsName = 16;
    uint64_t length = 1;
    for (std::string name = nextName(in); in && !name.empty(); name = nextName(in)) {
        length += name.size() + 1 + kBesideItsName;
        in.seekg(kBesideItsName, std::ios::cur);
    }
    return length;
}

/// Of at most `most` bytes; more where a text is longer than these.
uint64_t lengthOfTexts(std::istream& in, uint64_t most) {
    uint64_t length = 0;
    while (in && length < most) {
        const uint32_t text = nextNumber(in);
        length += sizeof(text) + uint64_t{text};
        in.seekg(text, std::ios::cur);
    }
    return length;
}

uint64_t lengthOfPreview(std::istream& in) {
    const uint64_t width = nextNumber(in);
    return 8 + 4 * width * nextNumber(in);
}

/// The length of the value that comes next; none where a value of this type has any that is stated.
std::optional<uint64_t> lengthOf(std::string_view type, uint64_t stated, std::istream& in) {
    const auto known = std::ranges::find(kLengths, type, [](const auto& each) { return each.first; });
    if (known != kLengths.end()) return known->second;
    if (type == "chlist") return lengthOfChannels(in);
    if (type == "stringvector") return lengthOfTexts(in, stated);
    if (type == "preview") return lengthOfPreview(in);
    return std::nullopt;
}

bool exrStatesWrongLength(std::istream& in, uint64_t bytes) {
    in.seekg(kVersionPlace);
    const bool severalParts = (nextNumber(in) & kSeveralParts) != 0;
    // A header ends with an empty name. In a file of several parts another one follows, unless that is empty.
    for (size_t attributes = 0; in;) {
        if (nextName(in).empty()) {
            if (!severalParts || attributes == 0) return false;
            attributes = 0;
            continue;
        }
        ++attributes;
        const std::string type = nextName(in);
        const uint32_t stated = nextNumber(in);
        const std::streamoff begin = in.tellg();
        if (!in) return false;
        if (stated > bytes - uint64_t(begin)) return true;
        if (const auto length = lengthOf(type, stated, in); length && *length != stated) return true;
        in.seekg(begin + std::streamoff(stated));
    }
    return false;
}

bool pngStatesWrongLength(std::istream& in, uint64_t bytes) {
    constexpr std::streamoff kSignature = 8, kChecksum = 4;
    in.seekg(kSignature);
    while (in) {
        const uint32_t swapped = nextNumber(in);  // PNG's numbers begin with their highest byte
        const uint32_t stated = swapped << 24 | (swapped & 0xff00) << 8 | (swapped >> 8 & 0xff00) | swapped >> 24;
        std::array<char, 4> type{};
        in.read(type.data(), type.size());
        const std::streamoff begin = in.tellg();
        if (!in || std::string_view(type.data(), type.size()) == "IDAT") return false;
        if (stated > bytes - uint64_t(begin)) return true;
        in.seekg(begin + std::streamoff(stated) + kChecksum);
    }
    return false;
}

}  // namespace

bool statesWrongLength(PictureFormat format, const std::filesystem::path& file) {
    std::error_code unknown;
    const uintmax_t bytes = std::filesystem::file_size(file, unknown);
    std::ifstream in(file, std::ios::binary);
    if (unknown || !in) return false;
    if (format == PictureFormat::Exr) return exrStatesWrongLength(in, bytes);
    return format == PictureFormat::Png && pngStatesWrongLength(in, bytes);
}

}  // namespace cullscope
