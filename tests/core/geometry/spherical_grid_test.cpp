#include "core/geometry/spherical_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/geometry/random.h"

namespace cullscope::spherical_grid_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(SphericalPoint, hasTheQuadrantThatTheQuotientLoses) {
    EXPECT_DOUBLE_EQ(sphericalPoint({-1.0, 0.0, 0.0}).phi, kPi);
    EXPECT_DOUBLE_EQ(sphericalPoint({0.0, -2.0, 0.0}).phi, 1.5 * kPi);
    EXPECT_DOUBLE_EQ(sphericalPoint({1.0, 0.0, -1.0}).theta, 0.75 * kPi);
    EXPECT_DOUBLE_EQ(sphericalPoint({0.0, 0.0, -3.0}).theta, kPi);
    EXPECT_DOUBLE_EQ(sphericalPoint({2.0, -3.0, 6.0}).radius, 7.0);
}

TEST(SphericalPoint, aTinyNegativeAngleIsNoWholeTurn) {
    for (const double y : {-1e-300, -1e-30, -1e-17, -0.0}) {
        const double phi = sphericalPoint({1.0, y, 0.0}).phi;
        EXPECT_GE(phi, 0.0) << y;
        EXPECT_LT(phi, 2.0 * kPi) << y;
    }
    EXPECT_EQ(SphericalGrid().cellOf({1.0, -1e-30, 0.0}).column, 0u);
    EXPECT_EQ(SphericalGrid().cellOf({1.0, -1e-6, 0.0}).column, 359u);
}

TEST(SphericalPoint, comesBackFromItsCoordinates) {
    Random random(3);
    for (int i = 0; i < 10'000; ++i) {
        const double scale = std::pow(10.0, random.between(-8.0, 8.0));
        const Vec3 p = scale * random.direction();
        const SphericalPoint s = sphericalPoint(p);
        const Vec3 back =
            s.radius * Vec3(std::sin(s.theta) * std::cos(s.phi), std::sin(s.theta) * std::sin(s.phi), std::cos(s.theta));
        EXPECT_LT(glm::length(back - p), 1e-14 * s.radius * 4) << i;
    }
}

TEST(SphericalGrid, everyDirectionLiesInTheCellThatItIsIn) {
    Random random(4);
    for (const SphericalGrid& grid : {SphericalGrid(), SphericalGrid(4, 2), SphericalGrid(7, 5)}) {
        std::vector<int> counts(grid.cellCount(), 0);
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 direction = random.direction();
            const SphericalPoint point = sphericalPoint(direction);
            const SphericalGrid::Cell cell = grid.cellOf(direction);
            EXPECT_GE(point.theta, grid.thetaOf(cell.row) - 1e-12);
            EXPECT_LE(point.theta, grid.thetaOf(cell.row + 1) + 1e-12);
            EXPECT_GE(point.phi, grid.phiOf(cell.column) - 1e-12);
            EXPECT_LE(point.phi, grid.phiOf(cell.column + 1) + 1e-12);
            EXPECT_EQ(grid.cell(grid.number(cell)), cell);
            ++counts[grid.number(cell)];
        }
        if (grid.cellCount() > 100) continue;
        for (const int count : counts) EXPECT_GT(count, 0);
    }
    EXPECT_EQ(SphericalGrid().cellOf(Vec3(0.0)), (SphericalGrid::Cell{0, 0}));
    EXPECT_EQ(SphericalGrid().cellOf({0.0, 0.0, -1.0}).row, 179u);
}

TEST(SphericalGrid, theLargestDotIsThatOfTheCellsDirections) {
    Random random(5);
    for (int i = 0; i < 2'000; ++i) {
        const uint32_t columns = 4 + uint32_t(random.between(0.0, 60.0));
        const SphericalGrid grid(columns, 2 + uint32_t(random.between(0.0, 30.0)));
        const SphericalGrid::Cell cell = grid.cellOf(random.direction());
        const double scale = std::pow(10.0, random.between(-3.0, 3.0));
        const Vec3 normal = scale * random.direction();
        const double largest = grid.largestDot(normal, cell);
        double found = -1e300;
        constexpr int kSteps = 40;
        for (int row = 0; row <= kSteps; ++row)
            for (int column = 0; column <= kSteps; ++column) {
                const double theta = std::lerp(grid.thetaOf(cell.row), grid.thetaOf(cell.row + 1), double(row) / kSteps);
                const double phi = std::lerp(grid.phiOf(cell.column), grid.phiOf(cell.column + 1), double(column) / kSteps);
                const Vec3 direction(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
                found = std::max(found, glm::dot(normal, direction));
            }
        const double length = glm::length(normal);
        EXPECT_LE(found, largest + 1e-12 * length);
        // Every direction is at most half a step from a sample in either angle.
        const double step = std::max(kPi / grid.rows(), 2.0 * kPi / grid.columns()) / kSteps;
        EXPECT_GE(found, largest - length * step * step);
    }
}

TEST(SphericalGrid, autoHasThePapersCellsForThePapersBunny) {
    const SphericalGrid paper = SphericalGrid::forTriangles(144'046);
    EXPECT_EQ(paper.columns(), 360u);
    EXPECT_EQ(paper.rows(), 180u);
    for (const size_t triangles : {size_t{10'000}, size_t{1'000'000}, size_t{10'000'000}}) {
        const double share = double(SphericalGrid::forTriangles(triangles).cellCount()) / double(triangles);
        EXPECT_NEAR(share, 64'800.0 / 144'046.0, 0.01) << triangles;
    }
    EXPECT_GE(SphericalGrid::forTriangles(1).rows(), 8u);
}

}  // namespace
}  // namespace cullscope::spherical_grid_test
