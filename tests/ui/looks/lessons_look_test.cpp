// Every step of every lesson in the window and in the lecture, in every language and at two sizes.
#include <QHeaderView>
#include <QTabBar>
#include <QTableView>
#include <QTreeView>
#include <array>

#include "core/visibility/registry.h"
#include "tests/support/long_mode.h"
#include "tests/ui/lesson_window.h"
#include "tests/ui/looks/kept_picture.h"
#include "tests/ui/looks/shown_texts.h"
#include "ui/text/translated.h"

namespace cullscope::ui::lessons_look_test {
namespace {

/// Pictures to look at show what a lecture shows a moment later, too: colours and legends of a measured frame.
Session::Options options() { return test::longMode() ? sessionOptions(true) : withoutMeasuring(); }

struct LooksOfLessons : Lessons {
    LooksOfLessons() : Lessons(options()) {}

    [[nodiscard]] bool settled() {
        return onScreen() && !session.pictures()->busy() && (!test::longMode() || session.metricsSettled());
    }
    void settle() {
        // Other words ask for other room, layer by layer.
        constexpr int kLayers = 5;
        do {
            ASSERT_TRUE(waitUntil([this] { return settled(); }));
            for (int layer = 0; layer < kLayers; ++layer) QApplication::processEvents();
        } while (!settled());
    }
};

QRect placeIn(const QWidget& window, const QWidget& widget) { return {widget.mapTo(&window, QPoint()), widget.size()}; }

/// What lies over the tabs of the structure.
QStringList coveredTabs(LectureWindow& lecture) {
    QStringList covered;
    if (!lecture.structure().isVisible()) return covered;
    const QRect tabs = placeIn(lecture, *lecture.structure().findChild<QTabBar*>());
    QList<QWidget*> others = lecture.findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
    others.removeOne(&lecture.structure());
    others << &lecture.structure().map();
    for (const QWidget* other : others)
        if (other->isVisible() && placeIn(lecture, *other).intersects(tabs))
            covered << QStringLiteral("%1 covers the tabs").arg(QString::fromLatin1(other->metaObject()->className()));
    return covered;
}

/// Whether a list shows nothing between two heights.
bool isPlain(QAbstractItemView& list, int from, int to) {
    const QImage all = list.viewport()->grab().toImage();
    const QRgb ground = list.palette().color(QPalette::Base).rgb();
    for (int y = from; y < std::min(to, all.height()); ++y)
        for (int x = 0; x < all.width(); ++x)
            if (all.pixel(x, y) != ground) return false;
    return true;
}

/// The lines of a visible listing that are cut, and the current one where it is out of sight. What is below the last whole line
/// has one colour.
QStringList cutLines(StructurePanel& structure) {
    QStringList cut;
    for (ListingView* lines : structure.findChildren<ListingView*>()) {
        if (!lines->isVisible()) continue;
        const auto& model = dynamic_cast<const ListingModel&>(*lines->model());
        const QRect seen = lines->viewport()->rect();
        int begin = seen.height(), end = 0;
        for (int row = 0; row < model.rowCount(); ++row) {
            const int top = lines->rowViewportPosition(row), below = top + lines->rowHeight(row);
            if (top >= 0) begin = std::min(begin, top);
            if (below <= seen.height()) end = std::max(end, below);
            if (row == model.currentRow() && (top < 0 || below > seen.height()))
                cut << QStringLiteral("the current line %1 is out of sight").arg(row + 1);
        }
        if (!isPlain(*lines, 0, begin)) cut << QStringLiteral("a line is cut at the upper end");
        if (!isPlain(*lines, end, seen.height())) cut << QStringLiteral("a line is cut at the lower end");
    }
    for (LongListView* rows : structure.findChildren<LongListView*>()) {
        const int high = rows->viewport()->height();
        const QModelIndex last = rows->indexAt({1, high - 1});
        if (rows->isVisible() && last.isValid() && rows->visualRect(last).bottom() >= high &&
            !isPlain(*rows, rows->visualRect(last).top(), high))
            cut << QStringLiteral("a row of the tree is cut at the lower end");
    }
    return cut;
}

/// The views whose header does not have their strategy's name.
QStringList namelessViews(LectureWindow& lecture, Session& session) {
    QStringList nameless;
    for (ViewPane* pane : lecture.findChildren<ViewPane*>()) {
        const QString name = translated(findStrategy(session.slot(session.culledBy(pane->view())).id()).info.name);
        const ViewHeader& header = pane->header();
        if (header.isVisible() && (!header.shownFirstLine().contains(name) || header.elided()))
            nameless << header.shownFirstLine();
    }
    return nameless;
}

TEST_F(LooksOfLessons, nothingIsCutInAnyLanguageAndTheLectureHasNoSmallLetters) {
    constexpr int kSmallest = 20;  // pixels
    const std::array<QSize, 2> sizes{QSize(1280, 720), QSize(1920, 1080)};
    for (const QString& name : LessonPlayer::known()) {
        begin(name);
        for (const QSize& size : sizes) {
            window.resize(size);
            for (const Language::Known& known : Language::known()) {
                language.use(known.id);
                QApplication::processEvents();
                EXPECT_EQ(cutTexts(window.lessonBar()), QStringList()) << name.toStdString() << known.id.toStdString();
            }
        }
        window.actions().lecture->trigger();
        LectureWindow* lecture = window.lecture();
        ASSERT_TRUE(lecture);
        lecture->showNormal();
        for (int step = 0; step < player().count(); ++step) {
            go(step);
            ASSERT_FALSE(HasFatalFailure());
            for (const QSize& size : sizes) {
                lecture->resize(size);
                settle();
                ASSERT_FALSE(HasFatalFailure());
                for (const Language::Known& known : Language::known()) {
                    language.use(known.id);
                    settle();
                    const std::string where = name.toStdString() + ", step " + std::to_string(step + 1) + ", " +
                                              known.id.toStdString() + ", " + std::to_string(size.height());
                    QStringList cut;
                    for (const QWidget* part : lecture->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
                        if (part->isVisible()) cut += cutTexts(*part);
                    for (const auto* tree : lecture->structure().findChildren<QTreeView*>())
                        for (int column = 0; tree->isVisible() && column < tree->header()->count(); ++column) {
                            const QString title = tree->model()->headerData(column, Qt::Horizontal).toString();
                            const int needed = QFontMetrics(tree->header()->font()).horizontalAdvance(title);
                            if (!tree->isColumnHidden(column) && needed > tree->header()->sectionSize(column)) cut << title;
                        }
                    EXPECT_EQ(cut, QStringList()) << where;
                    EXPECT_EQ(coveredTabs(*lecture).join(QLatin1Char('\n')).toStdString(), "") << where;
                    EXPECT_EQ(cutLines(lecture->structure()).join(QLatin1Char('\n')).toStdString(), "") << where;
                    EXPECT_EQ(namelessViews(*lecture, session).join(QLatin1Char('\n')).toStdString(), "") << where;
                    // 400 pictures to look at take longer than all that is checked.
                    if (test::longMode())
                        lecture->grab().save(
                            writtenPicturesFolder() +
                            QStringLiteral("/lesson-%1-%2-%3-%4.png").arg(name).arg(step + 1).arg(known.id).arg(size.height()));
                    for (const ShownText& text : shownTexts(*lecture))
                        if (text.painted)
                            EXPECT_GE(QFontInfo(text.font).pixelSize(), kSmallest)
                                << where << ": " << text.text.toStdString() << " in " << text.where.toStdString();
                }
            }
        }
        language.use(QStringLiteral("en"));
        QTest::keyClick(lecture, Qt::Key_Escape);
        ASSERT_TRUE(waitUntil([&] { return !window.lecture(); }));
    }
}

}  // namespace
}  // namespace cullscope::ui::lessons_look_test
