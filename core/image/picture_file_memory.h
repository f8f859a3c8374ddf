#pragma once

#include <OpenImageIO/imageio.h>

#include <filesystem>
#include <functional>
#include <vector>

namespace cullscope {

/// A library's error, which may be several lines, as it stands in a sentence: the first of them.
[[nodiscard]] std::string firstLine(const std::string& text);

/// The bytes of a picture file that `output` makes of `spec` and of the pixels that `writePixels` gives it; all of them. In
/// memory, because some picture libraries end the program where a disk is full, and others do not notice. Throws Error(Usage)
/// naming `path`, the file that they are for, where there is no memory or the library refuses.
[[nodiscard]] std::vector<unsigned char> encodedInMemory(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec,
                                                         const std::function<bool()>& writePixels,
                                                         const std::filesystem::path& path);

}  // namespace cullscope
