#pragma once

#include "core/frame/cell_map.h"
#include "core/scene/scene.h"
#include "core/visibility/triangle_states.h"

namespace cullscope::ui {

/// The map of directions of one object.
struct ShownMap {
    ScenePointer scene;  ///< the instances are numbered as in this scene
    CellMapPointer map;  ///< null: there is no map

    [[nodiscard]] bool empty() const { return !map; }
    [[nodiscard]] const SphericalGrid& grid() const { return map->grid; }
    [[nodiscard]] const CellMapSource& source() const { return *map->source; }

    bool operator==(const ShownMap&) const = default;
};

}  // namespace cullscope::ui
