#include "core/geometry/random.h"

#include <cmath>

#include "core/geometry/angle.h"

namespace cullscope::random_test {
namespace {

TEST(Random, numbersAreThoseOfSplitMix64) {
    // The published first outputs of SplitMix64 for seed 0.
    Random random(0);
    EXPECT_EQ(random.bits(), 0xE220A8397B1DCDAFull);
    EXPECT_EQ(random.bits(), 0x6E789E6AA1B965F4ull);
    EXPECT_EQ(random.bits(), 0x06C45D188009454Full);
}

TEST(Random, unitStaysInItsInterval) {
    Random random(1);
    double sum = 0;
    for (int i = 0; i < 100000; ++i) {
        const double value = random.unit();
        ASSERT_GE(value, 0.0);
        ASSERT_LT(value, 1.0);
        sum += value;
    }
    EXPECT_NEAR(sum / 100000, 0.5, 0.01);
}

TEST(Random, directionsAreUnitAndEven) {
    Random random(2);
    Vec3 sum(0.0);
    Vec3 squares(0.0);
    constexpr int kCount = 100000;
    for (int i = 0; i < kCount; ++i) {
        const Vec3 direction = random.direction();
        ASSERT_NEAR(glm::length(direction), 1.0, 1e-14);
        sum += direction;
        squares += direction * direction;
    }
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(sum[axis] / kCount, 0.0, 0.01);
        EXPECT_NEAR(squares[axis] / kCount, 1.0 / 3.0, 0.01);
    }
}

TEST(Angle, degreesAndRadiansConvertIntoEachOther) {
    EXPECT_DOUBLE_EQ(Angle::fromDegrees(180).radians(), std::numbers::pi);
    EXPECT_DOUBLE_EQ(Angle::fromRadians(std::numbers::pi / 2).degrees(), 90.0);
    EXPECT_LT(Angle::fromDegrees(1), Angle::fromRadians(1));
    EXPECT_DOUBLE_EQ((Angle::fromDegrees(30) * 2 + Angle::fromDegrees(10) - Angle::fromDegrees(40) / 2).degrees(), 50.0);
}

}  // namespace
}  // namespace cullscope::random_test
