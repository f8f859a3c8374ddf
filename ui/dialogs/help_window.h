#pragma once

#include <QDialog>
#include <QTextBrowser>

#include "ui/text/language.h"

namespace cullscope::ui {

/// The help page in the program's language, beside the window: it stays open while one tries what it says.
class HelpWindow : public QDialog {
    Q_OBJECT

public:
    HelpWindow(const Language& language, QWidget* parent = nullptr);

    [[nodiscard]] const QTextBrowser& page() const { return *m_page; }

private:
    void load();

    const Language& m_language;
    QTextBrowser* m_page;
};

}  // namespace cullscope::ui
