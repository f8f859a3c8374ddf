#pragma once

#include <QObject>
#include <QTimer>
#include <QUndoStack>

#include "ui/session/session_state.h"

namespace cullscope::ui {

/// Undo of cameras, strategies, parameters, views' setups and hidden objects. A step is what changed until nothing changed for
/// 400 ms, or until the mouse button went up: a whole drag is one step. Undoing a step sets back what it changed and nothing
/// else. There is no way back over the opening of a scene.
class UndoRecorder : public QObject {
    Q_OBJECT

public:
    explicit UndoRecorder(Session& session, QObject* parent = nullptr);

    void undo();
    void redo();
    [[nodiscard]] bool canUndo() const { return m_stack.canUndo() || m_changing; }
    [[nodiscard]] bool canRedo() const { return m_stack.canRedo() && !m_changing; }
    /// For the menu, in the present language: "Undo: parameters of view B"; "Undo" where there is nothing.
    [[nodiscard]] QString undoText() const;
    [[nodiscard]] QString redoText() const;

    /// What is there now is where undo ends: a session was just opened.
    void startAnew();
    /// Makes a step of what changed so far.
    void settle();

signals:
    /// What the menu shows of it.
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
    SessionState m_before;    ///< as the newest step left it
    bool m_changing = false;  ///< something may have changed since
    bool m_applying = false;
    bool m_buttonDown = false;
};

}  // namespace cullscope::ui
