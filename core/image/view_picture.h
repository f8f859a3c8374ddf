#pragma once

#include "core/visibility/triangle_states.h"
#include "core/visibility/strategy.h"

namespace cullscope {

enum class Colouring { Shaded, Verdicts };

/// What the colours of boxes tell.
enum class BoxColouring {
    Verdict,
    Plane  ///< of the frustum, that rejected them; the frustum's planes have the same colours. Kept ones as with Verdict
};
/// "verdict", "plane": as in files and on the command line.
[[nodiscard]] const char* boxColouringId(BoxColouring colouring);

/// What a view shows besides what was drawn.
struct ViewLook {
    Colouring colouring = Colouring::Shaded;
    bool culledToo = true;  ///< with Verdicts: culled triangles are shown too; false: only what was drawn, holes stay holes
    bool frustum = false;   ///< the culling camera's frustum as lines, its far plane cut to the scene, and its eye
    bool boxes = false;     ///< the boxes that the strategy tests, coloured by verdict; of maps of directions: spheres and rays
    bool bands = false;     ///< the contour bands on the bounding spheres that lie inside the frustum, with their sizes
    bool kernel = false;    ///< the inner kernels of the objects that are not outside the frustum, with the horizon
    /// In place of the scene and everything over it: what was drawn of one object, in spherical coordinates (spherical_model.h).
    bool sphericalModel = false;
    BoxColouring boxColouring = BoxColouring::Verdict;  ///< with `boxes`

    /// Whether boxes have the planes' colours, and with them the frustum; where the strategy tests any.
    [[nodiscard]] bool byPlane() const { return boxes && boxColouring == BoxColouring::Plane; }
    bool operator==(const ViewLook&) const = default;
};
/// "verdicts", "boxes", … for all that a look shows: as in files and on the command line.
[[nodiscard]] std::vector<const char*> overlayIds(const ViewLook& look);

/// The colours of desktop.md by TriangleState, for light and dark backgrounds (chosen by the background's luminance).
[[nodiscard]] std::array<PaletteEntry, kTriangleStateCount> verdictPalette(const Vec3f& background);

/// Whether drawViewPicture reads the trace for this look; where not, an empty one may be given.
[[nodiscard]] bool needsTrace(const ViewLook& look);

/// Clears `target` and draws what `viewing` sees of the verdict that `strategy` gave for `culling`; the same in the desktop and
/// in cullbench. `verdict` and `trace` come from one cull; `known` holds its states (null: worked out here, without truth). With
/// a default look and one camera in both roles the picture is bit-identical to Renderer::draw of the verdict's list. Overlays are
/// never culled: parts of them that lie beyond `viewing`'s depth range are drawn too. In
/// spherical coordinates there are none, and no depth.
void drawViewPicture(Renderer& renderer, const SceneBuffers& buffers, const Strategy& strategy, const View& culling,
                     const View& viewing, const Verdict& verdict, const Trace& trace, const TriangleStates* known,
                     const ViewLook& look, const DrawStyle& style, Framebuffer& target);

}  // namespace cullscope
