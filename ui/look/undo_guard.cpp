#include "ui/look/undo_guard.h"

#include <QKeyEvent>

namespace cullscope::ui {

namespace {

class UndoGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() != QEvent::ShortcutOverride) return QObject::eventFilter(watched, event);
        const auto* key = static_cast<QKeyEvent*>(event);
        if (!key->matches(QKeySequence::Undo) && !key->matches(QKeySequence::Redo)) return false;
        // A field that accepted this event would get the key as text to be edited.
        event->ignore();
        return true;
    }
};

}  // namespace

void leaveUndoToTheWindow(QWidget& field) {
    auto* guard = new UndoGuard(&field);
    field.installEventFilter(guard);
    for (QWidget* part : field.findChildren<QWidget*>()) part->installEventFilter(guard);
}

}  // namespace cullscope::ui
