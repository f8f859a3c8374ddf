#include "ui/look/wrapped_tips.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QTest>
#include <QToolTip>
#include <QVBoxLayout>

namespace cullscope::ui::wrapped_tips_test {
namespace {

const QString kLong = QStringLiteral("word ").repeated(80).trimmed();

/// The tip that appears for the pointer at a place of a widget, with the filter that every start of the program installs.
QString tipAt(QWidget& widget, const QPoint& place) {
    QToolTip::hideText();
    QHelpEvent help(QEvent::ToolTip, place, widget.mapToGlobal(place));
    QApplication::sendEvent(&widget, &help);
    return QToolTip::text();
}

struct Tips : ::testing::Test {
    void SetUp() override {
        window.resize(300, 200);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    }

    QWidget window;
};

int widest(const QString& tip) {
    qsizetype widest = 0;
    for (const QString& line : tip.split(QLatin1Char('\n'))) widest = std::max(widest, line.size());
    return int(widest);
}

TEST_F(Tips, longOnesAreBrokenInLinesAndKeepTheirWords) {
    EXPECT_EQ(wrappedTip(kLong).replace(QLatin1Char('\n'), QLatin1Char(' ')), kLong);
    EXPECT_LT(widest(wrappedTip(kLong)), 110);
    EXPECT_EQ(wrappedTip(QStringLiteral("one\ntwo")), QStringLiteral("one\ntwo"));
    QLabel label(QStringLiteral("a"), &window);
    label.setToolTip(kLong);
    label.show();
    EXPECT_EQ(tipAt(label, {2, 2}), wrappedTip(kLong));
}

TEST_F(Tips, ofAParentOfAListAndOfAMenu) {
    window.setToolTip(kLong);
    QLabel child(QStringLiteral("a"), &window);
    child.show();
    EXPECT_EQ(tipAt(child, {2, 2}), wrappedTip(kLong)) << "a widget without a tip shows that of its parent";
    QListWidget list(&window);
    list.addItem(QStringLiteral("row"));
    list.item(0)->setToolTip(kLong + QStringLiteral(" row"));
    list.show();
    EXPECT_EQ(tipAt(*list.viewport(), list.visualItemRect(list.item(0)).center()), wrappedTip(kLong + QStringLiteral(" row")));
    QMenu menu(&window);
    menu.setToolTipsVisible(true);
    QAction* action = menu.addAction(QStringLiteral("do"));
    action->setToolTip(kLong + QStringLiteral(" menu"));
    menu.popup(window.mapToGlobal(QPoint(10, 10)));
    EXPECT_EQ(tipAt(menu, menu.actionGeometry(action).center()), wrappedTip(kLong + QStringLiteral(" menu")));
    menu.close();
}

}  // namespace
}  // namespace cullscope::ui::wrapped_tips_test
