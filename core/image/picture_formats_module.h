#pragma once

#include "core/image/formats/picture_formats.h"

namespace cullscope {

/// The module of picture formats, opened at the first call: lib/cullscope/picture_formats.so beside the folder of the program.
/// Throws Error(Usage) with the loader's reason where it cannot be opened.
[[nodiscard]] const PictureFormats& pictureFormats();

}  // namespace cullscope
