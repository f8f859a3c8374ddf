#include "ui/startup/application.h"

#include <QEvent>
#include <QLabel>

#include "core/base/error.h"

namespace cullscope::ui {

bool Application::notify(QObject* receiver, QEvent* event) {
    // Each widget is polished once, before it is shown first and before it computes its size. A tool tip is a label too.
    if (event->type() == QEvent::Polish)
        if (auto* label = qobject_cast<QLabel*>(receiver); label && label->textFormat() == Qt::AutoText)
            label->setTextFormat(Qt::PlainText);
    // Qt calls this function for every event, those that other events send included, so that an exception passes the least of
    // Qt's own code before it is caught.
    try {
        return QApplication::notify(receiver, event);
    } catch (const std::exception& failure) {
        tell(sentenceOf(failure, "%1", QT_TRANSLATE_NOOP("core", "There is not enough memory.")));
    } catch (...) {
        tell({QT_TRANSLATE_NOOP("core", "The reason is not known."), {}});
    }
    return true;
}

void Application::tell(const Message& why) {
    if (m_telling.exchange(true)) return;
    QMetaObject::invokeMethod(
        this,
        [this, why] {
            m_telling = false;
            emit eventFailed(why);
        },
        Qt::QueuedConnection);
}

}  // namespace cullscope::ui
