#include "core/visibility/plane_distances.h"

#include <gtest/gtest.h>

#include <map>

#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::plane_distances_test {
namespace {

TEST(PlaneDistances, planesLieAsFrustumTestedThem) {
    std::vector<Mat4> places;
    for (int x = -4; x <= 4; ++x)
        for (int z = -4; z <= 4; ++z) places.push_back(translation(Vec3(x, 0.3 * z, z) * 2.5));
    const ScenePointer scene = copiesOf(sphereMesh(80), places);
    const View view({{1, 2, 4}, {0, 0, -3}, {0, 1, 0}, Angle::fromDegrees(45), 0.5, 9}, {320, 240});
    const CullerPointer strategy = makeCuller("frustum");
    strategy->build(*scene);
    const Culled frame = strategy->cull(view, Recording::On);
    // The tighter of the tests of sphere and box, where both were made.
    std::map<std::pair<uint32_t, FrustumPlane>, std::vector<Decision>> made;
    for (const Decision& decision : frame.log.decisions)
        if (decision.plane) made[{decision.subject.number, *decision.plane}].push_back(decision);
    size_t outside = 0, tests = 0;
    for (const auto& [subject, decisions] : made) {
        if (decisions.size() != 2) continue;
        const Decision& decision = decisions[decisions[1].distance() < decisions[0].distance() ? 1 : 0];
        const std::vector<PlaneDistance> distances = planeDistances(*scene, view, subject.first);
        ASSERT_EQ(distances.size(), 6u);
        const PlaneDistance& one = distances[size_t(subject.second)];
        EXPECT_EQ(one.plane, decision.plane);
        EXPECT_NEAR(one.distance, decision.distance(), 1e-9);
        // The batch test's bound uses the 1-norm instead of the length.
        EXPECT_LE(one.bound, decision.margin());
        EXPECT_GE(one.bound, 0.5 * decision.margin());
        EXPECT_EQ(one.containment == Containment::Outside, decision.containment == Containment::Outside);
        ++tests;
        outside += one.containment == Containment::Outside ? 1 : 0;
    }
    EXPECT_GT(outside, 10u);
    EXPECT_GT(tests, outside);
}

}  // namespace
}  // namespace cullscope::test::plane_distances_test
