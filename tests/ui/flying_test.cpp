// Flying goes by the distance to what is ahead and by the user's pace; a picture with nothing in view says how to come back.
#include <QElapsedTimer>

#include "core/scene/camera_moves.h"
#include "tests/ui/shown_window.h"

namespace cullscope::ui::flying_test {
namespace {

struct Flying : Window {
    /// A camera that looks at the scene's centre from so many radii away.
    void standAway(double radii) {
        const Sphere scene = session.scene()->boundingSphere();
        Camera camera = session.camera();
        camera.target = scene.centre;
        camera.eye = scene.centre + Vec3(0.0, 0.0, radii * scene.radius);
        session.setCamera(camera);
        settle();
    }
    /// The speed of a flight straight on, in scene radii a second, from a distance so many radii away.
    double speedFrom(double radii) {
        standAway(radii);
        picture(0).setFocus();
        const Vec3 start = session.camera().eye;
        QElapsedTimer clock;
        clock.start();
        QTest::keyPress(&picture(0), Qt::Key_W);
        EXPECT_TRUE(waitUntil([&] { return session.camera().eye != start; }));
        QTest::qWait(150);
        QTest::keyRelease(&picture(0), Qt::Key_W);
        const double seconds = clock.elapsed() / 1000.0;
        const Vec3 way = session.camera().eye - start;
        EXPECT_LT(glm::dot(way, start - session.scene()->boundingSphere().centre), 0.0) << "ahead";
        return glm::length(way) / session.scene()->boundingSphere().radius / seconds;
    }
    void type(Qt::Key key) { QTest::keyClick(&picture(0), key); }
    QString chip() { return window.views().pane(0).chipText(); }
};

TEST_F(Flying, isSlowerNearWhatIsAheadAndFollowsThePaceOfTheUser) {
    // A torus seen along the plane in which it lies: its outer side is ahead.
    const double far = speedFrom(2.0), near = speedFrom(1.1);
    EXPECT_GT(far, 1.5 * near) << far << " and " << near;
    EXPECT_GT(near, 0.0);
    EXPECT_FALSE(chip().contains(QStringLiteral("flying speed")));
    for (int i = 0; i < 3; ++i) type(Qt::Key_BracketRight);
    EXPECT_DOUBLE_EQ(picture(0).pace(), 8.0);
    EXPECT_TRUE(chip().contains(QStringLiteral("flying speed × 8"))) << chip().toStdString();
    for (int i = 0; i < 6; ++i) type(Qt::Key_BracketLeft);
    EXPECT_DOUBLE_EQ(picture(0).pace(), 1.0 / 8.0);
    const double slow = speedFrom(2.0);
    EXPECT_LT(slow, 0.5 * far) << slow << " and " << far;
    for (int i = 0; i < 40; ++i) type(Qt::Key_BracketLeft);
    EXPECT_GT(picture(0).pace(), 0.0);
    for (int i = 0; i < 40; ++i) type(Qt::Key_BracketRight);
    EXPECT_LE(picture(0).pace(), 64.0);
}

TEST_F(Flying, aPictureWithNothingInViewSaysHowToComeBack) {
    standAway(3.0);
    EXPECT_FALSE(chip().contains(QStringLiteral("nothing in view")));
    Camera camera = session.camera();
    camera.target = camera.eye + (camera.eye - camera.target);
    session.setCamera(camera);
    settle();
    EXPECT_TRUE(waitUntil([&] { return chip().contains(QStringLiteral("nothing in view: Home")); })) << chip().toStdString();
    window.actions().home->trigger();
    settle();
    EXPECT_TRUE(waitUntil([&] { return !chip().contains(QStringLiteral("nothing in view")); })) << chip().toStdString();
}

}  // namespace
}  // namespace cullscope::ui::flying_test
