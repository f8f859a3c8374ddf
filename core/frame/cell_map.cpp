#include "core/frame/cell_map.h"

#include <algorithm>

namespace cullscope {

const MapColouring* CellMap::colouring(std::string_view id) const {
    const auto found = std::ranges::find(colourings, id, &MapColouring::id);
    return found == colourings.end() ? nullptr : &*found;
}

}  // namespace cullscope
