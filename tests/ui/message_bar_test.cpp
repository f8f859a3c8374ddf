// Messages: information disappears by itself, warnings stay, and the bar covers nothing.
#include <gtest/gtest.h>

#include <QMessageBox>
#include <QStatusBar>
#include <QStyle>
#include <algorithm>

#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::message_bar_test {
namespace {

constexpr int kInformationTime = 1000;  // ms

struct MessageInTheStatusBar : ::testing::Test {
    void SetUp() override {
        window.message().setInformationTime(kInformationTime);
        window.resize(1000, 700);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    }

    void say(Severity severity) {
        session.raise(severity, Message{"Saved %1", {"picture.png"}});
        QApplication::processEvents();
        ASSERT_TRUE(window.message().isVisible());
    }

    Session session{sessionOptions(false)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

TEST_F(MessageInTheStatusBar, informationGoesByItselfOrWhenTheUserGoesOn) {
    say(Severity::Information);
    EXPECT_TRUE(waitUntil([&] { return !window.message().isVisible(); }));
    say(Severity::Information);
    QTest::keyClick(&window.views(), Qt::Key_Shift);
    EXPECT_FALSE(window.message().isVisible()) << "the user went on by a key";
    say(Severity::Information);
    QTest::mouseClick(&window.views(), Qt::LeftButton);
    EXPECT_FALSE(window.message().isVisible()) << "the user went on by a click";
    say(Severity::Information);
    QTest::mouseClick(&window.message(), Qt::LeftButton);
    EXPECT_TRUE(window.message().isVisible()) << "a click on it is to select";
}

TEST_F(MessageInTheStatusBar, warningsAndErrorsStayUntilTheyAreClosed) {
    for (const Severity severity : {Severity::Warning, Severity::Error}) {
        say(Severity::Information);
        say(severity);
        QTest::mouseClick(&window.views(), Qt::LeftButton);
        QTest::keyClick(&window.views(), Qt::Key_Space);
        QTest::qWait(kInformationTime + 500);
        EXPECT_TRUE(window.message().isVisible());
        const QList<QToolButton*> buttons = window.message().findChildren<QToolButton*>();
        auto* close = *std::ranges::find(buttons, QString(), &QToolButton::text);
        QTest::mouseClick(close, Qt::LeftButton);
        EXPECT_FALSE(window.message().isVisible());
    }
}

TEST_F(MessageInTheStatusBar, coversNothingAndTakesNoRoomFromTheViews) {
    const QString words = QStringLiteral("what is wrong with it is told in a long sentence ").repeated(8);
    for (const int width : {1000, 1700, 900}) {
        window.resize(width, 650);
        window.message().hide();
        QApplication::processEvents();
        const QSize before = window.views().size();
        const int height = window.statusBar()->height();
        for (const QString& text : {QStringLiteral("short"), words}) {
            session.raise(Severity::Error, Message{"Saved %1", {text.toStdString()}});
            QApplication::processEvents();
            const auto placed = [&](const QWidget& widget) { return QRect(widget.mapTo(&window, QPoint()), widget.size()); };
            EXPECT_EQ(window.views().size(), before) << width;
            EXPECT_EQ(window.statusBar()->height(), height) << width;
            EXPECT_TRUE(placed(*window.statusBar()).contains(placed(window.message()))) << width;
            EXPECT_FALSE(placed(*window.centralWidget()).intersects(placed(window.message()))) << width;
            EXPECT_TRUE(window.message().text().contains(text));
            EXPECT_EQ(window.message().whole().isVisible(), text == words) << width;
            for (const auto* label : window.message().findChildren<QLabel*>())
                EXPECT_LE(QFontMetrics(label->font()).horizontalAdvance(label->text()), label->width() + 1) << width;
        }
        QTest::mouseClick(&window.message().whole(), Qt::LeftButton);
        auto* box = window.findChild<QMessageBox*>();
        ASSERT_TRUE(box);
        EXPECT_TRUE(box->text().contains(words));
        box->close();
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    }
}

}  // namespace
}  // namespace cullscope::ui::message_bar_test
