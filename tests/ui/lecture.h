#pragma once

#include "tests/ui/lesson_window.h"

namespace cullscope::ui {

/// The lecture's window over a small scene.
struct Lecture : Lessons {
    void SetUp() override {
        Lessons::SetUp();
        openAndWait(session, QStringLiteral("torus:triangles=2000"));
    }
    /// View A by a strategy, and view B that watches it.
    void watch(const char* strategy) {
        session.slot(0).choose(strategy);
        session.observe(1, 0);
        ViewSetup setup = session.setup(1);
        setup.look.watch();
        session.setSetup(1, setup);
        session.setActiveView(0);
    }
    LectureWindow& begin() {
        window.actions().lecture->trigger();
        window.lecture()->showNormal();
        window.lecture()->resize(1280, 720);
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.lecture(), kPatience));
        EXPECT_TRUE(waitUntil([&] { return drawn(); }));
        return *window.lecture();
    }
    bool drawn() {
        for (const int view : session.shownViews())
            if (session.slot(session.culledBy(view)).building() || !session.pictures()->isCurrent(view)) return false;
        return session.buffers() && !session.pictures()->busy();
    }
};

}  // namespace cullscope::ui
