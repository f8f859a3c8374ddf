#pragma once

#include "core/frame/cell_map.h"
#include "core/gpu/renderer.h"
#include "core/image/page_legend.h"

namespace cullscope {

/// Adds a map of directions to a page: what was decided (the case), the map of `width` units with degrees at its ticks and the
/// axes' names, its legend, and the scale or the states of its colours. Returns where it ends, units from the top. `style`: with
/// the page's scale as the unit of lines.
double addCellMap(Page& page, const CellMap& map, std::string_view colouring, const PlotPoint& corner, double width,
                  const DrawStyle& style, const PageLook& look);

/// The sign of something over a map, as cellMapPicture draws it.
[[nodiscard]] PageSign signOf(MapSymbol symbol, const Vec3f& background);

}  // namespace cullscope
