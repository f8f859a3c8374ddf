// Messages over the views: information disappears by itself, warnings stay, and the bar covers no button.
#include <gtest/gtest.h>

#include <QStyle>

#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::message_bar_test {
namespace {

constexpr int kInformationTime = 1000;  // ms

struct MessageOverTheViews : ::testing::Test {
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

TEST_F(MessageOverTheViews, informationGoesByItselfOrWhenTheUserGoesOn) {
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

TEST_F(MessageOverTheViews, warningsAndErrorsStayUntilTheyAreClosed) {
    for (const Severity severity : {Severity::Warning, Severity::Error}) {
        say(Severity::Information);
        say(severity);
        QTest::mouseClick(&window.views(), Qt::LeftButton);
        QTest::keyClick(&window.views(), Qt::Key_Space);
        QTest::qWait(kInformationTime + 500);
        EXPECT_TRUE(window.message().isVisible());
        auto* close = window.message().findChild<QToolButton*>();
        ASSERT_TRUE(close);
        QTest::mouseClick(close, Qt::LeftButton);
        EXPECT_FALSE(window.message().isVisible());
    }
}

TEST_F(MessageOverTheViews, theStatisticsButtonLiesBesideIt) {
    say(Severity::Error);
    for (const int width : {1000, 1700, 900}) {
        window.resize(width, 650);
        QApplication::processEvents();
        const auto placed = [&](const QWidget& widget) { return QRect(widget.mapTo(&window, QPoint()), widget.size()); };
        const QRect message = placed(window.message());
        int buttons = 0;
        for (const auto* button : window.findChildren<QToolButton*>()) {
            if (button->defaultAction() != window.statistics().toggleViewAction() || !button->isVisible()) continue;
            ++buttons;
            EXPECT_FALSE(message.intersects(placed(*button))) << width;
        }
        EXPECT_EQ(buttons, 1);
        EXPECT_TRUE(placed(*window.views().parentWidget()).contains(message)) << width;
    }
}

}  // namespace
}  // namespace cullscope::ui::message_bar_test
