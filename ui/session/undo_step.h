#pragma once

#include <QCoreApplication>
#include <QUndoCommand>
#include <functional>

#include "ui/session/session_state.h"

namespace cullscope::ui {

/// One change of the session's state, with the states before and after.
class UndoStep : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(cullscope::ui::UndoStep)

public:
    using Apply = std::function<void(const SessionState&)>;

    /// `current` returns the state at the time of undo or redo, `apply` shows a state.
    UndoStep(SessionState before, SessionState after, std::function<SessionState()> current, Apply apply);

    void undo() override { go(m_after, m_before); }
    void redo() override;

    /// The changed part in the present language: "camera", "parameters of view B".
    [[nodiscard]] QString name() const;

private:
    void go(const SessionState& from, const SessionState& to) const;

    SessionState m_before, m_after;
    std::function<SessionState()> m_current;
    Apply m_apply;
    bool m_done = true;  ///< QUndoStack::push calls redo() once for a change that is already made
};

/// Whether two states differ in a part that undo restores. View count, active view, arrangement and bookmarks are not restored.
[[nodiscard]] bool differInUndoable(const SessionState& a, const SessionState& b);

/// `base`, with the values that differ between `from` and `to` taken from `to`.
[[nodiscard]] SessionState withDifference(const SessionState& base, const SessionState& from, const SessionState& to);

}  // namespace cullscope::ui
