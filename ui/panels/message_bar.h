#pragma once

#include <QFrame>
#include <QLabel>
#include <QToolButton>

#include "core/base/message.h"
#include "ui/session/session.h"

namespace cullscope::ui {

/// One sentence that lies over the lower edge of its parent until it is closed or another takes its place; stops nobody and
/// moves nothing: what it lies over keeps its size.
class MessageBar : public QFrame {
    Q_OBJECT

public:
    explicit MessageBar(QWidget* parent);

    void show(Severity severity, const Message& message);
    [[nodiscard]] QString text() const { return m_text->text(); }

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void place();

    QLabel* m_icon;
    QLabel* m_text;
    QToolButton* m_close;
    Severity m_severity = Severity::Information;
    Message m_message;
};

}  // namespace cullscope::ui
