#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QWheelEvent>

#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {

/// A shown window with a small scene and complete metrics.
struct Window : ::testing::Test {
    void SetUp() override {
        window.resize(1000, 700);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        openAndWait(session, QStringLiteral("torus:triangles=2000"));
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled() && !session.pictures()->busy(); }));
        QApplication::processEvents();
    }

    SceneView& picture(int view) { return window.views().pane(view).picture(); }

    void turnWheel(int notches, Qt::KeyboardModifiers modifiers, const QPointF& position) {
        QWheelEvent event(position, picture(0).mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&picture(0), &event);
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

}  // namespace cullscope::ui
