#pragma once

#include "core/frame/cell_map.h"
#include "core/scene/scene.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// The triangle index map of an object as a kind of plain data, with the decision about it: the visible region with its boxes and
/// corner rays; or the contour bands, whose sectors are the parts; or the quadtree cells at which the walk ended, and the
/// kernel's horizon. Makes the map's maps where they are not made yet (LazyMaps). `objects`: the number of objects in the scene.
[[nodiscard]] CellMapPointer indexMap(MapSnapshot map, const std::string& object, size_t objects);

}  // namespace cullscope::spherical
