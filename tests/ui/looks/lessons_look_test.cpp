// Every step of every lesson in the window and in the lecture, in every language and at two sizes.
#include <QHeaderView>
#include <QTreeView>

#include "tests/support/long_mode.h"
#include "tests/ui/lesson_window.h"
#include "tests/ui/looks/kept_picture.h"
#include "tests/ui/looks/shown_texts.h"

namespace cullscope::ui::lessons_look_test {
namespace {

TEST_F(Lessons, nothingIsCutInAnyLanguageAndTheLectureHasNoSmallLetters) {
    constexpr int kSmallest = 20;  // pixels
    for (const QString& name : LessonPlayer::known()) {
        begin(name);
        for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080)}) {
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
            for (const QSize& size : {QSize(1280, 720), QSize(1920, 1080)}) {
                lecture->resize(size);
                for (const Language::Known& known : Language::known()) {
                    language.use(known.id);
                    QApplication::processEvents();
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
