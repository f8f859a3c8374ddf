#pragma once

#include <QWidget>

namespace cullscope::ui {

/// Leaves the keys of undo and redo to the window: a field whose every change is a step of the window's own history must not take
/// back letters in its place.
void leaveUndoToTheWindow(QWidget& field);

}  // namespace cullscope::ui
