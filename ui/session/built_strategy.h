#pragma once

#include <memory>
#include <mutex>
#include <string>

#include "core/scene/scene.h"
#include "core/visibility/strategy.h"

namespace cullscope::ui {

/// A strategy built for a scene, with the scene it needs. Views and measurements share it: `mutex` is held around `cull`.
struct BuiltStrategy {
    std::string id;
    ScenePointer scene;
    StrategyPointer strategy;
    std::mutex mutex;
};

using BuiltStrategyPointer = std::shared_ptr<BuiltStrategy>;

}  // namespace cullscope::ui
