#pragma once

#include <string>

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

/// What an object is split into.
struct SplitRule {
    enum class By {
        Components,  ///< what hangs together
        Clusters     ///< compact pieces of at most `triangles` triangles
    };
    By by = By::Components;
    size_t triangles = 5000;  ///< of a cluster, at least 1
};

/// Every object of a scene split (core/mesh/split.h), so that strategies which decide by objects have something to decide. Copies
/// of one mesh share their parts. Draws what `scene` draws and has its bounds. Throws Error(Usage) where there would be too many
/// objects, Error(Interrupted) on stop.
[[nodiscard]] ScenePointer splitScene(const Scene& scene, std::string name, const SplitRule& rule, const Progress& progress = {});

}  // namespace cullscope
