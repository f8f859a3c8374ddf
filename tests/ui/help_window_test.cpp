// The links of the help window lead from its first page to the pages of docs/ and back.
#include "ui/dialogs/help_window.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QImage>
#include <QTextBlock>
#include <QTreeWidgetItemIterator>

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
    ASSERT_GE(buttons.size(), 2);  // and that which clears the search
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

TEST(HelpWindow, sectionsAreThoseOfTheHeadingsAndNotOfCode) {
    const QUrl page(QStringLiteral("qrc:/docs/a.md"));
    const QString text =
        QStringLiteral("# A *page*\nfirst `code`\n\n```\n# no heading\n```\n## With a [link](b.md)\nsecond\n### Third\n");
    const std::vector<HelpSection> sections = sectionsOf(page, text);
    ASSERT_EQ(sections.size(), 3u);
    EXPECT_EQ(sections[0].title, QStringLiteral("A page"));
    EXPECT_TRUE(sections[0].text.contains(QStringLiteral("first code")));
    EXPECT_TRUE(sections[0].text.contains(QStringLiteral("# no heading")));
    EXPECT_EQ(sections[1].title, QStringLiteral("With a link"));
    EXPECT_EQ(sections[1].level, 2);
    EXPECT_EQ(sections[2].title, QStringLiteral("Third"));
    EXPECT_TRUE(hasAllWords(sections[1], QStringLiteral(" SECOND link ")));
    EXPECT_FALSE(hasAllWords(sections[1], QStringLiteral("second third")));
}

/// The items that are shown, with their pages.
QStringList shownIn(QTreeWidget& contents) {
    QStringList shown;
    for (QTreeWidgetItemIterator item(&contents, QTreeWidgetItemIterator::NotHidden); *item; ++item)
        if (!(*item)->parent() || !(*item)->parent()->isHidden()) shown << (*item)->text(0);
    return shown;
}

TEST(HelpWindow, contentsListEveryPageAndASectionIsShownByAClick) {
    Language language;
    HelpWindow help(language);
    help.show();
    EXPECT_EQ(help.contents().topLevelItemCount(), 1 + int(pagesOfDocs().size()));
    int sections = 0;
    for (QTreeWidgetItemIterator item(&help.contents()); *item; ++item) {
        help.contents().setCurrentItem(*item);
        ++sections;
        // The heading of the section is one of the page's.
        bool found = false;
        for (QTextBlock block = help.page().document()->begin(); block.isValid(); block = block.next())
            found = found || (block.blockFormat().headingLevel() > 0 && block.text().trimmed() == (*item)->text(0));
        EXPECT_TRUE(found) << (*item)->text(0).toStdString() << " in " << help.page().source().toString().toStdString();
    }
    EXPECT_GT(sections, 60);
    for (const QString& id : {QStringLiteral("ko"), QStringLiteral("zh_CN"), QStringLiteral("en")}) {
        language.use(id);
        EXPECT_EQ(help.page().source().fileName(), QStringLiteral("help.%1.md").arg(id));
        EXPECT_GT(help.contents().topLevelItem(0)->childCount(), 5) << id.toStdString();
    }
}

TEST(HelpWindow, aSearchLeavesTheSectionsThatHaveItsWordsAndMarksThem) {
    const Language language;
    HelpWindow help(language);
    help.show();
    const qsizetype all = shownIn(help.contents()).size();
    help.search().setText(QStringLiteral("occlusion QUERY"));
    const QStringList found = shownIn(help.contents());
    EXPECT_GT(found.size(), 1);
    EXPECT_LT(found.size(), all / 2);
    emit help.search().returnPressed();
    ASSERT_TRUE(help.contents().currentItem());
    EXPECT_TRUE(help.page().toPlainText().contains(QStringLiteral("query"), Qt::CaseInsensitive));
    EXPECT_GT(help.page().extraSelections().size(), 0);
    help.search().setText(QStringLiteral("no-such-word-anywhere"));
    EXPECT_EQ(shownIn(help.contents()), QStringList());
    help.search().clear();
    EXPECT_EQ(shownIn(help.contents()).size(), all);
    EXPECT_TRUE(help.page().extraSelections().isEmpty());
}

}  // namespace
}  // namespace cullscope::ui::help_window_test
