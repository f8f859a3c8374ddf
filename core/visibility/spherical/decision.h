#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/frame/frame_log.h"
#include "core/frame/map_circles.h"
#include "core/spatial/cell_tree.h"
#include "core/spatial/inner_kernel.h"
#include "core/spatial/spherical_search.h"
#include "core/visibility/part_walk.h"
#include "core/visibility/spherical/lazy_maps.h"

namespace cullscope::spherical {

/// The relation of an object's bounding sphere to the frustum: the branches of Han & Hong 2008, Appendix 1.
enum class SphereRelation {
    Outside,   ///< nothing is drawn
    Cut,       ///< at least one plane cuts it: corner rays, visible region, cases
    Within,    ///< inside all six planes: contour bands and the S test
    AroundEye  ///< the eye is inside the sphere, or the object is flat: everything is drawn
};
/// English, marked for translation.
[[nodiscard]] const char* relationName(SphereRelation relation);
/// Straddles with Cut and AroundEye.
[[nodiscard]] Containment containmentOf(SphereRelation relation);

/// One of the view's four corner rays. Points and directions in the mesh's coordinates, relative to the centre of its map.
struct CornerRay {
    bool followed = false;  ///< false: the object was not decided by rays, or this one was not said yet
    Ray ray;
    std::optional<Span> span;        ///< through the bounding sphere or box; none: the ray misses it
    std::optional<TriangleHit> hit;  ///< confirmed by intersection; none: `point` is the point of the sphere (or box: RayStart)
                                     ///< nearest to the ray
    Vec3 point{0.0};                 ///< the region's corner
    std::vector<WalkedCell> walkedCells;  ///< only in a recorded frame
};

using CellBox = SphericalGrid::Box;

/// The cells with numbers [first, last).
struct CellRun {
    uint32_t first = 0, last = 0;

    bool operator==(const CellRun&) const = default;
};

/// The visible region on the map, in radians. Its corners are connected in the order bottom-left, bottom-right, top-right,
/// top-left.
struct VisibleRegion {
    int caseNumber = 0;  ///< 1: a pole is in view, 2: one clump, 3: split by the seam
    /// The region's outline as (θ, φ), with φ continued over the seam (below 0 or beyond 2π where it crosses); closed, except
    /// where it winds around a pole and ends a whole turn from its start.
    std::vector<Vec2> outline;
    bool winds = false;
    std::vector<CellBox> boxes;  ///< one; case 3: two
};

/// A sector of a contour band: all directions between two angles α from the axis and two angles β about it.
struct BandSector {
    static constexpr uint32_t kUncut = ~0u;

    double size = 0.0;     ///< S of `spherical`: the largest R · sin α of its cells, mesh units (contour_bands.h); of
                           ///< `spherical-horizon`: the least slope of the surface
    double horizon = 0.0;  ///< the largest size at smaller α in this sector
    bool drawn = true;
    bool within = false;      ///< of `spherical`, where it is not drawn: it has cells within 90° of the axis, which are drawn
    uint32_t cutBy = kUncut;  ///< of `spherical`: the nearer band of the sector that was hidden and ended it; kUncut: none
};

/// The contour bands on the bounding sphere, between circles about the axis from its centre to its point nearest to the eye.
struct ContourBands : MapCircles {
    uint32_t sectors = 0;
    std::vector<BandSector> table;  ///< by band, then sector
    bool slopes = false;            ///< whether sizes are slopes

    [[nodiscard]] const BandSector& at(uint32_t band, uint32_t sector) const { return table[size_t(band) * sectors + sector]; }
    /// α in [0, π] and β in [0, 2π) of a direction of any length but 0.
    [[nodiscard]] Vec2 anglesOf(const Vec3& direction) const;
    [[nodiscard]] uint32_t bandOf(double alpha) const { return std::min(uint32_t(std::max(alpha, 0.0) / width), bands - 1); }
    [[nodiscard]] uint32_t sectorOf(double beta) const;
};

using cullscope::PlaceRun;

/// A node of a CellTree at which a walk ended.
using JudgedCell = cullscope::JudgedNode;

/// The result of `spherical-lossless` for one object's cells: what hides them is the kernel's horizon.
struct CellWalk : PartWalk {
    std::vector<Vec3> outline{};  ///< only in a recorded frame, where the horizon is tested: the kernel's outline as seen from
                                  ///< the eye
};

/// The test of one cell by its slope (slope_horizon.h), with the numbers that decided.
struct SlopeTest {
    enum class Result : uint8_t {
        Untested,  ///< drawn: it has no bounds narrower than a hemisphere, or lies too near to the centre or the axis
        Visible,
        Hidden
    };
    Result result = Result::Untested;
    double slope = 0.0;    ///< largest slope of its triangles
    double horizon = 0.0;  ///< with Hidden the least one before them, else one that is not higher
};

/// The decision of a spherical strategy about one object, and its reasons.
struct SphericalDecision {
    uint32_t instance = 0;
    SphereRelation relation = SphereRelation::Outside;
    Vec3 eye{0.0};                        ///< in the mesh's coordinates relative to the map's centre
    std::array<CornerRay, 4> rays;        ///< with Cut, of `spherical`
    std::optional<VisibleRegion> region;  ///< with Cut, of `spherical`
    std::optional<ContourBands> bands;    ///< where cells were tested by bands
    std::vector<CellRun> drawn;           ///< ascending, disjoint: cells whose triangles are submitted
    std::optional<CellWalk> walk;         ///< of `spherical-lossless`, where the object is not outside: in place of `drawn`
    uint64_t drawnTriangles = 0;
    uint64_t leftOutAlone = 0;  ///< triangles of drawn cells, left out one by one
};

/// The last plane that a recorded frame names as having rejected an instance or its group, by instance.
[[nodiscard]] std::vector<std::optional<FrustumPlane>> rejectingPlanes(const FrameLog& log, size_t instances);

/// The decision about one object together with the maps that it was based on.
struct MapSnapshot {
    LazyMaps maps;
    SphericalDecision decision;
    CellTreePointer tree{};            ///< of `spherical-lossless`, which decides by this tree; the maps only display the result
    InnerKernelPointer kernel{};       ///< of `spherical-lossless`
    std::vector<CellRun> undecided{};  ///< ascending: cells of which a part of a frame does not say yet what becomes of them
};

/// The result for a cell of the centroid map. For `spherical-lossless`, which has other cells: the last state of this list that
/// any of the cell's triangles has.
enum class CellState : uint8_t { Empty, OutsideFrustum, BackFacing, Hidden, Undecided, Drawn };
/// The states by cell number.
[[nodiscard]] std::vector<CellState> cellStates(const MapSnapshot& map);

}  // namespace cullscope::spherical
