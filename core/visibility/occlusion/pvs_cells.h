#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/region_sets.h"
#include "core/scene/scene.h"

namespace cullscope::occlusion {

/// How space is divided into view cells.
struct CellOptions {
    int along = 8;     ///< cells along the longest side of the scene's box
    int halvings = 3;  ///< how many more times a cell is halved that a surface crosses
};

/// Boxes that fill the scene's box, and the tree in which a place is looked up.
struct ViewCells {
    Box3 within;  ///< the scene's box, a little larger
    std::vector<RegionSets::Node> nodes;
    std::vector<Box3> boxes;                      ///< by region
    std::vector<std::vector<uint32_t>> crossing;  ///< by region: the objects of which a triangle may cross it, ascending
};

/// None where a scene has less than two objects: then no set tells anything. Throws Error(Interrupted) soon after a stop is
/// requested.
[[nodiscard]] std::optional<ViewCells> viewCells(const Scene& scene, const CellOptions& options, const Progress& progress);

/// By region, the regions that touch it, itself left out.
[[nodiscard]] std::vector<std::vector<uint32_t>> neighbours(const ViewCells& cells);

}  // namespace cullscope::occlusion
