#include "ui/startup/application.h"

#include <QEvent>
#include <QLabel>

namespace cullscope::ui {

bool Application::notify(QObject* receiver, QEvent* event) {
    // Each widget is polished once, before it is shown first and before it computes its size. A tool tip is a label too.
    if (event->type() == QEvent::Polish)
        if (auto* label = qobject_cast<QLabel*>(receiver); label && label->textFormat() == Qt::AutoText)
            label->setTextFormat(Qt::PlainText);
    return QApplication::notify(receiver, event);
}

}  // namespace cullscope::ui
