#pragma once

#include <array>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/image/plane_colours.h"
#include "core/visibility/structure_snapshot.h"
#include "core/visibility/triangle_states.h"

namespace cullscope {

/// What lines over a picture are made for: who looks, and in which colours.
struct OverlayContext {
    const Scene& scene;
    const View& viewing;
    const DrawStyle& style;
    std::array<PaletteEntry, kTriangleStateCount> palette;  ///< by TriangleState
    Vec3f contrast;                                         ///< to the style's background
    std::array<Vec3f, kFrustumPlaneCount> planes{};         ///< by FrustumPlane
};

/// Lines of one width that are drawn together; widths are in units (DrawStyle::unit).
struct OverlayLines {
    std::vector<LineSegment> lines;
    LineStyle style;
    bool cased = false;  ///< with the background's colour on both sides, so that they are seen on surfaces
};

/// A mark of constant size in the picture, whatever its distance; nothing where the place lies behind the viewer.
enum class MarkShape { Ring, Dot, Cross };
void addMark(std::vector<LineSegment>& lines, const OverlayContext& context, const Vec3& place, double radius, MarkShape shape,
             const Vec3f& colour);

/// How many pixels a length in the world covers at a place; the picture's height where the place lies behind the viewer.
[[nodiscard]] double pixelsOf(const View& viewing, const Vec3& place, double length);

/// A frustum, its far plane cut to the scene, and its eye as a mark.
[[nodiscard]] std::vector<OverlayLines> frustumOverlay(const OverlayContext& context, const View& culling);

/// A frustum's corners as they are shown: the far plane cut to the scene.
[[nodiscard]] Frustum shownFrustum(const View& culling, const Scene& scene);

/// The planes of a frustum as borders within its faces, each in its colour.
[[nodiscard]] OverlayLines planeOverlay(const OverlayContext& context, const View& culling);

/// The twelve edges of a box.
void addBox(OverlayLines& overlay, const Box3& box, const Vec3f& colour);

/// Whether a group was tested: one within a group that was decided as a whole was not.
[[nodiscard]] bool wasTested(const SnapshotNode& group, const StructureSnapshot& snapshot);

/// The boxes of objects and tested groups: those that a plane rejected in its colour, stronger; the others by verdict.
[[nodiscard]] std::vector<OverlayLines> boxOverlayByPlane(const OverlayContext& context, const StructureSnapshot& snapshot);

/// The boxes of the objects, coloured by verdict.
[[nodiscard]] OverlayLines boxOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

/// The boxes of the groups of objects that were tested, coloured by verdict.
[[nodiscard]] OverlayLines groupOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

/// What strategies with maps of directions test in place of boxes, of every object that is not outside the frustum: the bounding
/// sphere as three great circles; where the frustum cuts it, the visible region on the sphere (dashed) with its boxes, and the
/// corner rays from the eye, with a ring where they enter the sphere, to a dot where they hit, or a cross at the region's corner
/// of a ray that misses (Han & Hong 2008, Figure 3). Of `spherical-lossless` the borders of the judged cells on the viewer's side
/// of the sphere, coloured by verdict, of those that are some pixels large.
[[nodiscard]] std::vector<OverlayLines> sphereOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

/// The contour bands on the bounding spheres: the circles between them, coloured by what became of the band's sectors beyond, the
/// one at 90° stronger, the axis with its start (ring) and end (dot), and to either side of it each band's S from the
/// axis outward (Han & Hong 2008, ViewMetrics 5 and 6). Of `spherical-horizon`, which has slopes, the height of the sight line
/// there. Circles that would lie closer than a few pixels are left out.
[[nodiscard]] std::vector<OverlayLines> bandOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

/// Whether there is a kernel to be shown.
[[nodiscard]] inline bool hasKernel(const spherical::MapSnapshot& map) {
    return map.kernel && map.kernel->filled() && map.decision.relation != spherical::SphereRelation::Outside;
}
/// The inner kernels of the objects that are not outside the frustum, but for those of a few pixels: the grid of a kernel's map
/// on its surface, as far as it faces the viewer and pixels keep the lines apart; its outline as the culling camera's eye sees
/// it, where the horizon was used; and the axis from the centre (dot) to that eye.
[[nodiscard]] std::vector<OverlayLines> kernelOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

}  // namespace cullscope
