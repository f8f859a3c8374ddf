#pragma once

#include <QDialog>
#include <QTextBrowser>
#include <QToolButton>

#include "ui/text/language.h"

namespace cullscope::ui {

/// Shows the help page in the program's language. Not modal: the user can try what the page describes. Its links lead to the
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
