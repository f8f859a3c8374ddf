#include "core/scene/scene_rays.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/mesh/parametric.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::scene_rays_test {
namespace {

TEST(SceneRays, meetTheSameHoweverLongTheirDirectionIs) {
    const ScenePointer scene = sceneOf({sphereMesh(2'000)});
    const SceneRays rays(*scene, Vec3(0.0));
    const Vec3 from(0.1, 0.2, 5.0), direction(-0.3, 0.1, -4.0);
    const std::optional<SceneRays::Hit> hit = rays.firstByNumber(from, direction);
    ASSERT_TRUE(hit);
    for (const double length : {1e-30, 1e-19, 3.0, 1e19, 1e30}) {
        SCOPED_TRACE(length);
        const std::optional<SceneRays::Hit> other = rays.firstByNumber(from, length * direction);
        ASSERT_TRUE(other);
        EXPECT_EQ(other->triangle, hit->triangle);
        EXPECT_NEAR(other->distance * length, hit->distance, 1e-6 * hit->distance);
        EXPECT_TRUE(rays.first(from, length * direction, 0.0, 1.01 * other->distance));
        EXPECT_FALSE(rays.first(from, length * direction, 0.0, 0.99 * other->distance));
    }
}

}  // namespace
}  // namespace cullscope::test::scene_rays_test
