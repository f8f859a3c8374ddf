#include "ui/session/named_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/ui/test_scene.h"

namespace cullscope::ui::named_views_test {
namespace {

struct NamedViews : ::testing::Test {
    void SetUp() override {
        openAndWait(session, QStringLiteral("torus:triangles=800"));
        session.setViewport(0, {400, 300});
    }

    /// From the target to the eye, of length 1.
    [[nodiscard]] Vec3 from() const { return glm::normalize(session.camera().eye - session.camera().target); }

    Session session{sessionOptions(false)};
};

TEST_F(NamedViews, lookFromTheirDirectionAtTheSameDistance) {
    const double distance = glm::length(session.camera().eye - session.camera().target);
    for (const UpAxis up : {UpAxis::Y, UpAxis::Z}) {
        session.setUpAxis(up);
        std::set<std::string> names;
        for (const NamedView& view : namedViews()) {
            SCOPED_TRACE(view.name);
            EXPECT_TRUE(names.insert(view.name).second);
            lookFrom(session, view);
            // Straight from above and below it is as near to the pole as turning goes.
            EXPECT_GT(glm::dot(from(), glm::normalize(directionOf(view, up))), 0.99);
            EXPECT_NEAR(glm::length(session.camera().eye - session.camera().target), distance, 1e-9 * distance);
        }
    }
    EXPECT_EQ(directionOf(namedViews().front(), UpAxis::Z), Vec3(0, -1, 0)) << "the front is seen along +y where z points up";
    EXPECT_EQ(glm::dot(directionOf(namedViews()[4], UpAxis::Z), Vec3(0, 0, 1)), 1.0) << "from above";
}

TEST_F(NamedViews, parallelKeepsTheScaleAtTheTargetAndIsTakenBack) {
    const Camera before = session.camera();
    const double size = heightAtTarget(before);
    setProjection(session, ProjectionKind::Parallel);
    const Camera parallel = session.camera();
    EXPECT_EQ(parallel.projection, ProjectionKind::Parallel);
    EXPECT_DOUBLE_EQ(parallel.height, size);
    // The whole scene lies in the view volume.
    const Sphere around = session.scene()->boundingSphere();
    const double ahead = glm::dot(around.centre - parallel.eye, glm::normalize(parallel.target - parallel.eye));
    EXPECT_LE(parallel.nearDistance, ahead - around.radius);
    EXPECT_GE(parallel.farDistance, ahead + around.radius);
    for (const NamedView& view : namedViews()) {
        lookFrom(session, view);
        EXPECT_EQ(session.camera().projection, ProjectionKind::Parallel) << view.name;
        EXPECT_DOUBLE_EQ(session.camera().height, size) << view.name;
    }
    lookFrom(session, namedViews().front());
    setProjection(session, ProjectionKind::Perspective);
    EXPECT_EQ(session.camera().projection, ProjectionKind::Perspective);
    EXPECT_NEAR(heightAtTarget(session.camera()), size, 1e-9 * size);
    EXPECT_DOUBLE_EQ(session.camera().fovy.degrees(), before.fovy.degrees());
}

TEST_F(NamedViews, anObserverOfAParallelViewSeesAllOfItsVolumeInPerspective) {
    setProjection(session, ProjectionKind::Parallel);
    session.setViewCount(2);
    session.setViewport(1, {400, 300});
    session.observe(1, 0);
    const Camera watching = session.viewingCamera(1);
    EXPECT_EQ(watching.projection, ProjectionKind::Perspective);
    const View view(watching, {400, 300});
    for (const Vec3& corner : View(session.cullingCamera(1), {400, 300}).frustum().corners()) {
        const Vec4 clip = view.clipFromEyeRelative() * Vec4(session.camera().eye + corner - watching.eye, 1.0);
        EXPECT_GT(clip.w, 0.0);
        EXPECT_LE(std::abs(clip.x), 1.001 * clip.w);
        EXPECT_LE(std::abs(clip.y), 1.001 * clip.w);
    }
}

}  // namespace
}  // namespace cullscope::ui::named_views_test
