#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/scene/scene_files.h"

namespace cullscope {

/// Of the files' names, without the dot.
inline constexpr const char* kPolygonExtension = "polygons";
/// Whether a file is one of named polygons, by its extension.
[[nodiscard]] bool isPolygonFile(const std::filesystem::path& path);

/// Reads such a file, or its text: a scene of named polygons, with planes and a camera where it names them (docs/files.md,
/// "Polygons"). Throws Error(Input) naming file and line, the defect and what to do; Error(Interrupted) on a
/// stop request.
[[nodiscard]] FileScene readPolygonFile(const std::filesystem::path& path, const LoadOptions& options = {},
                                        const Progress& progress = {});
[[nodiscard]] FileScene readPolygonText(std::string_view text, const std::string& name, const Progress& progress = {});

}  // namespace cullscope
