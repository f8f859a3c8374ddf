#pragma once

#include <QApplication>

namespace cullscope::ui {

/// The desktop's application. It holds what is true of every widget, those of Qt's own dialogs included.
///
/// Labels and tool tips show plain text: names from files may contain markup, and Qt renders what looks like HTML, with the
/// pictures that it names. A label whose text is composed as HTML says so itself by setTextFormat(Qt::RichText).
class Application : public QApplication {
    Q_OBJECT

public:
    using QApplication::QApplication;

    bool notify(QObject* receiver, QEvent* event) override;
};

}  // namespace cullscope::ui
