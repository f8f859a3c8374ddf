#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/mesh/load.h"
#include "core/scene/scene.h"

namespace cullscope {

/// A scene of named polygons, with planes and a camera where it names them (docs/files.md, "Polygons").
struct PolygonScene {
    ScenePointer scene;
    LoadReport report;
};

/// Of the files' names, without the dot.
inline constexpr const char* kPolygonExtension = "polygons";
/// Whether a file is one of named polygons, by its extension.
[[nodiscard]] bool isPolygonFile(const std::filesystem::path& path);

/// Reads such a file, or its text. Throws Error(Input) naming file and line, the defect and what to do; Error(Interrupted) on a
/// stop request.
[[nodiscard]] PolygonScene readPolygonFile(const std::filesystem::path& path, const LoadOptions& options = {},
                                           const Progress& progress = {});
[[nodiscard]] PolygonScene readPolygonText(std::string_view text, const std::string& name, const Progress& progress = {});

}  // namespace cullscope
