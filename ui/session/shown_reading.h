#pragma once

#include <QString>
#include <functional>

#include "ui/session/snapshot_reader.h"

namespace cullscope::ui {

/// What panels show of the active view's strategy: the newest reading of the present scene, of an older camera or strategy until
/// the next one is there, which avoids flicker. Null: there is none.
[[nodiscard]] SnapshotReadingPointer shownReading(const Session& session, const SnapshotReader& reader);
/// The object in hand where the active view is stepped, else the picked one, numbered as in the shown scene; none: there is
/// none, or it is hidden.
[[nodiscard]] std::optional<uint32_t> pickedInstance(const Session& session);

/// Why panels have nothing to show.
enum class Absence {
    NoScene,
    Preparing,  ///< the scene is being opened, the strategy is being built, or its decisions are being read
    NotBuilt,   ///< the strategy could not be built
    Nothing     ///< the strategy was read and has nothing
};
[[nodiscard]] Absence absence(Session& session, const SnapshotReader& reader);
/// The sentence in place of what would be shown; empty for Absence::Nothing.
[[nodiscard]] QString absenceWords(Absence absence);

/// Calls `then` whenever the shown reading or the pick may have changed, while `context` exists.
void followReading(Session& session, SnapshotReader& reader, QObject* context, const std::function<void()>& then);
/// Calls `then` whenever the absence may have changed, while `context` exists.
void followAbsence(Session& session, QObject* context, const std::function<void()>& then);

}  // namespace cullscope::ui
