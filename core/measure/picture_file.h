#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/camera.h"

namespace cullscope {

/// A picture in memory, as the GPU gives it: RGBA bytes, rows from the bottom.
struct Picture {
    Viewport size;
    std::vector<uint8_t> rgba;
    /// What it shows, for the file's metadata: pairs of name and text ("cullscope:scene", …).
    std::vector<std::pair<std::string, std::string>> metadata;
};

/// Writes PNG, JPEG, TIFF or whatever OpenImageIO knows by the extension, whole or not at all; "-" is standard output, as PNG.
/// Throws Error(Usage) where the extension is unknown or the place cannot be written.
void writePicture(const std::filesystem::path& path, const Picture& picture);

/// Reads a picture's pixels (as RGBA, rows from the bottom) and its "cullscope:" metadata. Throws Error(Input).
[[nodiscard]] Picture readPicture(const std::filesystem::path& path);

}  // namespace cullscope
