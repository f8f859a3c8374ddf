#pragma once

#include <QFrame>
#include <QLabel>
#include <QToolButton>

#include "core/base/message.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// One sentence over the views that stays until it is closed or another takes its place; stops nobody.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent = nullptr);

    void show(Severity severity, const Message& message);
    [[nodiscard]] QString text() const { return m_text->text(); }

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    QLabel* m_icon;
    QLabel* m_text;
    QToolButton* m_close;
    Severity m_severity = Severity::Information;
    Message m_message;
};

}  // namespace cullscope::ui
