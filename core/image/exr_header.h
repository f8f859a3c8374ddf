#pragma once

#include <filesystem>

namespace cullscope {

/// Whether an attribute in the header of an OpenEXR file states more bytes than the file has. OpenEXR takes memory for as many
/// before it reads them, up to 2 GB. False where the file is cut off or is none, which its reader says.
/// (OpenEXR File Layout, "Header")
[[nodiscard]] bool attributeExceedsFile(const std::filesystem::path& file);

}  // namespace cullscope
