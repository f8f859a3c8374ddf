#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

/// How an object is split.
struct SplitRule {
    enum class By {
        Components,  ///< connected components
        Clusters     ///< compact clusters of at most `triangles` triangles
    };
    By by = By::Components;
    size_t triangles = 5000;  ///< of a cluster, at least 1
};

/// The scene with every object split (core/mesh/split.h), so that strategies that decide by objects have more objects to decide
/// about. Instances of one mesh share its parts. The picture and the bounds are those of `scene`. Throws Error(Usage) where there
/// would be too many objects, Error(Interrupted) on a stop request.
[[nodiscard]] ScenePointer splitScene(const Scene& scene, std::string name, const SplitRule& rule, const Progress& progress = {});

}  // namespace cullscope
