#include "ui/window/window_memory.h"

#include <gtest/gtest.h>

#include <QDockWidget>

namespace cullscope::ui::window_memory_test {
namespace {

struct Memory : ::testing::Test {
    void SetUp() override { QSettings().clear(); }
};

/// A window with one dock; MainWindow has several.
struct SomeWindow {
    SomeWindow() {
        dock.setObjectName(QStringLiteral("dock"));
        window.addDockWidget(Qt::RightDockWidgetArea, &dock);
        memory.emplace(window);
    }
    QMainWindow window;
    QDockWidget dock;
    std::optional<WindowMemory> memory;
};

TEST_F(Memory, theWindowComesBackAsItWasLeft) {
    const WindowMemory::Layout layout{QStringLiteral("compare"), 8};
    {
        SomeWindow first;
        EXPECT_FALSE(first.memory->restore().has_value());
        first.window.resize(512, 384);
        first.window.addDockWidget(Qt::LeftDockWidgetArea, &first.dock);
        first.memory->save(layout);
    }
    SomeWindow next;
    EXPECT_EQ(next.memory->restore(), layout);
    EXPECT_EQ(next.window.size(), QSize(512, 384));
    EXPECT_EQ(next.window.dockWidgetArea(&next.dock), Qt::LeftDockWidgetArea);
    next.memory->reset();
    EXPECT_EQ(next.window.dockWidgetArea(&next.dock), Qt::RightDockWidgetArea);
    SomeWindow last;
    EXPECT_FALSE(last.memory->restore().has_value());
    EXPECT_EQ(last.window.dockWidgetArea(&last.dock), Qt::RightDockWidgetArea);
}

TEST_F(Memory, anOtherVersionsLayoutIsNotUsed) {
    SomeWindow window;
    window.memory->save({QStringLiteral("compare"), 8});
    QSettings().setValue(QStringLiteral("window/version"), 999);
    EXPECT_FALSE(window.memory->restore().has_value());
    QSettings().setValue(QStringLiteral("window/version"), 1);
    QSettings().setValue(QStringLiteral("window/geometry"), QByteArray("damaged"));
    EXPECT_FALSE(window.memory->restore().has_value());
}

}  // namespace
}  // namespace cullscope::ui::window_memory_test
