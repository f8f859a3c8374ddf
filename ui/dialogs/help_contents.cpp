#include "ui/dialogs/help_contents.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <algorithm>

namespace cullscope::ui {

namespace {

constexpr const char* kFolder = ":/docs";

/// Text without the marks of Markdown: `code`, **strong**, *emphasis*, and links as their words.
QString plain(QString line) {
    static const QRegularExpression link(QStringLiteral("!?\\[([^\\]]*)\\]\\([^)]*\\)"));
    static const QRegularExpression marks(QStringLiteral("\\*\\*|`|(?<!\\w)\\*(?=\\S)|(?<=\\S)\\*(?!\\w)"));
    return line.replace(link, QStringLiteral("\\1")).remove(marks).trimmed();
}

QString contentsOf(const QString& file) {
    QFile page(file);
    return page.open(QIODevice::ReadOnly) ? QString::fromUtf8(page.readAll()) : QString();
}

/// The pages of docs/, those that `first` links to before the others.
QStringList manualPages(const QString& first) {
    QStringList pages;
    QDirIterator all(QLatin1String(kFolder), {QStringLiteral("*.md")}, QDir::Files, QDirIterator::Subdirectories);
    while (all.hasNext()) pages << all.next();
    const auto place = [&first](const QString& page) {
        const qsizetype found = first.indexOf(page.mid(2));
        return found < 0 ? first.size() : found;
    };
    std::ranges::sort(pages, [&](const QString& a, const QString& b) { return std::pair(place(a), a) < std::pair(place(b), b); });
    return pages;
}

QUrl urlOf(const QString& resource) { return QUrl(QStringLiteral("qrc") + resource); }

}  // namespace

std::vector<HelpSection> sectionsOf(const QUrl& page, const QString& markdown) {
    std::vector<HelpSection> sections;
    bool code = false;
    for (const QString& line : markdown.split(QLatin1Char('\n'))) {
        if (line.startsWith(QLatin1String("```"))) code = !code;
        static const QRegularExpression heading(QStringLiteral("^(#{1,6}) +(.+)$"));
        const QRegularExpressionMatch match = code ? QRegularExpressionMatch() : heading.match(line);
        if (match.hasMatch())
            sections.push_back({page, plain(match.captured(2)), int(match.capturedLength(1)), plain(match.captured(2))});
        else if (!sections.empty())
            sections.back().text += QLatin1Char('\n') + (code ? line : plain(line));
    }
    return sections;
}

std::vector<HelpSection> helpSections(const QString& language) {
    const QString first = QStringLiteral(":/resources/help/help.%1.md").arg(language);
    const QString text = contentsOf(first);
    std::vector<HelpSection> sections = sectionsOf(urlOf(first), text);
    for (const QString& page : manualPages(text))
        for (HelpSection& section : sectionsOf(urlOf(page), contentsOf(page))) sections.push_back(std::move(section));
    return sections;
}

bool hasAllWords(const HelpSection& section, const QString& search) {
    const QStringList words = search.split(QRegularExpression(QStringLiteral("\\s+")), Qt::SkipEmptyParts);
    return std::ranges::all_of(words, [&](const QString& word) { return section.text.contains(word, Qt::CaseInsensitive); });
}

}  // namespace cullscope::ui
