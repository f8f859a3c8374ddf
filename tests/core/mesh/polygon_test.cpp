#include "core/mesh/polygon.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace cullscope::test::polygon_test {
namespace {

double area(std::span<const Vec3> points) { return 0.5 * glm::length(doubledArea(points)); }

/// Expects every triangle to have the polygon's orientation, and all together its area.
void expectCovered(const std::vector<Vec3>& points) {
    std::vector<uint32_t> triangles;
    EXPECT_TRUE(triangulatePolygon(points, triangles, {}));
    ASSERT_EQ(triangles.size(), 3 * (points.size() - 2));
    const Vec3 normal = glm::normalize(doubledArea(points));
    double sum = 0.0;
    for (size_t i = 0; i < triangles.size(); i += 3) {
        const std::array corners{points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]};
        EXPECT_GE(glm::dot(doubledArea(corners), normal), -1e-9);
        sum += area(corners);
    }
    EXPECT_NEAR(sum, area(points), 1e-9 * area(points));
}

TEST(Polygon, starsWithRandomRadiiAreCoveredExactly) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> radius(0.1, 1.0);
    for (int corners = 4; corners < 40; ++corners) {
        std::vector<Vec3> points;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / corners;
            const double r = radius(random);
            points.push_back(Vec3(100.0 + r * std::cos(angle), 3.0 - 2.0 * r * std::cos(angle), r * std::sin(angle)));
        }
        expectCovered(points);
    }
}

TEST(Polygon, combWithManyTeethIsCovered) {
    std::vector<Vec3> points{{0, -1, 0}, {50, -1, 0}};
    for (int tooth = 50; tooth > 0; --tooth) points.insert(points.end(), {Vec3(tooth, 5, 0), Vec3(tooth - 0.5, 0, 0)});
    points.push_back(Vec3(0, 5, 0));
    expectCovered(points);
}

TEST(Polygon, cornersOnAStraightLineAreNoReasonForTrianglesWithoutArea) {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    std::vector<uint32_t> triangles;
    EXPECT_TRUE(triangulatePolygon(points, triangles, {}));
    for (size_t i = 0; i < triangles.size(); i += 3)
        EXPECT_GT(area(std::array{points[triangles[i]], points[triangles[i + 1]], points[triangles[i + 2]]}), 0.0);
}

TEST(Polygon, polygonThatCrossesItselfEndsAllTheSame) {
    const std::vector<Vec3> points{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}, {1, 3, 0}, {1, -1, 0}};
    std::vector<uint32_t> triangles;
    (void)triangulatePolygon(points, triangles, {});
    EXPECT_EQ(triangles.size(), 12U);
}

TEST(Polygon, hugeConcavePolygonIsCutAsAFanAndSaysSo) {
    std::vector<Vec3> points;
    for (size_t i = 0; i <= kLargestEarClipped; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kLargestEarClipped + 1);
        points.push_back(Vec3(std::cos(angle), std::sin(angle), 0.0) * (i % 2 == 0 ? 1.0 : 0.5));
    }
    std::vector<uint32_t> triangles;
    EXPECT_FALSE(triangulatePolygon(points, triangles, {}));
    EXPECT_EQ(triangles.size(), 3 * (points.size() - 2));
}

}  // namespace
}  // namespace cullscope::test::polygon_test
