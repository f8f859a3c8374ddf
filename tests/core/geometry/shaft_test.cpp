#include "core/geometry/shaft.h"

#include <gtest/gtest.h>

#include "core/geometry/random.h"
#include "tests/support/long_mode.h"

namespace cullscope::test::shaft_test {
namespace {

Box3 randomBox(Random& random, const Vec3& about) {
    Box3 box;
    for (int corner = 0; corner < 2; ++corner) box.add(about + 3.0 * random.unit() * random.direction());
    return box;
}

Vec3 pointIn(const Box3& box, Random& random) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    return box.min + (box.max - box.min) * Vec3(x, y, z);
}

/// How far a box reaches along a direction.
double reach(const Box3& box, const Vec3& direction) {
    return glm::dot(direction, box.centre()) + glm::dot(glm::abs(direction), box.halfExtent());
}

TEST(Shaft, isTheConvexHullOfTwoBoxes) {
    Random random(1);
    for (uint64_t round = 0; round < howMany(3000, 400); ++round) {
        const Vec3 about = round % 4 == 0 ? Vec3(1e6, -1e6, 3e5) : Vec3(0.0);
        const Box3 a = randomBox(random, about), b = randomBox(random, about + 6.0 * random.unit() * random.direction());
        const Shaft shaft(a, b);
        for (int i = 0; i < 20; ++i) {
            const Vec3 from = pointIn(a, random), to = pointIn(b, random), on = glm::mix(from, to, random.unit());
            ASSERT_TRUE(shaft.mayMeet(on, on)) << "round " << round;
            ASSERT_TRUE(shaft.mayMeet(on, on + 9.0 * random.direction())) << "round " << round;
        }
        // A place that a plane parts from both boxes is in no hull of them. Normals with a zero component are all that is needed.
        for (int i = 0; i < 20; ++i) {
            const Vec3 place = about + 8.0 * random.unit() * random.direction();
            bool outside = false;
            for (int turn = 0; turn < 200 && !outside; ++turn) {
                const Vec3 normal = random.direction();
                outside = glm::dot(normal, place) > std::max(reach(a, normal), reach(b, normal)) + 1e-6;
            }
            if (outside) {
                ASSERT_FALSE(shaft.mayMeet(place, place)) << "round " << round;
            }
        }
    }
}

TEST(Shaft, segmentThatPassesBesideItDoesNotMeetIt) {
    const Shaft shaft({Vec3(0.0), Vec3(1.0)}, {Vec3(9, 4, 4), Vec3(10, 5, 5)});
    EXPECT_TRUE(shaft.mayMeet({5, -9, 2.5}, {5, 9, 2.5}));
    EXPECT_FALSE(shaft.mayMeet({5, -9, 0.5}, {5, 9, 0.5}));
    EXPECT_FALSE(shaft.mayMeet({5, -9, 2.5}, {5, 1, 2.5}));
}

}  // namespace
}  // namespace cullscope::test::shaft_test
