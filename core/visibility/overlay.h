#pragma once

#include <array>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/visibility/structure_snapshot.h"
#include "core/visibility/triangle_states.h"

namespace cullscope {

inline constexpr float kBoxLineWidth = 1.0f;  ///< units; narrower lines show gaps

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

/// The twelve edges of a box, level or turned: `corner(c)` is its corner on the high side of the axes x, y and z whose bit 1, 2
/// and 4 of c is set.
template <typename Corner>
void addBoxEdges(OverlayLines& overlay, const Corner& corner, const Vec3f& colour) {
    for (int from = 0; from < 8; ++from)
        for (const int axis : {1, 2, 4})
            if ((from & axis) == 0) overlay.lines.push_back({corner(from), corner(from | axis), colour});
}
/// The twelve edges of a box.
void addBox(OverlayLines& overlay, const Box3& box, const Vec3f& colour);

/// What became of a node's objects, as far as one word tells.
[[nodiscard]] TriangleState stateOfNode(const SnapshotNode& node);
/// Adds a box in the colour of its verdict.
void addByVerdict(OverlayLines& overlay, const OverlayContext& context, const SnapshotNode& node);

/// The boxes of the groups of objects that were tested, coloured by verdict.
[[nodiscard]] OverlayLines groupOverlay(const OverlayContext& context, const StructureSnapshot& snapshot);

}  // namespace cullscope
