#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cullscope {

enum class PictureFormat { Png, Jpeg, Tiff, Exr };

/// What a picture file holds, in the terms of the library of file formats: rows from the top.
struct PictureFileContent {
    int width = 0, height = 0;
    std::vector<uint8_t>
        bytes;  ///< sRGB with straight alpha, four a pixel (a JPEG's: three); empty where `linear` has the colours
    std::vector<float> linear;                               ///< linear colours multiplied by alpha, four a pixel
    std::vector<float> depth{};                              ///< an EXR's; empty: none
    std::vector<uint32_t> triangle{};                        ///< an EXR's; empty: none
    std::vector<std::pair<std::string, std::string>> texts;  ///< attributes: pairs of name and text
    std::string description;                                 ///< the image description, which JPEG and TIFF keep
    double dotsPerInch = 0.0;                                ///< 0: not stated
};

/// Why a picture file could not be made or read.
struct PictureFormatFailure {
    enum class Kind {
        Library,   ///< the library of the format says `reason`
        System,    ///< the system refuses: the `errno` is `code`
        NoSpace,   ///< the system gives a file in memory no more room: the `errno` is `code`
        NoMemory,  ///< no memory for the encoded bytes
        Size       ///< the file's picture is not flat or has more than the most pixels on a side: it has `width` and `height`
    };
    Kind kind;
    std::string reason{};  ///< its first line
    int code = 0;
    int width = 0, height = 0;
};

/// Picture files by OpenImageIO. It is a module of its own, opened with the first picture, because its two hundred libraries take
/// a quarter of a second to load, which no command that neither writes nor reads a picture has to wait for.
class PictureFormats {
public:
    /// The bytes of a file. They are made in memory, because with a full disk some picture libraries terminate the program and
    /// others report no error. Throws PictureFormatFailure.
    [[nodiscard]] virtual std::vector<unsigned char> encoded(PictureFormat format, const PictureFileContent& content) const = 0;

    /// What is read of a file.
    enum class Part {
        Header,  ///< no pixels, and no memory for them: size, texts, description, resolution
        All
    };
    /// Reads a file by the reader of that format alone, with the attributes whose names begin with `prefix`. Throws
    /// PictureFormatFailure where it is no such picture or has more than `mostPixels` on a side.
    [[nodiscard]] virtual PictureFileContent read(PictureFormat format, const std::string& path, std::string_view prefix,
                                                  int mostPixels, Part part) const = 0;

protected:
    ~PictureFormats() = default;
};

/// The name of the function that the module exports, of type PictureFormatsFunction.
inline constexpr const char* kPictureFormatsFunction = "cullscopePictureFormats";
using PictureFormatsFunction = const PictureFormats* (*)();

}  // namespace cullscope
