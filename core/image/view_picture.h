#pragma once

#include <set>
#include <string>

#include "core/gpu/renderer.h"
#include "core/visibility/built_strategy.h"
#include "core/visibility/triangle_states.h"
#include "core/visibility/verdict_palette.h"

namespace cullscope {

enum class Colouring { Shaded, Verdicts };

/// The meaning of the boxes' colours.
enum class BoxColouring {
    Verdict,
    Plane  ///< the frustum plane that rejected the box; the frustum is drawn in the same colours. Kept boxes as with Verdict
};
/// The id used in files and on the command line: "verdict", "plane".
[[nodiscard]] const char* boxColouringId(BoxColouring colouring);

/// What a view shows besides the drawn triangles.
struct ViewLook {
    Colouring colouring = Colouring::Shaded;
    bool culledToo = true;  ///< with Verdicts: culled triangles are shown too; false: only what was drawn, holes stay holes
    bool frustum = false;   ///< the culling camera's frustum as lines, its far plane cut to the scene, and its eye
    bool boxes = false;     ///< the boxes that the strategy tests, coloured by verdict, or the strategy's own form of them
    std::set<std::string> overlays{};  ///< ids of overlays that strategies declare (visibility/show.h)
    /// Instead of the scene and all overlays: the drawn triangles of one object in spherical coordinates (spherical_model.h).
    bool sphericalModel = false;
    BoxColouring boxColouring = BoxColouring::Verdict;  ///< with `boxes`

    /// Whether boxes and frustum have the planes' colours, if the strategy tests any boxes.
    [[nodiscard]] bool byPlane() const { return boxes && boxColouring == BoxColouring::Plane; }
    /// Whether a declared overlay is shown, and the same look with it or without it.
    [[nodiscard]] bool shows(const std::string& overlay) const { return overlays.contains(overlay); }
    void show(const std::string& overlay, bool on) {
        if (on)
            overlays.insert(overlay);
        else
            overlays.erase(overlay);
    }
    /// Takes away all lines that lie over the picture.
    void leaveOutOverlays() {
        frustum = boxes = false;
        overlays.clear();
    }
    bool operator==(const ViewLook&) const = default;
};
/// "verdicts", "boxes", … for all that a look shows: as in files and on the command line.
[[nodiscard]] std::vector<std::string> overlayIds(const ViewLook& look);

/// Whether drawViewPicture reads decisions for this look; if not, the frame need not be recorded.
[[nodiscard]] bool needsDecisions(const ViewLook& look);

/// Clears `target` and replays a frame of `strategy` as seen by `viewing`; the same in the desktop and in cullbench. `known`
/// holds its triangles' states (null: computed here, without ground truth). With a default look and one camera in both roles the
/// picture is bit-identical to the one that the frame drew. Overlays are never culled: their parts beyond `viewing`'s depth range
/// are drawn too. In spherical coordinates there are no overlays and no depth.
void drawViewPicture(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, const FrameLog& log,
                     const View& viewing, const TriangleStates* known, const ViewLook& look, const DrawStyle& style,
                     Framebuffer& target);

}  // namespace cullscope
