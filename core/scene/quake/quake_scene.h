#pragma once

#include <filesystem>

#include "core/scene/scene_files.h"

namespace cullscope {

/// Of the files' names, without the dot.
inline constexpr const char* kQuakeExtension = "bsp";
/// Whether a file is to be read as a level, by its extension.
[[nodiscard]] bool isQuakeFile(const std::filesystem::path& path);

/// Reads a level of Quake 3 (IBSP version 46). A draw surface becomes an object, named by its shader and its number in the file;
/// those of doors and other entities stand at the entity's origin. Curved surfaces are cut into kPatchChords chords a parabola
/// (quake/bezier_patch.h). Sky, surfaces that are not drawn and billboards are left out with a remark. The scene has the level's
/// units, z up, and the camera of the first player. Throws Error(Input) naming file and byte, the defect and what to do, or where
/// it needs more memory than `options` allow; Error(Interrupted) on a stop request.
[[nodiscard]] FileScene readQuakeFile(const std::filesystem::path& path, const LoadOptions& options = {},
                                      const Progress& progress = {});

}  // namespace cullscope
