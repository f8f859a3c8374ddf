#pragma once

#include <QString>
#include <memory>
#include <optional>

#include "core/visibility/spherical/map_details.h"
#include "ui/session/shown_reading.h"

namespace cullscope::ui {

/// The triangle index map of one object, with the decision on it.
struct ShownMap {
    ScenePointer scene;                                 ///< the instances are numbered as in this scene
    std::shared_ptr<const StructureSnapshot> snapshot;  ///< null: there is no map
    size_t place = 0;                                   ///< index into spherical::mapsOf(*snapshot)

    [[nodiscard]] bool empty() const { return !snapshot; }
    [[nodiscard]] const spherical::MapSnapshot& map() const { return spherical::mapsOf(*snapshot)[place]; }
    [[nodiscard]] const spherical::SphericalDecision& decision() const { return map().decision; }
    [[nodiscard]] const SphericalMaps& maps() const { return *map().maps; }
    [[nodiscard]] const SphericalGrid& grid() const { return map().maps->grid(); }
    /// The name of the object.
    [[nodiscard]] QString name() const;

    bool operator==(const ShownMap&) const = default;
};

/// The map that the panels show: that of the picked object, else that of the first object that is not outside the frustum, else
/// the first one. Empty: the strategy has no maps, or was not read yet.
[[nodiscard]] ShownMap shownMap(const Session& session, const SnapshotReader& reader);

}  // namespace cullscope::ui
