#pragma once

#include "core/frame/draw_list.h"
#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/object_space_view.h"

namespace cullscope::spherical {

/// What the horizon test needs of a mesh's maps besides BandCells.
struct HorizonCells {
    /// A cap of directions around a cell's middle.
    struct Cap {
        float cosine = -1.0f, sine = 0.0f;  ///< of its radius; cosine ≤ 0: nothing narrower than a hemisphere
        float angle = 4.0f;                 ///< its radius, radians, rounded up
    };

    HorizonCells(const SphericalMaps& maps, const BandCells& cells);
    [[nodiscard]] uint64_t bytes() const { return caps.size() * sizeof(Cap) + surfaceNearest.size() * sizeof(float); }

    std::vector<Cap> caps;  ///< by BandCells::cells: around all triangles that the cell owns

    /// The surface in cells of about 2°, so that the horizon costs the same whatever the maps' resolution.
    SphericalGrid surface;
    CellDirections surfaceDirections;
    std::vector<Cap> surfaceCaps;       ///< by row of it: around the whole cell
    std::vector<float> surfaceNearest;  ///< by its cells: the surface is nowhere nearer; 0 where there may be none
};

/// The exact slope in place of S (methods.md, `spherical-horizon`). Along a sight line the angle β about the axis stays and α
/// grows; a point of distance r at α has the slope s = r·sin α / (d − r·cos α), d from the eye to the centre, and what lies on
/// the same sight line has the same slope. So on a star-shaped surface what has a lower slope than the surface at some smaller α
/// is hidden. A band's sector has the least slope that its surface can have, by the index map's nearest radii; a cell the largest
/// that the triangles it owns can have, over all bands and sectors that they reach into. Both are widened by the picture's
/// snapping to 1/256 pixel (1/64 is taken). Gives the cells that are drawn; fills the bands. Conservative where the surface is
/// star-shaped around the centre and wholly behind the near plane.
[[nodiscard]] std::vector<CellRun> drawnBySlope(const SphericalMaps& maps, const BandCells& cells,
                                                const HorizonCells& horizonCells, const ObjectSpaceView& view,
                                                ContourBands& bands);

/// Says of each band's sector whether a cell that reaches into it is drawn: for those who look inside.
void markDrawnSectors(const SphericalMaps& maps, const BandCells& cells, std::span<const CellRun> drawn, ContourBands& bands);

/// Whether every direction from the centre of the mesh's bounding sphere meets its surface exactly once: closed, consistently
/// oriented, every triangle on the same side of the centre, all solid angles together one sphere. Where only front sides are
/// drawn they must be the outer ones.
[[nodiscard]] bool isStarShaped(const SphericalMaps& maps, Facing facing);

}  // namespace cullscope::spherical
