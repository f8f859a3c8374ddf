#pragma once

#include <gtest/gtest.h>

#include <QApplication>
#include <QMouseEvent>

#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui {

/// A window of the size of the least screen.
struct EightViews : ::testing::Test {
    static inline const QString kScene = QStringLiteral("star:seed=7,triangles=20000");
    static inline const QString kObjects = QStringLiteral("split:mesh=star:seed=7,triangles=20000,by=clusters,triangles=500");

    void SetUp() override {
        window.resize(1366, 768);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
    }

    void open(const QString& scene) {
        openAndWait(session, scene);
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled() && !session.pictures()->busy(); }));
        QApplication::processEvents();
    }

    SceneView& picture(int view) { return window.views().pane(view).picture(); }
    QImage shown(int view) { return session.picture(view)->colour; }

    void setSizes(const std::optional<Viewport>& size) {
        for (int view = 0; view < Session::kMostViews; ++view) {
            ViewSetup setup = session.setup(view);
            setup.size = size;
            session.setSetup(view, setup);
        }
    }

    void drag(int view, const QPoint& way, int steps) {
        QWidget& widget = picture(view);
        const QPointF from(widget.width() / 2.0, widget.height() / 2.0);
        const auto send = [&](QEvent::Type type, const QPointF& at, Qt::MouseButton button, Qt::MouseButtons buttons) {
            QMouseEvent event(type, at, widget.mapToGlobal(at), button, buttons, {});
            QApplication::sendEvent(&widget, &event);
        };
        send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
        for (int step = 1; step <= steps; ++step) {
            send(QEvent::MouseMove, from + QPointF(way) * step / steps, Qt::NoButton, Qt::LeftButton);
            QApplication::processEvents();
        }
        send(QEvent::MouseButtonRelease, from + QPointF(way), Qt::LeftButton, {});
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

}  // namespace cullscope::ui
