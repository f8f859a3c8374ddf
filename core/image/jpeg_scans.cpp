#include "core/image/jpeg_scans.h"

#include <fstream>

namespace cullscope {
namespace {

constexpr int kStartOfScan = 0xDA, kEndOfImage = 0xD9;

/// The frame headers SOF0 to SOF15, without the tables that have numbers between theirs.
bool startsFrame(int marker) { return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC; }
/// Of these, those of progressive coding.
bool isProgressive(int marker) { return (marker & 3) == 2; }

int nextByte(std::istream& in) { return in.get(); }
int nextShort(std::istream& in) {
    const int high = in.get();
    return high << 8 | in.get();
}

/// The next marker, past the bytes that may fill the space before it; -1 at the end of the file.
int nextMarker(std::istream& in) {
    int byte = in.get();
    while (in && byte != 0xFF) byte = in.get();
    while (in && byte == 0xFF) byte = in.get();
    return in ? byte : -1;
}

}  // namespace

std::optional<Viewport> sizeKeptWhole(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    in.seekg(2);  // past the start of the image
    Viewport size;
    int components = 0;
    bool progressive = false;
    for (int marker = nextMarker(in); marker >= 0 && marker != kEndOfImage; marker = nextMarker(in)) {
        const std::streamoff begin = in.tellg();
        const int length = nextShort(in);
        if (startsFrame(marker)) {
            (void)nextByte(in);  // the bits of a sample
            size.height = nextShort(in);
            size.width = nextShort(in);
            components = nextByte(in);
            progressive = isProgressive(marker);
        }
        if (marker == kStartOfScan) {
            const bool several = progressive || nextByte(in) < components;
            return in && several ? std::optional(size) : std::nullopt;
        }
        in.seekg(begin + length);
    }
    return std::nullopt;
}

}  // namespace cullscope
