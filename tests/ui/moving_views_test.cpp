// While the user moves a camera, pictures of a large scene are coarse and say so; at rest they are whole, and figures are of
// those.
#include "ui/session/moving_views.h"

#include <gtest/gtest.h>

#include <QMouseEvent>
#include <future>

#include "core/scene/camera_moves.h"
#include "tests/ui/eight_views.h"

namespace cullscope::ui::moving_views_test {
namespace {

struct Moving : EightViews {
    /// Larger than what follows as it is.
    static inline const QString kLarge = QStringLiteral("field:mesh=sphere:triangles=20000,n=5");

    void openLarge() {
        open(kLarge);
        ASSERT_GE(session.scene()->triangleCount(), MovingViews::kLarge);
        ASSERT_TRUE(waitUntil([&] { return session.moving()->coarse() != nullptr; }));
        // On any machine a whole picture takes too long.
        ViewPicture slow;
        slow.milliseconds = 1000.0;
        for (const int view : session.shownViews()) session.moving()->made(view, slow);
    }
    /// Moves the camera by the user's hand, and returns the picture of it.
    ViewPicturePointer moved(double degrees) {
        session.moveViewingCamera(0, turned(session.camera(), UpAxis::Y, Angle::fromDegrees(degrees), {}));
        // The hand goes on moving until the picture is there.
        EXPECT_TRUE(waitUntil([&] {
            session.moving()->move();
            return session.picture(0)->request.viewing == session.camera();
        }));
        return session.picture(0);
    }
};

TEST_F(Moving, aLargeSceneIsCoarseWhileItMovesAndWholeAfterwards) {
    openLarge();
    for (const char* id : {"frustum", "backface", "spherical"}) {
        session.slot(0).choose(id);
        settle();
        ViewPicture slow;
        slow.milliseconds = 1000.0;
        for (const int view : session.shownViews()) session.moving()->made(view, slow);
        const ViewPicturePointer coarse = moved(7.0);
        ASSERT_TRUE(coarse->request.coarse) << id;
        const Scene& few = *coarse->request.coarse->objects;
        EXPECT_EQ(few.instances().size(), session.scene()->instances().size());
        EXPECT_LE(few.triangleCount(), 2 * MovingViews::kCoarseTriangles);
        EXPECT_TRUE(window.views().pane(0).chipText().startsWith(QStringLiteral("coarse while it moves")))
            << window.views().pane(0).chipText().toStdString();
        EXPECT_NE(session.figures(0).state, ViewMetrics::State::Ready) << "no figure is that of a coarse picture";
        EXPECT_FALSE(picture(0).pictureIsCurrent());
        settle();
        ASSERT_TRUE(waitUntil([&] { return picture(0).pictureIsCurrent(); }));
        const ViewPicturePointer whole = session.picture(0);
        EXPECT_FALSE(whole->request.coarse);
        EXPECT_FALSE(window.views().pane(0).chipText().contains(QStringLiteral("coarse")));
        // The coarse picture resembles the whole one.
        size_t either = 0, both = 0;
        for (size_t i = 0; i < whole->depth.size(); ++i) {
            either += whole->depth[i] > 0.0f || coarse->depth[i] > 0.0f ? 1 : 0;
            both += whole->depth[i] > 0.0f && coarse->depth[i] > 0.0f ? 1 : 0;
        }
        EXPECT_GT(either, 1000u);
        EXPECT_GT(double(both), 0.8 * double(either)) << id;
    }
}

TEST_F(Moving, anObserverIsCoarseTooAndShowsWhatIsLeftOut) {
    openLarge();
    session.slot(0).choose("frustum");
    session.observe(1, 0);
    ViewSetup setup = session.setup(1);
    setup.look.watch();
    session.setSetup(1, setup);
    session.setCamera(zoomed(session.camera(), session.camera().target, 0.2, 1.0));
    settle();
    ViewPicture slow;
    slow.milliseconds = 1000.0;
    session.moving()->made(0, slow);
    session.moveViewingCamera(1, turned(session.viewingCamera(1), UpAxis::Y, Angle::fromDegrees(20.0), {}));
    ASSERT_TRUE(waitUntil([&] {
        session.moving()->move();
        return session.picture(1)->request.viewing == session.viewingCamera(1);
    }));
    const ViewPicturePointer coarse = session.picture(1);
    ASSERT_TRUE(coarse->request.coarse);
    ASSERT_TRUE(waitUntil([&] { return !session.moving()->moving(); }));
    settle();
    const ViewPicturePointer whole = session.picture(1);
    ASSERT_FALSE(whole->request.coarse);
    EXPECT_TRUE(coarse->frame->request.sameFrame(whole->frame->request));
    const auto pixels = [&](const ViewPicture& shown, TriangleState state) {
        const Vec3f colour = verdictPalette(shown.request.style.background)[size_t(state)].colour;
        size_t count = 0;
        for (int y = 0; y < shown.colour.height(); ++y)
            for (int x = 0; x < shown.colour.width(); ++x) {
                const QColor at = shown.colour.pixelColor(x, y);
                const Vec3f way = Vec3f(float(at.redF()), float(at.greenF()), float(at.blueF())) - colour;
                count += glm::length(way) < 0.2f ? 1 : 0;
            }
        return count;
    };
    EXPECT_GT(pixels(*coarse, TriangleState::Visible), 50u);
    EXPECT_GT(pixels(*coarse, TriangleState::OutsideFrustum), 50u);
}

TEST_F(Moving, aWholePictureUnderWayEndsWhereTheHandMovesAndIsDrawnAfterwards) {
    openLarge();
    session.setViewCount(2);
    settle();
    ViewPicture slow;
    slow.milliseconds = 1000.0;
    for (const int view : session.shownViews()) session.moving()->made(view, slow);
    // The GPU thread waits, so that whole pictures are still to be drawn when the hand moves.
    std::promise<void> released;
    session.gpu()->post([waits = released.get_future().share()] { waits.wait(); }, Urgency::Picture);
    DrawStyle style = session.drawStyle();
    style.background.x += 0.1f;
    session.setDrawStyle(style);
    QApplication::processEvents();
    ASSERT_TRUE(session.pictures()->busy());
    std::vector<bool> coarse;
    const auto seen = QObject::connect(&session, &Session::pictureChanged,
                                       [&](int view) { coarse.push_back(session.picture(view)->request.coarse != nullptr); });
    session.moveViewingCamera(0, turned(session.camera(), UpAxis::Y, Angle::fromDegrees(5.0), {}));
    QApplication::processEvents();
    released.set_value();
    ASSERT_TRUE(waitUntil([&] {
        session.moving()->move();
        return !coarse.empty();
    }));
    EXPECT_TRUE(coarse.front()) << "a whole picture was in the way of the one that follows the hand";
    settle();
    ASSERT_TRUE(waitUntil([&] { return picture(0).pictureIsCurrent() && picture(1).pictureIsCurrent(); }));
    QObject::disconnect(seen);
    for (const int view : session.shownViews()) {
        EXPECT_FALSE(session.picture(view)->request.coarse) << view;
        EXPECT_EQ(session.picture(view)->request.style, style) << view;
    }
}

TEST_F(Moving, whatTheProgramMovesIsWhole) {
    openLarge();
    session.setCamera(turned(session.camera(), UpAxis::Y, Angle::fromDegrees(9.0), {}));
    const auto seen = QObject::connect(&session, &Session::pictureChanged, [&](int view) {
        EXPECT_FALSE(session.picture(view)->request.coarse) << "as a path that is played";
    });
    settle();
    QObject::disconnect(seen);
}

TEST_F(Moving, aSmallSceneFollowsAsItIs) {
    open(kScene);
    EXPECT_FALSE(session.moving()->coarse());
    ViewPicture slow;
    slow.milliseconds = 1000.0;
    session.moving()->made(0, slow);
    EXPECT_FALSE(moved(5.0)->request.coarse);
}

TEST_F(Moving, aScreenshotTakenMeanwhileIsWhole) {
    openLarge();
    ASSERT_TRUE(moved(4.0)->request.coarse);
    session.moving()->move();
    EXPECT_FALSE(session.viewRequest(0)->coarse);
}

}  // namespace
}  // namespace cullscope::ui::moving_views_test
