#pragma once

#include <QString>
#include <QUrl>
#include <vector>

namespace cullscope::ui {

/// A heading of the help with the text below it, up to the next heading.
struct HelpSection {
    QUrl page;
    QString title;
    int level = 1;  ///< 1: the page's own title
    QString text;   ///< with the title, as plain text
};

/// The sections of a page in Markdown, in their order. A heading within a block of code is none.
[[nodiscard]] std::vector<HelpSection> sectionsOf(const QUrl& page, const QString& markdown);

/// The sections of all pages of the help: the first page in a language, then the pages of docs/ in the order in which the first
/// page links to them, then those that it does not link to.
[[nodiscard]] std::vector<HelpSection> helpSections(const QString& language);

/// Whether a section has all words of a search, whatever their case; true where there is nothing to search.
[[nodiscard]] bool hasAllWords(const HelpSection& section, const QString& search);

}  // namespace cullscope::ui
