// Use of the window without a mouse.
#include <QAccessible>
#include <QDialog>
#include <QLineEdit>
#include <QTabBar>
#include <QTabWidget>

#include "tests/ui/looks/desktop.h"

namespace cullscope::ui::keyboard_test {
namespace {

constexpr int kMostStops = 120;
constexpr int kMostTurns = 20;

void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QWidget* widget = QApplication::focusWidget() ? QApplication::focusWidget() : QApplication::activeWindow();
    ASSERT_TRUE(widget);
    QTest::keyClick(widget, key, modifiers);
    QApplication::processEvents();
}

/// Presses Tab until a wanted widget has the focus; returns false if none gets it.
bool tabTo(const std::function<bool(const QWidget&)>& wanted) {
    for (int stop = 0; stop < kMostStops; ++stop) {
        if (const QWidget* widget = QApplication::focusWidget(); widget && wanted(*widget)) return true;
        press(Qt::Key_Tab);
    }
    return false;
}

bool tabTo(const QWidget* wanted) {
    return tabTo([wanted](const QWidget& widget) { return &widget == wanted; });
}

QString nameOf(const QWidget& widget) {
    if (!widget.accessibleName().isEmpty()) return widget.accessibleName();
    QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(const_cast<QWidget*>(&widget));
    return interface ? interface->text(QAccessible::Name) : QString();
}

TEST(Keyboard, everythingOfALessonWorksWithoutAMouse) {
    Desktop desktop;
    Session& session = desktop.session;
    MainWindow& window = desktop.window;
    // Choose a strategy: the first button of the rail opens a page whose list has the focus.
    ASSERT_TRUE(tabTo(&window.side().button(0)));
    press(Qt::Key_Space);
    ASSERT_TRUE(tabTo(&window.strategyPanel().choice()));
    while (session.slot(0).id() != "frustum" &&
           window.strategyPanel().choice().currentIndex() + 1 < window.strategyPanel().choice().count())
        press(Qt::Key_Down);
    ASSERT_EQ(session.slot(0).id(), "frustum");
    desktop.settle();
    // Change a parameter; its field is next in the tab order.
    const ParameterSet before = session.slot(0).parameters();
    ASSERT_TRUE(tabTo(window.strategyPanel().form().findChild<QWidget*>(QStringLiteral("box"))));
    press(Qt::Key_Down);
    EXPECT_FALSE(session.slot(0).parameters() == before);
    press(Qt::Key_Escape);
    EXPECT_EQ(window.side().openPage(), -1);
    // Look at the losses of back-face culling, which come from the rasteriser's snapping of vertices.
    ASSERT_TRUE(tabTo(&window.side().button(0)));
    press(Qt::Key_Space);
    ASSERT_TRUE(tabTo(&window.strategyPanel().choice()));
    while (session.slot(0).id() != "backface" && window.strategyPanel().choice().currentIndex() > 0) press(Qt::Key_Up);
    ASSERT_EQ(session.slot(0).id(), "backface");
    press(Qt::Key_Escape);
    desktop.settle();
    ASSERT_TRUE(tabTo(window.tabs().tabBar()));
    for (int tab = 0; tab < window.tabs().count() && window.tabs().currentWidget() != &window.structurePanel().losses(); ++tab)
        press(Qt::Key_Right);
    EXPECT_EQ(window.tabs().currentWidget(), &window.structurePanel().losses());
    EXPECT_TRUE(window.structurePanel().losses().isVisible());
    // Turn the scene until a pixel is missed.
    ASSERT_TRUE(tabTo(&desktop.view(0)));
    for (int turn = 0; turn < kMostTurns && session.figures(0).holes.empty(); ++turn) {
        press(Qt::Key_Right);
        desktop.settle();
    }
    ASSERT_GT(session.figures(0).holes.size(), 0u) << "nothing was lost that one could go to";
    press(Qt::Key_N);
    EXPECT_EQ(desktop.view(0).markedLoss(), std::optional<size_t>(0));
    desktop.settle();
    EXPECT_TRUE(looksAsKept(desktop.look(), QStringLiteral("next-loss")));
    // Open the dialog for a screenshot and cancel it.
    bool asked = false;
    QTimer watch;
    QObject::connect(&watch, &QTimer::timeout, [&] {
        QWidget* dialog = QApplication::activeModalWidget();
        if (!dialog) return;
        asked = true;
        QTest::keyClick(dialog, Qt::Key_Escape);
    });
    watch.start(50);
    press(Qt::Key_F12, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_TRUE(asked);
    EXPECT_EQ(QApplication::activeModalWidget(), nullptr);
    EXPECT_FALSE(window.document().screenshots().busy());
}

TEST(Keyboard, noPageOfTheInsideDockHoldsTheFocus) {
    // A strategy that has every page.
    Desktop desktop({.strategies = {"frustum-octree"}});
    desktop.settle();
    QTabWidget& tabs = desktop.window.tabs();
    for (int tab = 0; tab < tabs.count(); ++tab) {
        tabs.setCurrentIndex(tab);
        tabs.tabBar()->setFocus();
        press(Qt::Key_Tab);
        EXPECT_TRUE(tabTo(&desktop.view(0))) << tabs.tabText(tab).toStdString();
    }
}

TEST(Keyboard, whatTakesTheFocusHasAName) {
    Desktop desktop;
    desktop.window.side().setOpenPage(0);
    desktop.window.statistics().toggleViewAction()->trigger();
    desktop.settle();
    int stops = 0;
    for (const auto* widget : desktop.window.findChildren<QWidget*>()) {
        if (!widget->isVisible() || !widget->isEnabled() || widget->focusProxy() || (widget->focusPolicy() & Qt::TabFocus) == 0)
            continue;
        ++stops;
        EXPECT_FALSE(nameOf(*widget).isEmpty()) << widget->metaObject()->className() << " " << widget->objectName().toStdString()
                                                << " in " << widget->parentWidget()->metaObject()->className();
    }
    EXPECT_GT(stops, 15);
}

}  // namespace
}  // namespace cullscope::ui::keyboard_test
