#pragma once

#include <QApplication>
#include <atomic>

#include "core/base/message.h"

namespace cullscope::ui {

/// The desktop's application. It holds what is true of every widget, those of Qt's own dialogs included.
///
/// Labels and tool tips show plain text: names from files may contain markup, and Qt renders what looks like HTML, with the
/// pictures that it names. A label whose text is composed as HTML says so itself by setTextFormat(Qt::RichText).
///
/// An exception that leaves the handler of an event ends there, on whichever thread: the program goes on and says it.
class Application : public QApplication {
    Q_OBJECT

public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;

signals:
    /// An exception left the handler of an event; `why` is its sentence. Emitted on this object's thread, once that event is
    /// over. Failures that come before it is emitted are not told one by one.
    void eventFailed(const cullscope::Message& why);

private:
    void tell(const Message& why);

    std::atomic<bool> m_telling{false};
};

}  // namespace cullscope::ui
