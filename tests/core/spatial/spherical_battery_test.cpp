// Cases 6 to 11 and 15 of the battery of extreme cases.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "core/mesh/parametric.h"
#include "core/spatial/spherical_search.h"
#include "core/spatial/spherical_triangle.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::spherical_battery_test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Vec3 direction(double zenith, double azimuth) {
    return {std::sin(zenith * kDegree) * std::cos(azimuth * kDegree), std::sin(zenith * kDegree) * std::sin(azimuth * kDegree),
            std::cos(zenith * kDegree)};
}

std::set<uint32_t> columnsOf(const SphericalTriangle& triangle, uint32_t row) {
    std::set<uint32_t> columns;
    triangle.forEachCell(SphericalGrid(), [&](const SphericalGrid::Cell& cell) {
        if (cell.row == row) columns.insert(cell.column);
    });
    return columns;
}

TEST(SphericalBattery, case6TriangleOverTheSeamTouchesBothItsSides) {
    const std::array<Vec3, 3> corners{direction(89.2, 359.5), direction(89.5, 0.2), direction(89.8, 0.5)};
    EXPECT_THAT(columnsOf({corners[0], corners[1], corners[2]}, 89), testing::ElementsAre(0u, 359u));
    const SphericalPoint centroid = sphericalPoint((corners[0] + corners[1] + corners[2]) / 3.0);
    EXPECT_NEAR(centroid.phi / kDegree, 0.0667, 1e-3);
}

TEST(SphericalBattery, case7TriangleOverThePoleTouchesEveryColumn) {
    const SphericalTriangle triangle(direction(1, 0), direction(1, 120), direction(1, 240));
    EXPECT_EQ(columnsOf(triangle, 0).size(), 360u);
}

TEST(SphericalBattery, cases8To10AnglesAreRight) {
    EXPECT_NEAR(sphericalPoint({-1, -1, 0}).phi / kDegree, 225.0, 1e-12);
    EXPECT_NEAR(sphericalPoint({0, 1, 0}).phi / kDegree, 90.0, 1e-12);
    EXPECT_THAT(SphericalGrid().cellOf({1, -1e-17, 0}).column, testing::AnyOf(0u, 359u));
    EXPECT_NEAR(sphericalPoint({1e-9, 0, 1}).theta / kDegree, 5.7296e-8, 1e-11);
}

TEST(SphericalBattery, case11CornerAndCentroidAtTheCentreAreFound) {
    // The bounding sphere is that of the first triangle; the second has a corner at its centre, the third its centroid.
    const MeshPointer mesh = meshOf({{1, 0, 0},
                                     {-1, 0, 0},
                                     {0, 1, 0},
                                     {0, 0, 0},
                                     {0.5f, 0, 0},
                                     {0, 0.5f, 0},
                                     {0.25f, 0, 0},
                                     {-0.125f, 0.25f, 0},
                                     {-0.125f, -0.25f, 0}},
                                    {0, 1, 2, 3, 4, 5, 6, 7, 8});
    const SphericalMaps maps(mesh, SphericalGrid(36, 18));
    ASSERT_LT(glm::length(maps.sphere().centre), 1e-6);
    std::array<int, 3> owned{};
    for (uint32_t cell = 0; cell < maps.grid().cellCount(); ++cell) {
        for (const uint32_t triangle : maps.centroids(cell)) ++owned[triangle];
        if (!maps.extent(cell).empty()) {
            EXPECT_TRUE(std::isfinite(maps.extent(cell).nearest) && std::isfinite(maps.extent(cell).farthest));
        }
    }
    EXPECT_THAT(owned, testing::Each(1));
    // They must be candidates in every direction: rays from all sides hit them.
    for (int i = 0; i < 36; ++i) {
        const Vec3 eye = 3.0 * direction(20.0, 10.0 * i + 1.0);
        EXPECT_TRUE(searchTriangle(maps, {eye, Vec3(0.1, 0.1, 0.0) - eye})) << i;
        EXPECT_TRUE(searchTriangle(maps, {eye, Vec3(-0.05, 0.02, 0.0) - eye})) << i;
    }
}

TEST(SphericalBattery, case15RayOfImpactIsWalkedToTheSurface) {
    // A ball of radius 0.5, and two distant points that give the bounding sphere a radius of 1.
    const MeshPointer ball = sphereMesh(80'000);
    std::vector<Vec3f> positions;
    for (const Vec3f& position : ball->positions()) positions.push_back(0.5f * position);
    std::vector<uint32_t> indices(ball->indices().begin(), ball->indices().end());
    for (const float side : {1.0f, -1.0f}) {
        const auto base = uint32_t(positions.size());
        positions.insert(positions.end(), {{0, 0, side}, {0.001f, 0, 0.999f * side}, {0, 0.001f, 0.999f * side}});
        indices.insert(indices.end(), {base, base + 1, base + 2});
    }
    const SphericalMaps maps(meshOf(positions, indices), SphericalGrid());
    ASSERT_NEAR(maps.sphere().radius, 1.0, 1e-3);
    const Ray ray{{-3, 0.45, 0}, {1, 0, 0}};
    std::vector<WalkedCell> walked;
    const auto hit = searchTriangle(maps, ray, [&](const WalkedCell& cell) { walked.push_back(cell); });
    ASSERT_TRUE(hit);
    const Vec3 entry = ray.at(throughSphere(ray, maps.sphere().radius)->from), surface = ray.at(hit->t);
    EXPECT_NEAR(glm::length(surface), 0.5, 1e-3);
    EXPECT_NEAR(std::acos(glm::dot(glm::normalize(entry), glm::normalize(surface))) / kDegree, 37.4, 1.0);
    EXPECT_GT(walked.size(), 30u);
}

}  // namespace
}  // namespace cullscope::test::spherical_battery_test
