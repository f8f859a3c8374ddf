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

TEST_F(NamedViews, almostParallelKeepsTheScaleAtTheTargetAndIsTakenBack) {
    const Camera before = session.camera();
    const auto heightAtTarget = [](const Camera& camera) {
        return glm::length(camera.eye - camera.target) * std::tan(camera.fovy.radians() / 2.0);
    };
    setAlmostParallel(session, true);
    const Camera parallel = session.camera();
    EXPECT_TRUE(isAlmostParallel(parallel));
    EXPECT_FALSE(isAlmostParallel(before));
    EXPECT_NEAR(heightAtTarget(parallel), heightAtTarget(before), 1e-9 * heightAtTarget(before));
    // Sizes before and behind the target, at the ends of the scene's depth, differ by less than one per cent.
    const double distance = glm::length(parallel.eye - parallel.target), radius = session.scene()->boundingSphere().radius;
    EXPECT_LT((distance + radius) / (distance - radius), 1.01);
    EXPECT_LE(parallel.nearDistance, distance - radius);
    EXPECT_GE(parallel.farDistance, distance + radius);
    setAlmostParallel(session, false);
    EXPECT_NEAR(glm::length(session.camera().eye - before.eye), 0.0, 1e-9 * distance);
    EXPECT_DOUBLE_EQ(session.camera().fovy.degrees(), before.fovy.degrees());
}

}  // namespace
}  // namespace cullscope::ui::named_views_test
