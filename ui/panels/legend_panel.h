#pragma once

#include <QLabel>
#include <QWidget>

#include "ui/session/session.h"

namespace cullscope::ui {

/// What the marks over a view mean, and one thing to do next.
class LegendPanel : public QWidget {
    Q_OBJECT

public:
    explicit LegendPanel(Session& session, QWidget* parent = nullptr);

    /// The next thing to do; changes as the user gets on.
    [[nodiscard]] QString nextAction() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    enum class Progress { Turn, Look, Choose, Done };

    void refresh();
    void advance(Progress to);

    Session& m_session;
    Progress m_progress = Progress::Turn;
    int m_cameraMoves = 0;
    QLabel* m_figures;
    QList<QLabel*> m_promises;
    QLabel* m_next;
};

}  // namespace cullscope::ui
