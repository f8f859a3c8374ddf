#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/scene/camera.h"

namespace cullscope {

/// A picture in memory in the GPU's layout: rows from the bottom.
struct Picture {
    Viewport size;
    std::vector<uint8_t> rgba;  ///< sRGB bytes with straight alpha (colours not multiplied by it)
    /// The file's metadata, which describes the content: pairs of name and text ("cullscope:scene", …).
    std::vector<std::pair<std::string, std::string>> metadata;
    std::vector<float> depth{};        ///< forward distance in the scene's units, infinity where nothing is drawn; empty: not
                                       ///< known
    std::vector<uint32_t> triangle{};  ///< triangle number + 1, 0 where nothing is drawn; empty: not known
    double dotsPerInch = 0.0;          ///< for print; 0: not stated
};

/// The largest size of the metadata of a JPEG or TIFF as JSON, in bytes. OpenImageIO terminates the program beyond the limit of a
/// JPEG, and reads 64 kB of a TIFF's.
inline constexpr size_t kMostDescriptionBytes = 60'000;

/// Writes PNG, JPEG, TIFF or EXR, by the extension; completely or not at all; "-" is standard output, as PNG. Metadata is kept in
/// all of them, under its names in PNG and EXR, as one JSON object in JPEG's and TIFF's image description. PNG and TIFF keep the
/// bytes of colour and alpha; JPEG (quality 95) blends transparent pixels with `background`. EXR holds linear half floats
/// multiplied by alpha, as its readers expect, and is the only format that keeps depth ("depth.Z") and triangles ("triangle.ID").
/// Throws Error(Usage) where the extension is unknown, the metadata is too long for the format, or the file cannot be written.
void writePicture(const std::filesystem::path& path, const Picture& picture, const Vec3f& background = Vec3f(1.0F));

/// Throws Error(Usage) where writePicture does not support the extension of this name.
void requirePictureFormat(const std::filesystem::path& path);

/// Reads the "cullscope:" metadata of a PNG, JPEG, TIFF or EXR and nothing else: it takes no memory for the pixels that the file
/// states to have. Throws Error(Input) where the file is absent, begins in another way than its name says, is damaged before its
/// pixels, or states more than 16384 pixels on a side.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> readPictureMetadata(const std::filesystem::path& path);

/// Reads such a file with its pixels, and an EXR's depth and triangles. Throws as readPictureMetadata does, and for damaged
/// pixels.
[[nodiscard]] Picture readPicture(const std::filesystem::path& path);

/// Converts a framebuffer's reversed depth samples to Picture::depth.
[[nodiscard]] std::vector<float> forwardDistances(const std::vector<float>& reversedDepth, const View& view);

/// Whether a file of this name keeps depth and triangles: it ends in .exr.
[[nodiscard]] bool keepsDepth(const std::filesystem::path& path);
/// Whether a file of this name keeps transparency: it does not end in .jpg or .jpeg.
[[nodiscard]] bool keepsAlpha(const std::filesystem::path& path);

}  // namespace cullscope
