#pragma once

#include <cstdint>

#include "core/visibility/occlusion/pvs_cells.h"

namespace cullscope::occlusion {

struct PvsOptions {
    CellOptions cells;
    uint64_t rays = 0;  ///< for a cell
    uint64_t seed = 0;
    bool neighbours = false;  ///< a set also has what the cells beside its own see
    bool proven = false;      ///< an object is left out of a set only where it is proven that the cell does not see it
};

/// Sets of a scene, and how they came about.
struct BuiltSets {
    ViewCells cells;
    RegionSets sets;
    uint64_t rays = 0;
    // Pairs of a cell and an object.
    uint64_t seen = 0;      ///< a ray from the cell meets the object, or a surface of it crosses the cell
    uint64_t proven = 0;    ///< it is proven that the object is hidden from the cell
    uint64_t unproven = 0;  ///< neither: with `proven` they are in the set
};

/// Divides a scene into view cells and finds for each the objects that may be seen from it: those that rays meet (guided_rays.h),
/// and with `proven` all of which it is not proven that they are hidden (spatial/hiding_sheets.h). None where there are no cells
/// (viewCells), or above kOptionalAnalysisLimit triangles. The same for the same scene and options, however many threads there
/// are. Throws Error(Interrupted) soon after a stop is requested.
[[nodiscard]] std::optional<BuiltSets> buildSets(const Scene& scene, const PvsOptions& options, const Progress& progress);

}  // namespace cullscope::occlusion
