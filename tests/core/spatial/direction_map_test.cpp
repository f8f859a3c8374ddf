#include "core/spatial/direction_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <vector>

#include "core/base/error.h"
#include "core/geometry/random.h"

namespace cullscope::test::direction_map_test {
namespace {

constexpr double kSphere = 4.0 * std::numbers::pi;

class DirectionMap : public testing::TestWithParam<MapLayout> {
protected:
    /// The height of the part of the square that the map covers, from the top.
    [[nodiscard]] static double height() { return GetParam() == MapLayout::Octahedral ? 1.0 : 0.5; }
    [[nodiscard]] static uint32_t rows(uint32_t level) {
        return GetParam() == MapLayout::Octahedral || level == 0 ? 1U << level : 1U << (level - 1);
    }
};

INSTANTIATE_TEST_SUITE_P(Layouts, DirectionMap, testing::Values(MapLayout::Octahedral, MapLayout::LatitudeLongitude),
                         [](const auto& tested) { return tested.param == MapLayout::Octahedral ? "octahedral" : "latitude"; });

/// Random directions, and those on the axes, the seams, the folds and the octahedron's edges with all signs of zero.
std::vector<Vec3> allKindsOfDirections() {
    std::vector<Vec3> directions;
    constexpr std::array kComponents{-1.0, -1e-300, -0.0, 0.0, 1e-300, 1e-17, 0.5, 1.0};
    for (const double x : kComponents)
        for (const double y : kComponents)
            for (const double z : kComponents)
                if (std::abs(x) + std::abs(y) + std::abs(z) > 0.0) directions.emplace_back(x, y, z);
    Random random(3);
    for (int i = 0; i < 20'000; ++i) directions.push_back(random.direction() * random.between(1e-3, 1e3));
    return directions;
}

TEST_P(DirectionMap, placeOfACellMapsBackToIt) {
    Random random(1);
    for (uint32_t level = 0; level <= kFinestLevel; ++level)
        for (int i = 0; i < 4'000; ++i) {
            const uint32_t x = uint32_t(random.bits() % (1U << level)), y = uint32_t(random.bits() % rows(level));
            const double size = 1.0 / double(1U << level);
            const double right = random.between(0.01, 0.99), down = random.between(0.01, 0.99);
            const Vec2 place((x + right) * size, (y + down) * std::min(size, height()));
            const MapCell cell = mapCellOf(GetParam(), directionAt(GetParam(), place), level);
            ASSERT_EQ(cell, (MapCell{level, x, y})) << place.x << ' ' << place.y << " got " << cell.x << ' ' << cell.y;
        }
}

TEST_P(DirectionMap, everyDirectionIsInsideTheMapAndItsCellsNest) {
    for (const Vec3& direction : allKindsOfDirections()) {
        const MapCell finest = mapCellOf(GetParam(), direction, kFinestLevel);
        for (uint32_t level = 0; level <= kFinestLevel; ++level) {
            const MapCell cell = mapCellOf(GetParam(), direction, level);
            ASSERT_LT(cell.x, 1U << level);
            ASSERT_LT(cell.y, rows(level));
            const uint32_t finer = kFinestLevel - level;
            ASSERT_EQ(cell, (MapCell{level, finest.x >> finer, finest.y >> finer}))
                << direction.x << ' ' << direction.y << ' ' << direction.z << " at level " << level;
        }
    }
}

TEST_P(DirectionMap, everyDirectionIsNearTheMiddleOfItsFinestCell) {
    for (const Vec3& direction : allKindsOfDirections()) {
        const MapCell cell = mapCellOf(GetParam(), direction, kFinestLevel);
        const double size = 1.0 / double(1U << kFinestLevel);
        const Vec3 middle = directionAt(GetParam(), Vec2(cell.x + 0.5, cell.y + 0.5) * size);
        const double largest = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
        // A cell is at most 2π / 2^15 wide on either map, its half diagonal √½ of that.
        EXPECT_LT(glm::length(glm::normalize(direction / largest) - middle), 2.0 * std::numbers::pi * size)
            << direction.x << ' ' << direction.y << ' ' << direction.z;
    }
}

TEST_P(DirectionMap, directionsAreUnit) {
    Random random(2);
    for (int i = 0; i < 10'000; ++i) {
        const double x = random.unit();
        const double y = height() * random.unit();
        EXPECT_NEAR(glm::length(directionAt(GetParam(), {x, y})), 1.0, 1e-14);
    }
}

TEST_P(DirectionMap, solidAnglesOfALevelSumToTheSphere) {
    for (uint32_t level = 0; level <= 9; ++level) {
        double sum = 0.0;
        for (uint32_t y = 0; y < 1U << level; ++y)
            for (uint32_t x = 0; x < 1U << level; ++x) sum += solidAngle(GetParam(), {level, x, y});
        EXPECT_NEAR(sum, kSphere, 1e-9) << "level " << level;
    }
}

TEST_P(DirectionMap, solidAnglesAreTheSharesOfRandomDirections) {
    constexpr uint32_t kLevel = 3;
    constexpr int kDirections = 400'000;
    std::map<uint32_t, int> found;
    Random random(4);
    for (int i = 0; i < kDirections; ++i) {
        const MapCell cell = mapCellOf(GetParam(), random.direction(), kLevel);
        ++found[mortonCode(cell.x, cell.y)];
    }
    for (uint32_t code = 0; code < 1U << (2 * kLevel); ++code) {
        const double share = solidAngle(GetParam(), mapCell(code, kLevel)) / kSphere;
        const double deviation = std::sqrt(kDirections * share * (1.0 - share));
        EXPECT_NEAR(found[code], kDirections * share, 5.0 * deviation + 0.5) << "cell " << code;
    }
}

/// The ratio of the largest to the smallest solid angle of a level's cells.
double spreadOf(MapLayout layout, uint32_t level) {
    double largest = 0.0, smallest = kSphere;
    for (uint32_t y = 0; y < 1U << level; ++y)
        for (uint32_t x = 0; x < 1U << level; ++x) {
            const double angle = solidAngle(layout, {level, x, y});
            if (angle <= 0.0) continue;
            largest = std::max(largest, angle);
            smallest = std::min(smallest, angle);
        }
    return largest / smallest;
}

TEST(DirectionMapSpread, octahedralCellsLieWithinFivePointTwo) {
    EXPECT_LT(spreadOf(MapLayout::Octahedral, 8), 5.2);
    EXPECT_GT(spreadOf(MapLayout::Octahedral, 8), 5.0);
}

TEST(DirectionMapSpread, latitudeLongitudeHasSliversAtItsPoles) {
    // Rows of height h: sin h / (1 − cos h) = cot(h/2). 115 is the ratio for the default 180 rows, 81.5 for 128.
    EXPECT_NEAR(spreadOf(MapLayout::LatitudeLongitude, 8), 1.0 / std::tan(std::numbers::pi / 256.0), 1e-6);
    EXPECT_NEAR(1.0 / std::tan(std::numbers::pi / 360.0), 115.0, 0.5);
}

TEST(DirectionMapNeighbours, octahedralEdgesAreFoldedOntoThemselves) {
    Random random(5);
    for (int i = 0; i < 2'000; ++i) {
        const double t = random.unit();
        for (const double side : {0.0, 1.0}) {
            const Vec3 across = directionAt(MapLayout::Octahedral, {t, side});
            const Vec3 along = directionAt(MapLayout::Octahedral, {side, t});
            EXPECT_LT(glm::length(across - directionAt(MapLayout::Octahedral, {1.0 - t, side})), 1e-12) << t;
            EXPECT_LT(glm::length(along - directionAt(MapLayout::Octahedral, {side, 1.0 - t})), 1e-12) << t;
        }
    }
}

TEST(DirectionMapNeighbours, stepOverTheFoldLandsInTheCellThatFacesItThere) {
    constexpr uint32_t kLevel = 7, kLast = (1U << kLevel) - 1;
    constexpr double kSize = 1.0 / double(1U << kLevel);
    for (uint32_t x = 0; x <= kLast; ++x) {
        // At the middle of an edge of a cell of the first row, slightly on the far side: the fold lies in the plane x = 0 of the
        // lower half.
        const Vec3 here = directionAt(MapLayout::Octahedral, {(x + 0.5) * kSize, 1e-6});
        const Vec3 there(here.x, -here.y, here.z);
        EXPECT_EQ(mapCellOf(MapLayout::Octahedral, here, kLevel), (MapCell{kLevel, x, 0}));
        const MapCell mirrored = mapCellOf(MapLayout::Octahedral, there, kLevel);
        EXPECT_EQ(mirrored, (MapCell{kLevel, x, kLast}));
    }
    // Between the cells x and last − x of the first row lies the lower half-plane x = 0.
    for (uint32_t x = 0; x <= kLast; ++x) {
        const Vec3 here = directionAt(MapLayout::Octahedral, {(x + 0.5) * kSize, 1e-6});
        const MapCell mirrored = mapCellOf(MapLayout::Octahedral, Vec3(-here.x, here.y, here.z), kLevel);
        EXPECT_EQ(mirrored, (MapCell{kLevel, kLast - x, 0}));
    }
}

TEST(DirectionMapNeighbours, directionsBesideTheSeamAreInTheFirstAndTheLastColumn) {
    constexpr uint32_t kLevel = 8;
    for (const double theta : {0.1, 1.0, 2.0, 3.0})
        for (const double phi : {1e-18, 1e-9, 1e-3}) {
            const Vec3 after(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta));
            const Vec3 before(after.x, -after.y, after.z);
            EXPECT_EQ(mapCellOf(MapLayout::LatitudeLongitude, after, kLevel).x, 0U) << theta << ' ' << phi;
            const uint32_t x = mapCellOf(MapLayout::LatitudeLongitude, before, kLevel).x;
            // An angle too close to a whole turn to be distinguished may be rounded to 0.
            EXPECT_TRUE(x == (1U << kLevel) - 1 || (x == 0 && phi < 1e-15)) << theta << ' ' << phi << " gives " << x;
        }
}

TEST(DirectionMapCode, roundTripGivesTheCellBack) {
    Random random(6);
    for (uint32_t level = 0; level <= kFinestLevel; ++level)
        for (int i = 0; i < 2'000; ++i) {
            const MapCell cell{level, uint32_t(random.bits() % (1U << level)), uint32_t(random.bits() % (1U << level))};
            ASSERT_EQ(mapCell(mortonCode(cell.x, cell.y), level), cell);
        }
    EXPECT_EQ(mortonCode(0b1011, 0b0110), 0b01101101U);
}

TEST(DirectionMapCode, childrenOfACellHaveConsecutiveCodes) {
    const uint32_t code = mortonCode(5, 9);
    for (uint32_t child = 0; child < 4; ++child)
        EXPECT_EQ(mapCell(4 * code + child, 5), (MapCell{5, 10 + child % 2, 18 + child / 2}));
}

TEST(DirectionMapLayout, idsNameTheLayouts) {
    for (const MapLayout layout : {MapLayout::Octahedral, MapLayout::LatitudeLongitude})
        EXPECT_EQ(mapLayoutFromId(mapLayoutId(layout)), layout);
    EXPECT_THROW(static_cast<void>(mapLayoutFromId("mercator")), Error);
}

}  // namespace
}  // namespace cullscope::test::direction_map_test
