#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/scene_source.h"

namespace cullscope {

/// What a generator is asked for.
struct GeneratorRequest {
    GeneratorArguments& arguments;
    const GeneratorInfo& info;
    const SceneSourceOptions& options;
    const Progress& progress;
    std::string specification;
};

/// A generator: what is said of it, the function that makes its scene, and the one that says from the same arguments how large
/// the scene will be. Both throw Error(Usage) naming the parameter.
struct Generator {
    GeneratorInfo info;
    OpenedScene (*open)(GeneratorRequest& request);
    SceneEstimate (*estimate)(GeneratorRequest& request);
};

/// In the order in which lists and menus show them.
[[nodiscard]] const std::vector<Generator>& sceneGeneratorTable();

/// The scene of a file in any format that is read. Throws Error(Input).
[[nodiscard]] OpenedScene sceneOfFile(const std::filesystem::path& path, const SceneSourceOptions& options,
                                      const Progress& progress);

}  // namespace cullscope
