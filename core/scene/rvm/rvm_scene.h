#pragma once

#include <filesystem>

#include "core/scene/scene_files.h"

namespace cullscope {

/// Of the files' names, without the dot.
inline constexpr const char* kRvmExtension = "rvm";
/// Whether a file is to be read as one, by its extension.
[[nodiscard]] bool isRvmFile(const std::filesystem::path& path);

/// Reads an AVEVA RVM file. A group that owns primitives becomes an object of its name; the primitives stay parametric
/// (SceneRemarks::components) and are tessellated to `chordError` metres, large ones to a part in 5,000 of their size. Metres, z
/// up. Groups of one solid share the meshes of equal solids. Solids that cannot be are left out with a remark, and lines have no
/// surface. Throws Error(Input) naming file and byte, the defect and what to do, or where it needs more memory than `options`
/// allow; Error(Interrupted) on a stop request.
[[nodiscard]] FileScene readRvmFile(const std::filesystem::path& path, const LoadOptions& options = {},
                                    const Progress& progress = {}, double chordError = 1e-3);

}  // namespace cullscope
