#pragma once

#include <QObject>
#include <QTimer>
#include <QUndoStack>

#include "ui/session/session_state.h"

namespace cullscope::ui {

/// Undo of cameras, strategies, parameters, views' setups and hidden objects. A step collects all changes until none occurred for
/// 400 ms, or until the mouse button is released: a whole drag is one step. Undoing a step restores only the values that it
/// changed. Opening a scene clears the history.
class UndoRecorder : public QObject {
    Q_OBJECT

public:
    explicit UndoRecorder(Session& session, QObject* parent = nullptr);

    void undo();
    void redo();
    [[nodiscard]] bool canUndo() const { return m_stack.canUndo() || m_changing; }
    [[nodiscard]] bool canRedo() const { return m_stack.canRedo() && !m_changing; }
    /// The text for the menu in the present language: "Undo: parameters of view B"; "Undo" if there is no step.
    [[nodiscard]] QString undoText() const;
    [[nodiscard]] QString redoText() const;

    /// Clears the history, as after the opening of a session.
    void startAnew();
    /// Makes a step of the changes so far.
    void settle();

signals:
    /// The texts or the state of the menu's actions changed.
    void changed();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void noteChange();
    void takeCameras();
    void apply(const SessionState& state);
    void walk(void (QUndoStack::*way)());

    Session& m_session;
    QUndoStack m_stack;
    QTimer m_rest;
    SessionState m_before;    ///< state after the newest step
    bool m_changing = false;  ///< the session may have changed since m_before
    bool m_applying = false;
    bool m_buttonDown = false;
};

}  // namespace cullscope::ui
