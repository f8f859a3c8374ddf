// The links of the help window lead from its first page to the pages of docs/ and back.
#include "ui/dialogs/help_window.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QImage>

namespace cullscope::ui::help_window_test {
namespace {

/// Paths of the pages in docs/ of the source tree, such as "methods/spherical.md".
QStringList pagesOfDocs() {
    const QDir docs(QStringLiteral(CULLSCOPE_SOURCE_DIR "/docs"));
    QStringList pages;
    QDirIterator found(docs.path(), {QStringLiteral("*.md")}, QDir::Files, QDirIterator::Subdirectories);
    while (found.hasNext()) pages << docs.relativeFilePath(found.next());
    return pages;
}

QString textOf(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return QString::fromUtf8(file.readAll());
}

/// Follows a link of the page, as a click does.
void follow(QTextBrowser& page, const char* link) { page.setSource(page.source().resolved(QUrl(QString::fromLatin1(link)))); }

TEST(HelpWindow, everyPageOfDocsIsInTheProgramAndOnTheFirstPage) {
    const QStringList pages = pagesOfDocs();
    EXPECT_GE(pages.size(), 8);
    for (const QString& page : pages) {
        EXPECT_TRUE(QFile::exists(QStringLiteral(":/docs/") + page)) << page.toStdString();
        for (const Language::Known& language : Language::known()) {
            const QString first = textOf(QStringLiteral(":/resources/help/help.%1.md").arg(language.id));
            EXPECT_TRUE(first.contains(QStringLiteral("(../../docs/%1)").arg(page)))
                << language.id.toStdString() << " has no link to " << page.toStdString();
        }
    }
}

TEST(HelpWindow, linksLeadFromPageToPageAndBackLeadsHome) {
    const Language language;
    HelpWindow help(language);
    QTextBrowser& page = help.page();
    const QString first = page.toPlainText();
    const QList<QToolButton*> buttons = help.findChildren<QToolButton*>();
    ASSERT_EQ(buttons.size(), 2);
    EXPECT_FALSE(buttons[0]->isEnabled());

    follow(page, "../../docs/methods/spherical.md#how-s-is-defined");
    EXPECT_TRUE(page.toPlainText().contains(QStringLiteral("How S is defined")));
    follow(page, "../measuring.md");
    EXPECT_TRUE(page.toPlainText().contains(QStringLiteral("Ground truth")));
    buttons[0]->click();
    EXPECT_TRUE(page.toPlainText().contains(QStringLiteral("How S is defined")));
    buttons[0]->click();
    EXPECT_EQ(page.toPlainText(), first);
    EXPECT_FALSE(buttons[0]->isEnabled());

    follow(page, "../../docs/using.md");
    EXPECT_NE(page.toPlainText(), first);
    buttons[1]->click();
    EXPECT_EQ(page.toPlainText(), first);
}

TEST(HelpWindow, anotherLanguageBeginsAtItsFirstPage) {
    Language language;
    HelpWindow help(language);
    const QString english = help.page().toPlainText();
    follow(help.page(), "../../docs/using.md");
    language.use(QStringLiteral("ko"));
    EXPECT_NE(help.page().toPlainText(), english);
    EXPECT_FALSE(help.page().isBackwardAvailable());
    language.use(QStringLiteral("en"));
    EXPECT_EQ(help.page().toPlainText(), english);
}

TEST(HelpWindow, pictureIsNoWiderThanThePage) {
    const Language language;
    HelpWindow help(language);
    const auto widthOf = [&](const char* picture) {
        return help.page().loadResource(QTextDocument::ImageResource, QUrl(QString::fromLatin1(picture))).value<QImage>().width();
    };
    EXPECT_EQ(widthOf("first-window.png"), 680);
    follow(help.page(), "../../docs/methods/spherical.md");
    EXPECT_EQ(widthOf("../../resources/help/lossless.png"), 680);
}

}  // namespace
}  // namespace cullscope::ui::help_window_test
