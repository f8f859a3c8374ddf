#pragma once

#include <QCoreApplication>
#include <QUndoCommand>
#include <functional>

#include "ui/session/session_state.h"

namespace cullscope::ui {

/// One change of what the session shows: what it was and what it became.
class UndoStep : public QUndoCommand {
    Q_DECLARE_TR_FUNCTIONS(cullscope::ui::UndoStep)

public:
    using Apply = std::function<void(const SessionState&)>;

    /// `current` says what there is when the step is undone or redone, `apply` shows a state.
    UndoStep(SessionState before, SessionState after, std::function<SessionState()> current, Apply apply);

    void undo() override { go(m_after, m_before); }
    void redo() override;

    /// "camera", "parameters of view B": in the present language.
    [[nodiscard]] QString name() const;

private:
    void go(const SessionState& from, const SessionState& to) const;

    SessionState m_before, m_after;
    std::function<SessionState()> m_current;
    Apply m_apply;
    bool m_done = true;  ///< a new step has happened already
};

/// Whether the two differ in something that undo goes back over. View count, active view, arrangement and bookmarks are not.
[[nodiscard]] bool differInUndoable(const SessionState& a, const SessionState& b);

/// `base` with what differs between `from` and `to` as it is in `to`.
[[nodiscard]] SessionState withDifference(const SessionState& base, const SessionState& from, const SessionState& to);

}  // namespace cullscope::ui
