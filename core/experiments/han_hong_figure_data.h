#pragma once

#include "core/experiments/result_table.h"
#include "core/visibility/built_strategy.h"

namespace cullscope::han_hong {

/// The columns of what figures show, as a table without rows.
[[nodiscard]] ResultTable figureTable(int number, const BuiltStrategy& strategy);
/// Adds what a frame found: rays with their hits, the region's outline, its boxes, and S of all bands and sectors. `view`: its
/// number in the figure, from 1.
void addFigureRows(ResultTable& table, size_t view, const BuiltStrategy& strategy, const FrameLog& log);

}  // namespace cullscope::han_hong
