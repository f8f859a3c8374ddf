#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QTextBrowser>
#include <QToolButton>
#include <QTreeWidget>

#include "ui/dialogs/help_contents.h"
#include "ui/text/language.h"

namespace cullscope::ui {

/// Shows the help page in the program's language, beside it the contents of all pages and a search in them. Not modal: the user
/// can try what the page describes. Its links lead to the pages of docs/, which are in English.
class HelpWindow : public QDialog {
    Q_OBJECT

public:
    HelpWindow(const Language& language, QWidget* parent = nullptr);

    [[nodiscard]] QTextBrowser& page() { return *m_page; }
    /// Pages, and below them their sections.
    [[nodiscard]] QTreeWidget& contents() { return *m_contents; }
    [[nodiscard]] QLineEdit& search() { return *m_search; }

private:
    void load();
    void fillContents();
    /// Leaves the sections that have all words of the search, and marks the words in the shown page.
    void showFound();
    void goTo(const QTreeWidgetItem& item);
    void markWords();

    const Language& m_language;
    QTextBrowser* m_page;
    QToolButton* m_back;
    QToolButton* m_first;
    QLineEdit* m_search;
    QTreeWidget* m_contents;
    QLabel* m_nothing;  ///< says that no section has the words
    std::vector<HelpSection> m_sections;
};

}  // namespace cullscope::ui
