#pragma once

#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// One object's map of directions, and what was decided on it.
struct ShownMap {
    ScenePointer scene;                                 ///< numbers the instances
    std::shared_ptr<const StructureSnapshot> snapshot;  ///< null: there is no map
    size_t place = 0;                                   ///< in StructureSnapshot::maps

    [[nodiscard]] bool empty() const { return !snapshot; }
    [[nodiscard]] const spherical::MapSnapshot& map() const { return snapshot->maps[place]; }
    [[nodiscard]] const spherical::SphericalDecision& decision() const { return map().decision; }
    [[nodiscard]] const SphericalMaps& maps() const { return *map().maps; }
    [[nodiscard]] const SphericalGrid& grid() const { return map().maps->grid(); }
    /// Of the object.
    [[nodiscard]] QString name() const;

    bool operator==(const ShownMap&) const = default;
};

/// The map that the panels show: the picked object's, else that of the first object that is not outside the frustum, else the
/// first one; empty: the strategy has none, or nothing is read yet.
[[nodiscard]] ShownMap shownMap(const Session& session, const SnapshotReader& reader);

/// Why there is no map to show.
enum class MapAbsence {
    NoScene,
    Preparing,  ///< the scene is being opened, the strategy built, or its maps read
    NotBuilt,   ///< the strategy could not be built
    NoMaps      ///< it is read, and has none
};
[[nodiscard]] MapAbsence mapAbsence(Session& session, const SnapshotReader& reader);

/// Calls `then` whenever the map that is shown may be another one, as long as `context` lives.
void followShownMap(Session& session, SnapshotReader& reader, QObject* context, const std::function<void()>& then);
/// The same of why there is none, where the map itself stays as it is.
void followMapAbsence(Session& session, QObject* context, const std::function<void()>& then);

}  // namespace cullscope::ui
