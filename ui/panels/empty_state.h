#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "ui/session/session.h"

class QMenu;

namespace cullscope::ui {

/// Fills the middle of the window while no scene is open: invites the user to open or to generate one.
class EmptyState : public QWidget {
    Q_OBJECT

public:
    EmptyState(Session& session, QMenu* generate, QWidget* parent = nullptr);

signals:
    void openRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    Session& m_session;
    QLabel* m_title;
    QLabel* m_text;
    QPushButton* m_open;
    QPushButton* m_generate;
};

}  // namespace cullscope::ui
