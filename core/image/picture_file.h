#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/camera.h"

namespace cullscope {

/// A picture in memory, as the GPU gives it: rows from the bottom.
struct Picture {
    Viewport size;
    std::vector<uint8_t> rgba;  ///< sRGB bytes with straight alpha (colours not multiplied by it)
    /// What it shows, for the file's metadata: pairs of name and text ("cullscope:scene", …).
    std::vector<std::pair<std::string, std::string>> metadata;
    std::vector<float> depth{};        ///< forward distance in the scene's units, infinity for nothing; empty: not known
    std::vector<uint32_t> triangle{};  ///< triangle number + 1, 0 for nothing; empty: not known
    double dotsPerInch = 0.0;          ///< for print; 0: not stated
};

/// The most bytes that a JPEG's or TIFF's metadata takes as JSON (OpenImageIO ends the program beyond what a JPEG can hold, and
/// reads 64 kB of a TIFF's).
inline constexpr size_t kMostDescriptionBytes = 60'000;

/// Writes PNG, JPEG, TIFF or EXR, by the extension; whole or not at all; "-" is standard output, as PNG. Metadata is kept in all
/// of them, under its names in PNG and EXR, as one JSON object in JPEG's and TIFF's image description.
/// PNG and TIFF keep colour and alpha byte by byte; JPEG (quality 95) shows `background` through what is transparent. EXR holds
/// linear half floats multiplied by alpha, as its readers expect, and alone keeps depth ("depth.Z") and triangles
/// ("triangle.ID"). Throws Error(Usage) where the extension is unknown, the metadata is too long for the format, or the place
/// cannot be written.
void writePicture(const std::filesystem::path& path, const Picture& picture, const Vec3f& background = Vec3f(1.0F));

/// Throws Error(Usage) where writePicture knows no format by this name's ending.
void requirePictureFormat(const std::filesystem::path& path);

/// Reads a picture of any format that OpenImageIO knows, with its "cullscope:" metadata and EXR's depth and triangles.
/// Throws Error(Input) where it is none, is damaged, or has more than 16384 pixels on a side.
[[nodiscard]] Picture readPicture(const std::filesystem::path& path);

/// Reversed depth samples of a view, as a framebuffer has them, as Picture::depth.
[[nodiscard]] std::vector<float> forwardDistances(const std::vector<float>& reversedDepth, const View& view);

/// Whether writing to this name keeps depth and triangles: it ends in .exr.
[[nodiscard]] bool keepsDepth(const std::filesystem::path& path);
/// Whether it keeps transparency: it does not end in .jpg or .jpeg.
[[nodiscard]] bool keepsAlpha(const std::filesystem::path& path);

}  // namespace cullscope
