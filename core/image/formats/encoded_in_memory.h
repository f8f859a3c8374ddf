#pragma once

#include <OpenImageIO/imageio.h>

#include <functional>
#include <string>
#include <vector>

namespace cullscope {

/// The first line of a library's error message, for use in a sentence.
[[nodiscard]] std::string firstLine(const std::string& text);

/// The complete bytes of a picture file that `output` makes of `spec` and the pixels that `writePixels` passes to it. Encoded in
/// memory, because with a full disk some picture libraries terminate the program and others report no error. Throws
/// PictureFormatFailure where memory runs out or the library fails.
[[nodiscard]] std::vector<unsigned char> encodedInMemory(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec,
                                                         const std::function<bool()>& writePixels);

}  // namespace cullscope
