#pragma once

#include <QDialog>
#include <QTextBrowser>
#include <QToolButton>

#include "ui/text/language.h"

namespace cullscope::ui {

/// The help page in the program's language, beside the window: it stays open while one tries what it says. Its links lead to the
/// pages of docs/, which are in English.
class HelpWindow : public QDialog {
    Q_OBJECT

public:
    HelpWindow(const Language& language, QWidget* parent = nullptr);

    [[nodiscard]] QTextBrowser& page() { return *m_page; }

private:
    void load();

    const Language& m_language;
    QTextBrowser* m_page;
    QToolButton* m_back;
    QToolButton* m_first;
};

}  // namespace cullscope::ui
