#pragma once

#include "core/experiments/result_table.h"
#include "core/spatial/spherical_maps.h"
#include "core/visibility/built_strategy.h"

namespace cullscope::han_hong {

/// The columns of what figures show, as a table without rows.
[[nodiscard]] ResultTable figureTable(int number, const BuiltStrategy& strategy);
/// Adds what a frame found: rays with their hits, the region's outline, its boxes, and S of all bands and sectors. `view`: its
/// number in the figure, from 1.
void addFigureRows(ResultTable& table, size_t view, const BuiltStrategy& strategy, const FrameLog& log);

/// Adds the cells of an object's index map in which triangles lie: their angles, number of triangles, nearest and farthest R.
void addCellRows(ResultTable& table, uint32_t instance, const SphericalMaps& maps);
/// The table in sentences for a terminal: of each view and object the case, how many corner rays hit, and the boxes; of bands how
/// many sectors are drawn; of cells how many hold triangles. Of a view with many objects the
/// first few, and how many more there are.
[[nodiscard]] std::vector<std::string> figureSentences(const ResultTable& table);

}  // namespace cullscope::han_hong
