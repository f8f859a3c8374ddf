#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/image/map_picture.h"
#include "core/image/view_picture.h"

namespace cullscope::cullbench {

/// What `render` shows besides what was drawn, and from where, as given on the command line.
struct OverlayOptions {
    std::vector<std::string> names;
    std::string below;         ///< what stands below the picture; empty: nothing
    std::string mapColouring;  ///< empty: by entries
    std::string boxColouring;  ///< empty: by verdict
    std::string eye, target, up;
    std::string cullingSize;
    double fovy = 0.0;                             ///< degrees; 0: the culling camera's
    double nearDistance = 0.0, farDistance = 0.0;  ///< 0: around the scene
    bool drawnOnly = false;

    /// Whether the viewing camera is another than the culling camera.
    [[nodiscard]] bool observer() const {
        return !eye.empty() || !target.empty() || !up.empty() || fovy > 0.0 || nearDistance > 0.0 || farDistance > 0.0;
    }
};

void addOverlayOptions(CLI::App& command, OverlayOptions& options);

/// What a picture shows: the scene with a look, or an index map in its place.
struct OverlayChoice {
    ViewLook look;
    std::optional<MapColouring> map;

    [[nodiscard]] bool replacesScene() const { return map || look.sphericalModel; }
    [[nodiscard]] bool needsTrace() const { return map || cullscope::needsTrace(look); }
};

/// Throws Error(Usage) for a name that is no overlay, naming those that are, or that cannot be shown together with the others.
[[nodiscard]] OverlayChoice overlaysOf(const OverlayOptions& options);

/// What stands below the picture: another choice, or the same seen from behind.
struct BelowChoice {
    OverlayChoice overlays;
    bool behind = false;
};
/// None where nothing was asked for; throws Error(Usage) for an unknown name.
[[nodiscard]] std::optional<BelowChoice> belowOf(const OverlayOptions& options, const OverlayChoice& above);

/// The camera from the other side of the scene's middle.
[[nodiscard]] Camera cameraBehind(const Camera& camera, const Scene& scene);

/// Throws Error(Usage) where the strategy has nothing at this view of what was chosen, saying why and what to do.
void requireOverlays(const OverlayChoice& choice, const std::string& strategy, const StructureSnapshot& snapshot,
                     const Scene& scene);

/// The index map that is shown: of the first object that is not outside the frustum, of the first one where all are. Null: the
/// strategy has none.
[[nodiscard]] const MapSnapshot* shownMap(const StructureSnapshot& snapshot);

/// The camera that looks: the culling camera with what was given in its place, its depth range fitted to the scene.
[[nodiscard]] Camera viewingCamera(const OverlayOptions& options, const Camera& culling, const Scene& scene);

/// The size of the culling camera's picture, which shapes its frustum: `size`, or what was given.
[[nodiscard]] Viewport cullingSize(const OverlayOptions& options, const Viewport& size);

}  // namespace cullscope::cullbench
