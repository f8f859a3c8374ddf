#pragma once

#include "core/frame/draw_list.h"
#include "core/visibility/spherical/contour_bands.h"
#include "core/visibility/spherical/object_space_view.h"

namespace cullscope::spherical {

/// The data of a mesh's maps that the horizon test needs besides BandCells.
struct HorizonCells {
    /// A cap of directions around a cell's middle.
    struct Cap {
        float cosine = -1.0f, sine = 0.0f;  ///< cosine and sine of its radius; cosine ≤ 0: no cap narrower than a hemisphere
        float angle = 4.0f;                 ///< its radius in radians, rounded up
    };

    HorizonCells(const SphericalMaps& maps, const BandCells& cells);
    [[nodiscard]] uint64_t bytes() const { return caps.size() * sizeof(Cap) + surfaceNearest.size() * sizeof(float); }

    std::vector<Cap> caps;  ///< by BandCells::cells: around all triangles that belong to the cell

    /// A grid over the surface with cells of about 2°, so that the cost of the horizon does not depend on the resolution of the
    /// maps.
    SphericalGrid surface;
    CellDirections surfaceDirections;
    std::vector<Cap> surfaceCaps;       ///< by row of `surface`: around a whole cell
    std::vector<float> surfaceNearest;  ///< by cell of `surface`: lower bound on the surface's distance; 0 where the cell may
                                        ///< have no surface
};

/// The hidden-surface test with the exact slope instead of S (docs/methods/spherical.md). Along a sight line the angle β
/// about the axis is constant and α grows. A point at distance r and angle α has the slope s = r·sin α / (d − r·cos α), with d
/// the distance from the eye to the centre, and all points of a sight line have the same slope. So on a star-shaped surface a
/// point with a lower slope than the surface at a smaller α is hidden. A band's sector gets the lowest slope that its surface can
/// have, by the index map's smallest radii; a cell gets the highest slope of its triangles, over all bands and sectors that they
/// touch. Both are widened for the picture's snapping to 1/256 pixel (1/64 is used). Fills the bands and returns the drawn cells.
/// Conservative where the surface is star-shaped around the centre and completely beyond the near plane. `record`, if it is not
/// null, is told of the bands' slopes and of each cell's test where they fall; the cells are then tested one after the other.
[[nodiscard]] std::vector<CellRun> drawnBySlope(const SphericalMaps& maps, const BandCells& cells,
                                                const HorizonCells& horizonCells, const ObjectSpaceView& view,
                                                ContourBands& bands, ObjectRecord* record = nullptr);

/// Sets for each sector of a band whether a cell that was decided to be drawn intersects it; for display only.
void markDrawnSectors(const SphericalMaps& maps, const BandCells& cells, std::span<const CellRun> drawn, ContourBands& bands);

/// Whether every ray from the centre of the mesh's bounding sphere intersects its surface exactly once: closed, consistently
/// oriented, all triangles with the same side towards the centre, and all solid angles together one sphere. Where only front
/// faces are drawn, they must be the outer ones.
[[nodiscard]] bool isStarShaped(const SphericalMaps& maps, Facing facing);

}  // namespace cullscope::spherical
