#pragma once

#include <QObject>
#include <QString>

namespace cullscope::ui {

/// A tool tip's paragraphs in lines of a readable width. Qt breaks the lines of plain text only where they are wider than the
/// screen.
[[nodiscard]] QString wrappedTip(const QString& text);

/// Shows the tool tips of all widgets, menus, lists and headers in such lines. Installed as a filter of the application's events.
class WrappedTips : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace cullscope::ui
