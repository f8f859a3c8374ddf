#include "core/visibility/plane_distances.h"

#include <gtest/gtest.h>

#include "core/mesh/parametric.h"
#include "core/visibility/registry.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::plane_distances_test {
namespace {

TEST(PlaneDistances, planesLieAsFrustumTestedThem) {
    std::vector<Mat4> places;
    for (int x = -4; x <= 4; ++x)
        for (int z = -4; z <= 4; ++z) places.push_back(translation(Vec3(x, 0.3 * z, z) * 2.5));
    const ScenePointer scene = copiesOf(sphereMesh(80), places);
    const View view({{1, 2, 4}, {0, 0, -3}, {0, 1, 0}, Angle::fromDegrees(45), 0.5, 9}, {320, 240});
    const StrategyPointer strategy = makeStrategy("frustum");
    strategy->build(*scene);
    Trace trace;
    (void)strategy->cull(view, &trace);
    size_t outside = 0, tests = 0;
    for (const TraceEvent& event : trace.events) {
        if (event.kind != TraceEvent::Kind::TestedPlane) continue;
        const std::vector<PlaneDistance> distances = planeDistances(*scene, view, event.instance);
        ASSERT_EQ(distances.size(), 6u);
        const PlaneDistance& one = distances[size_t(event.plane)];
        EXPECT_EQ(one.plane, event.plane);
        EXPECT_NEAR(one.distance, event.distance, 1e-9);
        // The batch test's bound uses the 1-norm instead of the length.
        EXPECT_LE(one.bound, event.bound);
        EXPECT_GE(one.bound, 0.5 * event.bound);
        EXPECT_EQ(one.containment, event.containment);
        ++tests;
        outside += one.containment == Containment::Outside ? 1 : 0;
    }
    EXPECT_GT(outside, 10u);
    EXPECT_GT(tests, outside);
}

}  // namespace
}  // namespace cullscope::test::plane_distances_test
