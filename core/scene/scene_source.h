#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/load.h"
#include "core/scene/scene.h"

namespace cullscope {

/// A scene and how it came about.
struct OpenedScene {
    ScenePointer scene;
    std::string specification;         ///< what was asked for: "field:mesh=…,n=20,spacing=2.5" or a file's path
    std::optional<LoadReport> report;  ///< where a file was read
};

struct SceneSourceOptions {
    std::vector<std::filesystem::path> modelFolders;  ///< searched first for `bunny` (`--models DIR`)
    LoadOptions load;
};

/// Opens SCENE of the command line: a mesh file, or a generator with parameters (`sphere:triangles=1e6`).
/// Throws Error(Usage) naming the parameter for a bad specification, Error(Input) for a bad file, Error(Interrupted) on stop.
[[nodiscard]] OpenedScene openScene(std::string_view specification, const SceneSourceOptions& options = {},
                                    const Progress& progress = {});

struct GeneratorParameter {
    std::string key;
    std::string defaultValue;
    std::string description;  ///< English, marked for translation
};
struct GeneratorInfo {
    std::string id;
    std::string description;  ///< English, marked for translation
    std::vector<GeneratorParameter> parameters;
};
/// What `cullbench list scenes` and the desktop's Generate menu show.
[[nodiscard]] const std::vector<GeneratorInfo>& sceneGenerators();

/// `bunny` where one is installed (see findBunny), else `teapot`: nothing to download.
[[nodiscard]] std::string defaultSceneSpecification(const SceneSourceOptions& options = {});

/// The real bunny: in the given folders, CULLSCOPE_MODELS, the installed data, /usr/share/glmark2/models; empty where there is
/// none.
[[nodiscard]] std::optional<std::filesystem::path> findBunny(const SceneSourceOptions& options);

}  // namespace cullscope
