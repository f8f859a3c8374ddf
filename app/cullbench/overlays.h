#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "core/image/view_picture.h"
#include "core/scene/section.h"

namespace cullscope::cullbench {

/// What `render` shows besides the drawn triangles, and from which camera, as given on the command line.
struct OverlayOptions {
    std::vector<std::string> names;
    std::string below;         ///< content of the second picture below the first; empty: no second picture
    std::string mapColouring;  ///< empty: by entries
    std::string boxColouring;  ///< empty: by verdict
    std::string eye, target, up;
    std::string cullingSize;
    std::string section;  ///< empty: nothing is cut away
    double fovy = 0.0;    ///< degrees; 0: the culling camera's
    ProjectionOptions projection;
    double nearDistance = 0.0, farDistance = 0.0;  ///< 0: around the scene
    bool drawnOnly = false;

    /// Whether the viewing camera differs from the culling camera.
    [[nodiscard]] bool observer() const {
        return !eye.empty() || !target.empty() || !up.empty() || fovy > 0.0 || projection.given() || nearDistance > 0.0 ||
               farDistance > 0.0;
    }
};

void addOverlayOptions(CLI::App& command, OverlayOptions& options);

/// The content of a picture: the scene with a look, or a picture that the strategy declares in its place.
struct OverlayChoice {
    ViewLook look;
    std::string picture;    ///< id of the strategy's picture; empty: the scene
    std::string colouring;  ///< of that picture

    [[nodiscard]] bool replacesScene() const { return !picture.empty() || look.inPlace(); }
    [[nodiscard]] bool needsDecisions() const { return !picture.empty() || cullscope::needsDecisions(look); }
};

/// Throws Error(Usage) for a name that is no overlay, naming those that are, or that cannot be shown together with the others.
[[nodiscard]] OverlayChoice overlaysOf(const OverlayOptions& options);

/// The content of the second picture below: other overlays, or the same from the opposite side.
struct BelowChoice {
    OverlayChoice overlays;
    bool behind = false;
};
/// None where no second picture was requested; throws Error(Usage) for an unknown name.
[[nodiscard]] std::optional<BelowChoice> belowOf(const OverlayOptions& options, const OverlayChoice& above);

/// The camera reflected to the other side of the scene's middle.
[[nodiscard]] Camera cameraBehind(const Camera& camera, const Scene& scene);

/// Throws Error(Usage), with the reason and what to do, where the strategy has nothing to show of this frame for a chosen
/// overlay.
void requireOverlays(const OverlayChoice& choice, const BuiltStrategy& strategy, const FrameLog& log);

/// The viewing camera: the culling camera with the values given on the command line, its depth range fitted to the scene.
[[nodiscard]] Camera viewingCamera(const OverlayOptions& options, const Camera& culling, const Scene& scene);

/// The plane that cuts the pictures; none where none is given. Throws Error(Usage) for a text that names none.
[[nodiscard]] std::optional<Section> sectionOf(const OverlayOptions& options);

/// The size of the culling camera's picture, which determines its frustum: the one given, else `size`.
[[nodiscard]] Viewport cullingSize(const OverlayOptions& options, const Viewport& size);

}  // namespace cullscope::cullbench
