// The exact predicates against determinants of integers, which __int128 holds without rounding.
#include "core/geometry/predicates.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/geometry/random.h"

namespace cullscope::test::predicates_test {
namespace {

__extension__ using Whole = __int128;
using Point = std::array<int64_t, 3>;

int exactSign(Whole value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

int side(const Point& a, const Point& b, const Point& c, const Point& p) {
    const auto d = [&](const Point& q, size_t axis) { return Whole(q[axis]) - a[axis]; };
    Whole sum = 0;
    for (size_t x = 0; x < 3; ++x) {
        const size_t y = (x + 1) % 3, z = (x + 2) % 3;
        sum += (d(b, y) * d(c, z) - d(b, z) * d(c, y)) * d(p, x);
    }
    return exactSign(sum);
}

Vec3 real(const Point& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

TEST(Predicates, sideOfPlaneIsThatOfWholeNumbers) {
    Random random(3);
    std::array<int, 3> seen{};
    // Coordinates of 39 bits: the determinant has 122, far more than a double holds. Half of the points lie within a unit of the
    // plane, where the filter cannot decide.
    for (int i = 0; i < 40'000; ++i) {
        const auto any = [&](int bits) { return int64_t(random.bits() >> (64 - bits)) - (int64_t(1) << (bits - 1)); };
        Point a, b, c, p;
        for (size_t axis = 0; axis < 3; ++axis) {
            a[axis] = any(38);
            b[axis] = any(38);
            c[axis] = any(38);
            p[axis] = any(38);
        }
        if (i % 2 == 0)
            for (size_t axis = 0; axis < 3; ++axis) p[axis] = b[axis] - (a[axis] - c[axis]) + (i % 4 == 0 ? 0 : any(2));
        const int expected = side(a, b, c, p);
        ASSERT_EQ(sideOfPlane(real(a), real(b), real(c), real(p)), expected) << i;
        ASSERT_EQ(sideOfPlane(real(b), real(a), real(c), real(p)), -expected) << i;
        ++seen[size_t(expected + 1)];
    }
    for (const int count : seen) EXPECT_GT(count, 5'000);
}

TEST(Predicates, sideIsExactWhereDifferencesAreRounded) {
    // 1e16 − 1 cannot be represented beside 1: the difference of the coordinates is rounded, the predicate is not.
    const Vec3 a(1e16, 0, 0), b(1e16, 1, 0), c(1e16, 0, 1);
    EXPECT_EQ(sideOfPlane(a, b, c, {1e16, 0.3, 0.7}), 0);
    EXPECT_EQ(sideOfPlane(a, b, c, {std::nextafter(1e16, 2e16), 0.3, 0.7}), 1);
    const Vec3 o(0.1, 0.1, 0.1), u(0.3, 0.3, 0.3), v(1e-18, 1.0, 0.0);
    EXPECT_EQ(sideOfPlane(o, u, v, u), 0);
    EXPECT_EQ(sideOfPlane(o, u, v, v), 0);
    EXPECT_EQ(sideOfPlane(o, o, v, {1, 2, 3}), 0) << "no plane";
}

TEST(Predicates, turnIsThatOfWholeNumbers) {
    Random random(5);
    for (int i = 0; i < 40'000; ++i) {
        const auto any = [&] { return int64_t(random.bits() >> 12) - (int64_t(1) << 51); };
        const int64_t ax = any(), ay = any(), bx = any(), by = any();
        const int64_t cx = i % 2 == 0 ? (ax + bx) / 2 : any(), cy = i % 2 == 0 ? (ay + by) / 2 : any();
        const Whole sum = Whole(bx - ax) * (cy - ay) - Whole(by - ay) * (cx - ax);
        ASSERT_EQ(turnOf({double(ax), double(ay)}, {double(bx), double(by)}, {double(cx), double(cy)}), exactSign(sum)) << i;
    }
}

TEST(Predicates, pointsOnOneLineAreFound) {
    EXPECT_TRUE(onOneLine({1, 2, 3}, {2, 4, 6}, {4, 8, 12}));
    EXPECT_TRUE(onOneLine({1, 2, 3}, {1, 2, 3}, {4, 0, 1}));
    EXPECT_FALSE(onOneLine({1, 2, 3}, {2, 4, 6}, {4, 8, std::nextafter(12.0, 13.0)}));
}

}  // namespace
}  // namespace cullscope::test::predicates_test
