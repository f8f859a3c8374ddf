#pragma once

#include <filesystem>

#include "core/scene/scene_files.h"

namespace cullscope {

/// Of the files' names, without the dot.
inline constexpr const char* kIfcExtension = "ifc";
/// Whether a file is to be read as a building, by its extension.
[[nodiscard]] bool isIfcFile(const std::filesystem::path& path);

/// Reads a building as IFC 2x3 (STEP text, ISO 10303-21) by Assimp, in a process of its own: an element with a surface becomes an
/// object of its class, name and identifier; elements that are mapped from one shape share its mesh. Openings of walls are cut.
/// Metres, y up. Spaces, lines, and what Assimp does not know are left out, the last two with a remark. Placements are rounded to
/// floats by Assimp. Throws Error(Input) that says what is wrong, for other schemas too, and where it needs more memory than
/// `options` allow; Error(Interrupted) on a stop request.
[[nodiscard]] FileScene readIfcFile(const std::filesystem::path& path, const LoadOptions& options = {},
                                    const Progress& progress = {});

}  // namespace cullscope
