// Many views in their roles: frozen, observer, observed, and lent to a lecture.
#include <gtest/gtest.h>

#include "tests/ui/eight_views.h"

namespace cullscope::ui::eight_views_roles_test {
namespace {

TEST_F(EightViews, freezingKeepsFiguresAndNeighboursWhileTheViewFlies) {
    open(kScene);
    session.setViewCount(4);
    session.setActiveView(1);
    session.slot(1).choose("backface");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.6, 1.0));
    settle();
    std::vector<QImage> before;
    for (int view = 0; view < 4; ++view) before.push_back(shown(view));
    const ViewMetrics figures = session.figures(1);
    window.actions().freeze->trigger();
    settle();
    EXPECT_EQ(shown(1), before[1]) << "freezing alone changes nothing";
    session.setViewingCamera(1, turned(session.viewingCamera(1), UpAxis::Y, Angle::fromDegrees(90.0), {}));
    settle();
    EXPECT_NE(shown(1), before[1]);
    for (const int view : {0, 2, 3}) EXPECT_EQ(shown(view), before[size_t(view)]) << "view " << view;
    EXPECT_EQ(session.figures(1).consideredTriangles, figures.consideredTriangles);
    EXPECT_EQ(session.figures(1).accuracy.missedPixels, figures.accuracy.missedPixels);
    EXPECT_EQ(session.figures(1).frameMilliseconds, figures.frameMilliseconds) << "measured anew although nothing changed";
    EXPECT_TRUE(window.views().pane(1).chipText().contains(QStringLiteral("frozen")));
    EXPECT_TRUE(window.views().pane(1).header().firstLine().contains(QStringLiteral("frozen")));
    // The linked camera moves without the frozen view.
    const QImage frozen = shown(1);
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(20.0), {}));
    settle();
    EXPECT_EQ(shown(1), frozen);
    EXPECT_NE(shown(0), before[0]);
    window.actions().freeze->trigger();
    settle();
    EXPECT_EQ(session.setup(1).role, Role::Linked);
}

TEST_F(EightViews, anotherLayoutKeepsWhatAFrozenViewCulls) {
    open(kObjects);
    session.slot(0).choose("frustum");
    session.setActiveView(0);
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.3, 1.0));
    settle();
    session.setFrozen(0, true);
    settle();
    const ViewMetrics before = session.figures(0);
    ASSERT_LT(before.consideredTriangles, before.sceneTriangles);
    for (const int count : {1, 8, 2}) {
        session.setViewCount(count);
        window.resize(1366, count == 8 ? 700 : 768);
        settle();
        EXPECT_EQ(session.figures(0).consideredTriangles, before.consideredTriangles) << count;
        EXPECT_EQ(session.figures(0).accuracy.coveredPixels, before.accuracy.coveredPixels) << count;
        EXPECT_EQ(session.figures(0).frameMilliseconds, before.frameMilliseconds) << "measured anew";
        EXPECT_EQ(session.viewRequest(0)->cullingSize, before.size) << count;
    }
}

TEST_F(EightViews, aWatchedViewThatIsNotShownKeepsItsShape) {
    open(kObjects);
    session.slot(0).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.3, 1.0));
    session.observe(1, 0);
    settle();
    const uint64_t before = session.figures(1).consideredTriangles;
    session.setActiveView(1);
    session.setViewCount(1);
    settle();
    EXPECT_EQ(session.figures(1).consideredTriangles, before);
}

TEST_F(EightViews, whatAFrozenFrustumLeftOutIsAHole) {
    open(kObjects);
    session.setActiveView(0);
    session.slot(0).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.25, 1.0));
    settle();
    ASSERT_LT(session.figures(0).consideredTriangles, session.figures(0).sceneTriangles);
    session.setFrozen(0, true);
    session.setViewingCamera(0, framed(session.viewingCamera(0), UpAxis::Y, session.scene()->boundingSphere(), 4.0 / 3.0));
    settle();
    const QImage holes = shown(0);
    const uint64_t before = session.picture(0)->consideredTriangles;
    session.setFrozen(0, false);
    session.setCamera(framed(session.camera(), UpAxis::Y, session.scene()->boundingSphere(), 4.0 / 3.0));
    settle();
    EXPECT_LT(before, session.picture(0)->consideredTriangles);
    EXPECT_NE(holes, shown(0));
}

TEST_F(EightViews, anObserverShowsTheVerdictsOfAnotherViewFromItsOwnCamera) {
    open(kObjects);
    session.slot(0).choose("frustum");
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.25, 1.0));
    session.observe(1, 0);
    ViewSetup setup = session.setup(1);
    setup.look = {"verdicts", "frustum"};
    session.setSetup(1, setup);
    settle();
    EXPECT_EQ(session.culledBy(1), 0);
    EXPECT_NE(session.viewingCamera(1).eye, session.camera().eye);
    EXPECT_EQ(session.figures(1).consideredTriangles, session.figures(0).consideredTriangles);
    ASSERT_TRUE(session.picture(1)->request.states) << "verdicts against the truth, once it is known";
    const QImage before = shown(0);
    const ViewMetrics figures = session.figures(0);
    session.setActiveView(1);
    drag(1, {80, 30}, 5);
    settle();
    EXPECT_EQ(shown(0), before) << "turning the observer moved what it watches";
    EXPECT_EQ(session.figures(0).frameMilliseconds, figures.frameMilliseconds);
}

TEST_F(EightViews, theLectureBorrowsAViewAndGivesItBack) {
    open(kScene);
    session.setActiveView(0);
    settle();
    window.actions().lecture->trigger();
    auto* lecture = window.lecture();
    ASSERT_TRUE(lecture);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(lecture, kPatience));
    EXPECT_EQ(lecture->shownView(), 0);
    for (const int alone : {0, 1}) {
        QTest::keyClick(lecture, Qt::Key_PageDown);
        EXPECT_EQ(lecture->shownView(), alone);
    }
    settle();
    QTest::keyClick(lecture, Qt::Key_B);
    EXPECT_TRUE(lecture->blank());
    QTest::keyClick(lecture, Qt::Key_B);
    EXPECT_FALSE(lecture->blank());
    QTest::keyClick(lecture, Qt::Key_Escape);
    ASSERT_TRUE(waitUntil([&] { return window.lecture() == nullptr; }));
    settle();
    EXPECT_EQ(window.views().pane(1).parentWidget(), &window.views());
    EXPECT_TRUE(window.views().pane(1).isVisible());
}

}  // namespace
}  // namespace cullscope::ui::eight_views_roles_test
