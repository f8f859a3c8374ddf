#pragma once

#include <filesystem>

#include "core/image/formats/picture_formats.h"

namespace cullscope {

/// Whether a picture file states, before its pixels, a length that cannot be: in a PNG of a chunk that would end beyond the file;
/// in an OpenEXR file of an attribute that would, or whose value has another length. The libraries take memory for as many bytes
/// as are stated, up to 2 GB; and OpenEXR reads values of the types that it knows by their content, so that after one with a
/// wrong length it takes other bytes for lengths. False of other formats, and where a file is cut off or is none, which its
/// reader says. (PNG, "Chunk layout"; OpenEXR File Layout, "Header")
[[nodiscard]] bool statesWrongLength(PictureFormat format, const std::filesystem::path& file);

}  // namespace cullscope
