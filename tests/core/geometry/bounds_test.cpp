#include "core/geometry/bounds.h"

#include <cmath>

#include "core/geometry/random.h"

namespace cullscope::bounds_test {
namespace {

Mat4 randomAffine(Random& random) {
    Mat4 matrix(1.0);
    for (int column = 0; column < 3; ++column)
        matrix[column] = Vec4(random.direction() * std::pow(10.0, random.between(-3, 3)), 0.0);
    matrix[3] = Vec4(random.direction() * std::pow(10.0, random.between(-3, 7)), 1.0);
    return matrix;
}

/// A transformed point, computed with 64 bits of mantissa.
std::array<long double, 3> moved(const Mat4& matrix, const Vec3& point) {
    std::array<long double, 3> result{};
    for (int row = 0; row < 3; ++row) {
        result[size_t(row)] = matrix[3][row];
        for (int axis = 0; axis < 3; ++axis)
            result[size_t(row)] += static_cast<long double>(matrix[axis][row]) * static_cast<long double>(point[axis]);
    }
    return result;
}

TEST(Box, emptyBoxHoldsNothing) {
    EXPECT_TRUE(Box3{}.empty());
    EXPECT_EQ(Box3{}.diagonal(), 0.0);
    EXPECT_TRUE(transformed(Box3{}, Mat4(2.0)).empty());
    Box3 box;
    box.add(Vec3(1, 2, 3));
    EXPECT_FALSE(box.empty());
    EXPECT_EQ(box.centre(), Vec3(1, 2, 3));
    box.add(Box3{});
    EXPECT_EQ(box.diagonal(), 0.0) << "an empty box adds nothing";
}

TEST(Box, transformedBoxHoldsEveryCorner) {
    Random random(11);
    for (int i = 0; i < 5000; ++i) {
        const Vec3 centre = random.direction() * std::pow(10.0, random.between(-3, 7));
        const Vec3 half = glm::abs(random.direction());
        const Box3 box{centre - half, centre + half};
        const Mat4 matrix = randomAffine(random);
        const Box3 result = transformed(box, matrix);
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 point((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                             (corner & 4) != 0 ? box.max.z : box.min.z);
            const auto exact = moved(matrix, point);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_LE(static_cast<long double>(result.min[axis]), exact[size_t(axis)]) << i;
                EXPECT_GE(static_cast<long double>(result.max[axis]), exact[size_t(axis)]) << i;
            }
        }
    }
}

TEST(Sphere, boundingSphereHoldsEveryPointAndIsNoLargerThanTheBoxs) {
    Random random(12);
    for (int i = 0; i < 300; ++i) {
        std::vector<Vec3f> points;
        const Vec3 stretch(random.unit() + 0.01, random.unit() + 0.01, random.unit() + 0.01);
        for (uint64_t n = 1 + random.bits() % 200; n > 0; --n) points.emplace_back(random.direction() * stretch);
        const Sphere sphere = boundingSphere(points);
        Box3 box;
        for (const Vec3f& point : points) {
            EXPECT_LE(glm::distance(Vec3(point), sphere.centre), sphere.radius);
            box.add(Vec3(point));
        }
        EXPECT_LE(sphere.radius, 0.5 * box.diagonal() * (1 + 1e-9)) << "larger than the sphere around the box";
    }
    EXPECT_EQ(boundingSphere({}).radius, 0.0);
}

TEST(Sphere, transformedSphereHoldsEveryPoint) {
    Random random(13);
    for (int i = 0; i < 2000; ++i) {
        const Sphere sphere{random.direction() * std::pow(10.0, random.between(-3, 7)), std::pow(10.0, random.between(-3, 3))};
        const Mat4 matrix = randomAffine(random);
        const Sphere result = transformed(sphere, matrix);
        for (int k = 0; k < 20; ++k) {
            const auto exact = moved(matrix, sphere.centre + random.direction() * sphere.radius);
            long double squared = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const long double difference = exact[size_t(axis)] - static_cast<long double>(result.centre[axis]);
                squared += difference * difference;
            }
            EXPECT_LE(std::sqrt(squared), static_cast<long double>(result.radius)) << i;
        }
    }
}

TEST(Sphere, rotationAndScaleKeepASphereTight) {
    const double c = std::cos(0.3);
    const double s = std::sin(0.3);
    const Mat4 matrix(Mat3(Vec3(2 * c, 2 * s, 0), Vec3(-2 * s, 2 * c, 0), Vec3(0, 0, -2)));
    EXPECT_NEAR(transformed(Sphere{{1, 1, 1}, 3.0}, matrix).radius, 6.0, 1e-12);
}

}  // namespace
}  // namespace cullscope::bounds_test
