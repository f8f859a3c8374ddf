#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/gpu/renderer.h"
#include "core/scene/scene_source.h"

namespace cullscope::suite {

/// A scene of the suite, and from where it is looked at.
struct SuiteScene {
    std::string name;           ///< of its files, without an ending
    std::string specification;  ///< as `openScene` reads it
    std::string path;           ///< camera path
    std::vector<Viewport> sizes{{320, 240}};
};

/// The gallery's scenes that a mesh file can hold, with the cameras and sizes of their cases; and scenes of many objects.
[[nodiscard]] std::vector<SuiteScene> suiteScenes();

/// What was written of one scene.
struct WrittenScene {
    std::string name;
    uint64_t triangles = 0, objects = 0, poses = 0, visibleTriangles = 0;
};

/// Writes NAME.obj and NAME.required.json of every scene, battery.json with the cases, and README.md, which says what they are,
/// into a folder that is made where it is missing. The required sets are those of the file as it is read back. Needs a current
/// context. Throws Error(Usage) where a file cannot be written, Error(Interrupted) on a stop request.
[[nodiscard]] std::vector<WrittenScene> writeSuite(const std::filesystem::path& folder, const std::vector<SuiteScene>& scenes,
                                                   Renderer& renderer, const Progress& progress = {});

}  // namespace cullscope::suite
