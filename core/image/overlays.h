#pragma once

#include <array>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/image/plane_colours.h"
#include "core/visibility/structure_snapshot.h"
#include "core/visibility/triangle_states.h"

namespace cullscope {

/// The input of all overlays: scene, viewing camera and colours.
struct OverlayContext {
    const Scene& scene;
    const View& viewing;
    const DrawStyle& style;
    std::array<PaletteEntry, kTriangleStateCount> palette;  ///< by TriangleState
    Vec3f contrast;                                         ///< the colour that contrasts with the style's background
    std::array<Vec3f, kFrustumPlaneCount> planes{};         ///< by FrustumPlane
};

/// Lines of one width that are drawn together; widths in units (DrawStyle::unit).
struct OverlayLines {
    std::vector<LineSegment> lines;
    LineStyle style;
    bool cased = false;  ///< with a border of the background's colour on both sides, so that they are visible on surfaces
};

/// A mark of constant size in the picture, independent of its distance; none where the place lies behind the viewing camera.
enum class MarkShape { Ring, Dot, Cross };
void addMark(std::vector<LineSegment>& lines, const OverlayContext& context, const Vec3& place, double radius, MarkShape shape,
             const Vec3f& colour);

/// The length in pixels of a world length at a place; the picture's height where the place lies behind the viewing camera.
[[nodiscard]] double pixelsOf(const View& viewing, const Vec3& place, double length);

/// A frustum, with its far plane moved to the scene's end, and a mark at its eye.
[[nodiscard]] std::vector<OverlayLines> frustumOverlay(const OverlayContext& context, const View& culling);

/// A frustum as it is displayed: with the far plane moved to the scene's end.
[[nodiscard]] Frustum shownFrustum(const View& culling, const Scene& scene);

/// The planes of a frustum as outlines within its faces, each in its own colour.
[[nodiscard]] OverlayLines planeOverlay(const OverlayContext& context, const View& culling);

/// The twelve edges of a box.
void addBox(OverlayLines& overlay, const Box3& box, const Vec3f& colour);

/// Whether a group was tested itself: a group inside one that was decided as a whole was not.
[[nodiscard]] bool wasTested(const SnapshotNode& group, const StructureSnapshot& snapshot);

/// The boxes of objects and tested groups: those that a plane rejected in the plane's colour, with a wider line; the others in
/// the verdict's colour.
[[nodiscard]] std::vector<OverlayLines> boxOverlayByPlane(const OverlayContext& context, const StructureSnapshot& snapshot);

/// The boxes of the objects, coloured by verdict.
[[nodiscard]] OverlayLines boxOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

/// The boxes of the groups of objects that were tested, coloured by verdict.
[[nodiscard]] OverlayLines groupOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

/// The tests of strategies with maps of directions, for every object that is not outside the frustum: the bounding sphere as
/// three great circles; where the frustum cuts it, the visible region on the sphere (dashed) with its boxes, and the corner rays
/// from the eye, with a ring where they enter the sphere, to a dot at their hit, or to a cross at the region's corner for a ray
/// that misses (Han & Hong 2008, Figure 3). For `spherical-lossless` the borders of the tested cells on the near side of the
/// sphere, coloured by verdict, if they are some pixels large.
[[nodiscard]] std::vector<OverlayLines> sphereOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

/// The contour bands on the bounding spheres: the circles between them, coloured by the verdict of the sectors of the band
/// beyond; the circle at 90° with a wider line; the axis with its start (ring) and end (dot); and on both sides of the axis each
/// band's S, drawn from the axis outward (Han & Hong 2008, Figures 5 and 6). For `spherical-horizon`, which has slopes, the
/// height of the sight line there. Circles closer than a few pixels are left out.
[[nodiscard]] std::vector<OverlayLines> bandOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

/// Whether the map has a kernel that can be drawn.
[[nodiscard]] inline bool hasKernel(const spherical::MapSnapshot& map) {
    return map.kernel && map.kernel->filled() && map.decision.relation != spherical::SphereRelation::Outside;
}
/// The inner kernels of the objects that are not outside the frustum, without those of a few pixels: the grid of a kernel's map
/// on its surface, on the side that faces the viewing camera and as dense as pixels allow; its outline as seen from the culling
/// camera's eye, where the horizon was used; and the axis from the centre (dot) to that eye.
[[nodiscard]] std::vector<OverlayLines> kernelOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

}  // namespace cullscope
