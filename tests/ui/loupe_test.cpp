// The loupe follows the pointer, and the next loss is visible after a jump to it.
#include <gtest/gtest.h>

#include "tests/ui/test_scene.h"
#include "ui/window/main_window.h"

namespace cullscope::ui::loupe_test {
namespace {

constexpr int kMostTurns = 40;

struct Loupe : ::testing::Test {
    void SetUp() override {
        window.resize(1366, 768);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window, kPatience));
        openAndWait(session, QStringLiteral("torus:triangles=2000"));
        session.setViewCount(4);
        for (const int view : {0, 1, 2, 3}) session.setLinked(view);
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitUntil([&] { return session.buffers() && session.metricsSettled() && !session.pictures()->busy(); }));
        QApplication::processEvents();
    }

    SceneView& picture(int view) { return window.views().pane(view).picture(); }
    std::optional<QPointF> loupe(int view) { return picture(view).extras().loupe; }

    void point(int view, const QPointF& at) {
        QMouseEvent event(QEvent::MouseMove, at, picture(view).mapToGlobal(at), Qt::NoButton, {}, {});
        QApplication::sendEvent(&picture(view), &event);
    }

    void leave(int view) {
        QEvent event(QEvent::Leave);
        QApplication::sendEvent(&picture(view), &event);
    }

    Session session{sessionOptions(true)};
    Language language;
    Appearance appearance;
    MainWindow window{session, language, appearance};
};

TEST_F(Loupe, theLoupeIsAtThePointersPixelAndNowhereElse) {
    window.actions().loupe->trigger();
    leave(0);
    for (int view = 0; view < 4; ++view) EXPECT_FALSE(loupe(view)) << "the pointer is in no view, and view " << view;
    session.observe(3, 0);
    settle();
    point(1, {100.0, 60.0});
    ASSERT_TRUE(loupe(1));
    for (const int view : {0, 2}) EXPECT_EQ(loupe(view), loupe(1)) << "the same pixel in linked view " << view;
    EXPECT_FALSE(loupe(3)) << "an observer looks from elsewhere";
    ViewSetup setup = session.setup(2);
    setup.size = Viewport{320, 240};
    session.setSetup(2, setup);
    settle();
    point(1, {101.0, 60.0});
    EXPECT_TRUE(loupe(0));
    EXPECT_FALSE(loupe(2)) << "a picture of another size has other pixels";
    leave(1);
    for (int view = 0; view < 4; ++view) EXPECT_FALSE(loupe(view)) << "left, view " << view;
    point(3, {50.0, 50.0});
    EXPECT_TRUE(loupe(3));
    for (const int view : {0, 1, 2}) EXPECT_FALSE(loupe(view)) << "beside an observer, view " << view;
    window.actions().loupe->trigger();
    EXPECT_FALSE(loupe(3));
}

TEST_F(Loupe, theNextLossIsShownWhereItIsMarked) {
    session.setActiveView(1);
    session.slot(1).choose("backface");
    settle();
    // Back-face culling misses pixels because the rasteriser snaps vertices: turn the scene until a pixel is missed.
    for (int turn = 0; turn < kMostTurns && session.figures(1).holes.empty(); ++turn) {
        session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), Angle::fromDegrees(1.0)));
        settle();
    }
    ASSERT_FALSE(session.figures(1).holes.empty());
    const auto goAndLeave = [&](Wipe::Mode before, Wipe::Mode shown) {
        ViewSetup setup = session.setup(1);
        setup.wipe.mode = before;
        session.setSetup(1, setup);
        settle();
        window.actions().nextLoss->trigger();
        EXPECT_EQ(session.setup(1).wipe.mode, shown);
        EXPECT_TRUE(picture(1).markedLoss());
        EXPECT_TRUE(loupe(1));
        settle();
        EXPECT_TRUE(picture(1).markedLoss());
        QTest::keyClick(&picture(1), Qt::Key_Escape);
        EXPECT_FALSE(picture(1).markedLoss());
        EXPECT_FALSE(loupe(1));
        EXPECT_EQ(session.setup(1).wipe.mode, before);
    };
    goAndLeave(Wipe::Mode::None, Wipe::Mode::Loss);
    goAndLeave(Wipe::Mode::Truth, Wipe::Mode::Truth);
    goAndLeave(Wipe::Mode::Loss, Wipe::Mode::Loss);
}

}  // namespace
}  // namespace cullscope::ui::loupe_test
