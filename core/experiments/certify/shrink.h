#pragma once

#include <filesystem>
#include <optional>

#include "core/base/progress.h"
#include "core/experiments/certify/random_scenes.h"
#include "core/gpu/renderer.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::certify {

/// What a strategy does at one view.
struct Tried {
    bool promised = false;
    uint64_t lost = 0, covered = 0;
    std::vector<uint32_t> drawn;  ///< the triangles that it draws, ascending
};
/// Throws what the strategy throws for a scene that it does not serve.
[[nodiscard]] Tried tryView(const StrategyRequest& strategy, const ScenePointer& scene, const RandomView& view,
                            Renderer& renderer);

/// A scene and a view.
struct Example {
    ScenePointer scene;
    RandomView view;
};

/// The smallest example that is found by leaving out objects, then triangles, then pixels, in which the strategy still loses what
/// it promises to keep.
[[nodiscard]] Example shrunk(const StrategyRequest& strategy, Example example, Renderer& renderer, const Progress& progress = {});

/// Writes FILE.obj and FILE.json, which has the camera and what the strategy draws, for `judge` and `render`. Returns whether the
/// scene as it is read back shows the loss.
[[nodiscard]] bool writeExample(const std::filesystem::path& file, const StrategyRequest& strategy, const Example& example,
                                Renderer& renderer);

}  // namespace cullscope::certify
