#pragma once

#include <algorithm>

#include "ui/session/snapshot_reader.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {

/// Whether all panels of a window, also those of a lecture and below views, show what the present frames decided.
inline bool panelsAreRead(const MainWindow& window) {
    return std::ranges::all_of(window.findChildren<SnapshotReader*>(),
                               [](const SnapshotReader* reader) { return reader->fresh() || !reader->wanted(); });
}

/// Whether the step in hand of a window's lesson is on screen: its scene, each view's picture, its place in the log, the panels.
inline bool lessonStepIsOnScreen(MainWindow& window, Session& session) {
    const LessonPlayer& player = window.lessons().player();
    if (player.opening() || session.loader().loading() || !session.buffers()) return false;
    for (const int view : session.shownViews())
        if (session.slot(session.culledBy(view)).building() || !session.viewRequest(view) || !session.pictures()->isCurrent(view))
            return false;
    return (!player.current().state.place || session.step()) && panelsAreRead(window);
}

}  // namespace cullscope::ui
