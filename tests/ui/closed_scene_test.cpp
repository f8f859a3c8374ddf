// A scene that is closed is freed, by whichever job it was measured.

#include "tests/ui/test_scene.h"

namespace cullscope::ui::closed_scene_test {
namespace {

TEST(ClosedScene, isNotKeptByTheMeterOfItsViews) {
    Session session{sessionOptions(true)};
    session.setViewport(0, {64, 48});
    session.setActiveView(0);
    session.setViewCount(1);
    openAndWait(session, QStringLiteral("sphere:triangles=320"));
    ASSERT_TRUE(waitUntil([&] { return session.figures(0).timed && session.metricsSettled(); }));
    const std::weak_ptr<const Scene> closed = session.scene();
    // Nothing is measured of the next scene, which would take the place of what was measured before.
    session.setMeasuring(false);
    openAndWait(session, QStringLiteral("knot:triangles=400"));
    EXPECT_NE(session.scene(), closed.lock());
    EXPECT_TRUE(QTest::qWaitFor([&] { return closed.expired(); }, 10'000)) << closed.use_count() << " users";
}

}  // namespace
}  // namespace cullscope::ui::closed_scene_test
