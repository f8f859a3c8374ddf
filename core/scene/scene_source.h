#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/progress.h"
#include "core/mesh/load.h"
#include "core/scene/scene.h"
#include "core/scene/specification.h"

namespace cullscope {

/// A scene and where it came from.
struct OpenedScene {
    ScenePointer scene;
    std::string specification;         ///< as requested: "field:mesh=…,n=20,spacing=2.5" or a file's path
    std::optional<LoadReport> report;  ///< of the file, where one was read
};

struct SceneSourceOptions {
    std::vector<std::filesystem::path> modelFolders;  ///< searched first for `bunny` (`--models DIR`)
    LoadOptions load;
};

/// Opens SCENE of the command line: a mesh file, or a generator with parameters (`sphere:triangles=1e6`). A generator's mesh may
/// be the scene of another generator (`field:mesh=knot:triangles=1000,n=5`). Throws Error(Usage) naming the parameter for a bad
/// specification, Error(Input) for a bad file, Error(Interrupted) on a stop request.
[[nodiscard]] OpenedScene openScene(std::string_view specification, const SceneSourceOptions& options = {},
                                    const Progress& progress = {});

/// What a scene will have, by the numbers of its specification: nothing is made and no mesh is read.
struct SceneEstimate {
    std::optional<double> triangles;  ///< drawn ones, copies counted each; none: a mesh file tells it
    double objects = 1.0;
    double bytes = 0.0;  ///< of memory while it is made, without what a mesh file needs

    /// Above kOptionalAnalysisLimit triangles or kManyBytes: to be asked about before it is made.
    [[nodiscard]] bool large() const;
};
inline constexpr double kManyBytes = 1e9;
/// None for a file. Throws Error(Usage) for a bad specification.
[[nodiscard]] std::optional<SceneEstimate> estimateScene(std::string_view specification, const SceneSourceOptions& options = {});

/// The generators that `cullbench list scenes` and the desktop's Generate menu show.
[[nodiscard]] const std::vector<GeneratorInfo>& sceneGenerators();

/// A specification with every file name in it changed, at every nesting depth: to make paths absolute, or relative to another
/// file.
[[nodiscard]] std::string withFiles(std::string_view specification, const std::function<std::string(const std::string&)>& change);

/// `bunny` where it is installed (see findBunny), else `teapot`, which needs no file.
[[nodiscard]] std::string defaultSceneSpecification(const SceneSourceOptions& options = {});

/// The file of the Stanford bunny: searched in the given folders, CULLSCOPE_MODELS, the installed data,
/// /usr/share/glmark2/models; none where none of them has it.
[[nodiscard]] std::optional<std::filesystem::path> findBunny(const SceneSourceOptions& options);

}  // namespace cullscope
