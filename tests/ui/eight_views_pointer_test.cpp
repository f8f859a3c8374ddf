// The mouse in many views: picks, flights and drags of a wipe's line.
#include <gtest/gtest.h>

#include "tests/ui/eight_views.h"
#include "ui/session/object_pick.h"

namespace cullscope::ui::eight_views_pointer_test {
namespace {

TEST_F(EightViews, aPickIsMarkedInEveryLinkedPicture) {
    open(kObjects);
    session.setLinked(1);
    settle();
    const QImage before[2] = {picture(0).grab().toImage(), picture(1).grab().toImage()};
    QTest::mouseClick(&picture(0), Qt::LeftButton, {}, QPoint(picture(0).width() / 2, picture(0).height() / 2));
    ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
    EXPECT_EQ(window.structurePanel().tabs().currentWidget(), &window.structurePanel().why());
    for (const int view : {0, 1}) EXPECT_NE(picture(view).grab().toImage(), before[view]) << view;
    // A pick in the tree or in a list is marked too, and does not change the tab.
    window.structurePanel().tabs().setCurrentIndex(0);
    const QImage marked = picture(1).grab().toImage();
    pickObject(session, session.pick()->object == 0 ? 1 : 0);
    EXPECT_NE(picture(1).grab().toImage(), marked);
    EXPECT_EQ(window.structurePanel().tabs().currentIndex(), 0) << "walking through the tree jumped to Why at every row";
}

TEST_F(EightViews, flyingWithTheRightButtonOpensNoMenu) {
    open(kScene);
    QSignalSpy menus(&picture(0), &SceneView::menuRequested);
    const QPoint middle(picture(0).width() / 2, picture(0).height() / 2);
    picture(0).setFocus();
    const Camera before = session.camera();
    QTest::mousePress(&picture(0), Qt::RightButton, {}, middle);
    QTest::keyPress(&picture(0), Qt::Key_W);
    ASSERT_TRUE(waitUntil([&] { return !(session.camera() == before); }));
    QTest::keyRelease(&picture(0), Qt::Key_W);
    QTest::mouseRelease(&picture(0), Qt::RightButton, {}, middle);
    EXPECT_EQ(menus.count(), 0);
}

TEST_F(EightViews, aClickPicksAndADragDoesNot) {
    open(kObjects);
    session.setViewCount(2);
    QPointF middle(picture(0).width() / 2.0, picture(0).height() / 2.0);
    ASSERT_TRUE(picture(0).surfaceAt(middle));
    QTest::mouseClick(&picture(0), Qt::LeftButton, {}, middle.toPoint());
    ASSERT_TRUE(waitUntil([&] { return session.pick().has_value(); }));
    const Pick pick = *session.pick();
    EXPECT_EQ(session.opened()->scene->instanceOf(pick.triangle), pick.object);
    EXPECT_NEAR(glm::length(pick.point - *picture(0).surfaceAt(middle)), 0.0, 0.05);
    drag(0, {60, 0}, 4);
    QTest::qWait(100);
    EXPECT_EQ(session.pick(), pick);
    QTest::mouseClick(&picture(0), Qt::LeftButton, {}, QPoint(2, 2));
    EXPECT_TRUE(waitUntil([&] { return !session.pick(); })) << "a click beside the scene picks nothing";
}

TEST_F(EightViews, aWipeShowsTheTruthOnTheLeftAndItsLineIsDragged) {
    open(kScene);
    session.setLinked(1);
    session.setActiveView(0);
    window.actions().truth->trigger();
    settle();
    const ViewPicturePointer shownPicture = session.picture(0);
    ASSERT_FALSE(shownPicture->other.isNull());
    EXPECT_EQ(shownPicture->missed, session.figures(0).accuracy.missedPixels);
    const size_t drawn = picture(0).drawnPictures();
    const Camera camera = session.camera();
    drag(0, {int(-0.25 * picture(0).width()), 0}, 6);
    settle();
    EXPECT_NEAR(session.setup(0).wipe.position, 0.25, 0.01);
    EXPECT_EQ(session.camera(), camera);
    EXPECT_EQ(picture(0).drawnPictures(), drawn) << "the line moves without drawing the scene again";
}

}  // namespace
}  // namespace cullscope::ui::eight_views_pointer_test
