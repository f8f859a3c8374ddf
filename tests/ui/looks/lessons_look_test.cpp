// Every step of every lesson in the window and in the lecture, in every language and at two sizes.
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
                    // The panel beside the pictures scrolls and elides, and its tool tips have the whole.
                    QStringList cut;
                    for (const QWidget* part : lecture->findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
                        if (part->isVisible() && part != &lecture->structure()) cut += cutTexts(*part);
                    EXPECT_EQ(cut, QStringList()) << where;
                    if (size.height() < 1000)
                        lecture->grab().save(writtenPicturesFolder() +
                                             QStringLiteral("/lesson-%1-%2-%3.png").arg(name).arg(step + 1).arg(known.id));
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
