// The cells that `spherical-lossless` tested and its horizon, as lines and colours on the map.

#include "core/visibility/spherical/judged_cells.h"

#include <numbers>
#include <random>
#include <set>

#include "core/image/cell_map_picture.h"
#include "core/visibility/spherical/cell_directions.h"
#include "core/visibility/spherical/index_map.h"
#include "core/visibility/spherical/map_values.h"
#include "core/visibility/verdict_palette.h"
#include "tests/support/hand_made_map.h"
#include "tests/support/lossless_map.h"

namespace cullscope::test::judged_cells_test {
namespace {

using namespace spherical;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// ∮ cos θ dφ: minus the solid angle that a line encloses counter-clockwise on the map, also around the poles.
double solidAngleWithin(const std::vector<Vec2>& outline) {
    double sum = 0.0;
    for (size_t i = 1; i < outline.size(); ++i)
        sum += 0.5 * (std::cos(outline[i].x) + std::cos(outline[i - 1].x)) * (outline[i].y - outline[i - 1].y);
    return std::abs(sum);
}

/// The even–odd rule, for φ and for φ ± a whole turn.
bool within(const std::vector<Vec2>& outline, const Vec2& angles) {
    for (const double turn : {-kTurn, 0.0, kTurn}) {
        bool odd = false;
        for (size_t i = 1; i < outline.size(); ++i) {
            const Vec2 &a = outline[i - 1], &b = outline[i];
            const double phi = angles.y + turn;
            if ((a.y > phi) == (b.y > phi)) continue;
            odd ^= angles.x < a.x + (phi - a.y) / (b.y - a.y) * (b.x - a.x);
        }
        if (odd) return true;
    }
    return false;
}

Vec3 randomDirection(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return glm::normalize(Vec3(normal(random), normal(random), normal(random)));
}

TEST(CellOutline, isClosedAndGoesAroundItsCellsArea) {
    for (const MapLayout layout : kLayouts) {
        EXPECT_TRUE(cellOutline(layout, {0, 0, 0}).empty());
        for (uint32_t level = 1; level <= 5; ++level) {
            const uint32_t size = 1U << level, rows = layout == MapLayout::Octahedral ? size : size / 2;
            double sum = 0.0;
            for (uint32_t y = 0; y < rows; ++y)
                for (uint32_t x = 0; x < size; ++x) {
                    const std::vector<Vec2> outline = cellOutline(layout, {level, x, y});
                    ASSERT_LT(glm::distance(outline.front(), outline.back()), 1e-9);
                    const double area = solidAngle(layout, {level, x, y});
                    ASSERT_NEAR(solidAngleWithin(outline), area, 0.01 * area)
                        << mapLayoutId(layout) << level << " " << x << " " << y;
                    sum += area;
                }
            EXPECT_NEAR(sum, 2.0 * kTurn, 1e-9);
        }
    }
}

TEST(CellOutline, holdsDirectionsOfItsCellOnly) {
    std::mt19937 random(7);
    for (const MapLayout layout : kLayouts)
        for (int i = 0; i < 2000; ++i) {
            const Vec3 direction = randomDirection(random);
            const uint32_t level = 1 + uint32_t(i) % 5;
            const MapCell cell = mapCellOf(layout, direction, level);
            // Between its points the line is straight on the map: close to it both sides are accepted.
            bool close = false;
            for (int n = 0; n < 8; ++n) close |= !(mapCellOf(layout, direction + 2e-3 * randomDirection(random), level) == cell);
            if (close) continue;
            EXPECT_TRUE(within(cellOutline(layout, cell), mapAngles(direction))) << mapLayoutId(layout) << i;
            const MapCell other = mapCellOf(layout, -direction, level);
            EXPECT_FALSE(within(cellOutline(layout, other), mapAngles(direction))) << mapLayoutId(layout) << i;
        }
}

TEST(CellOutline, jumpsOnlyAlongAPole) {
    for (const MapLayout layout : kLayouts)
        for (uint32_t y = 0; y < 4; ++y)
            for (uint32_t x = 0; x < 8; ++x) {
                const std::vector<Vec2> outline = cellOutline(layout, {3, x, y});
                for (size_t i = 1; i < outline.size(); ++i) {
                    const Vec2 step = glm::abs(outline[i] - outline[i - 1]);
                    const bool atPole = std::sin(outline[i].x) < 1e-9 && std::sin(outline[i - 1].x) < 1e-9;
                    EXPECT_LT(atPole ? step.x : glm::length(step), 3.0 * kDegree) << mapLayoutId(layout) << x << " " << y;
                }
            }
}

TEST(CellOutlines, onlyLargeOnesAreThere) {
    for (const MapLayout layout : kLayouts) {
        const LosslessMap seen(starMesh(3, 20000), layout, {0.4, 0.3, 3.0});
        const std::vector<spherical::JudgedCell>& judged = seen.map().decision.walk->judged;
        EXPECT_EQ(cellOutlines(seen.map(), 0.0).size(), judged.size());
        const double least = 8.0 * kDegree;
        const std::vector<std::vector<Vec2>> outlines = cellOutlines(seen.map(), least);
        EXPECT_GT(outlines.size(), 20u);
        EXPECT_LT(outlines.size(), judged.size());
        for (const std::vector<Vec2>& outline : outlines) {
            Vec2 low(1e9), high(-1e9);
            for (const Vec2& point : outline) low = glm::min(low, point), high = glm::max(high, point);
            EXPECT_GE(high.x - low.x, least - 1e-9);
            EXPECT_GE(high.y - low.y, least - 1e-9);
        }
        EXPECT_TRUE(cellOutlines(sphereMap(), 0.0).empty());
    }
}

TEST(JudgedCellAt, isThatOfTheDirection) {
    std::mt19937 random(11);
    for (const MapLayout layout : kLayouts) {
        const LosslessMap seen(starMesh(3, 20000), layout, {0.4, 0.3, 3.0});
        for (int i = 0; i < 500; ++i) {
            const Vec3 direction = randomDirection(random);
            const spherical::JudgedCell* judged = judgedCellAt(seen.map(), direction);
            ASSERT_EQ(judged == nullptr, seen.map().tree->leafAt(direction) == nullptr);
            if (judged == nullptr) continue;
            const MapCell cell = seen.map().tree->nodes()[judged->node].cell();
            EXPECT_EQ(mapCellOf(layout, direction, cell.level), cell);
        }
    }
}

TEST(HorizonLine, liesWhereTheSlopeIsLargest) {
    const Vec3 eye(0.5, 0.4, 2.5);
    for (const MeshPointer& mesh : {sphereMesh(20000), starMesh(3, 20000)}) {
        const LosslessMap seen(mesh, MapLayout::Octahedral, eye);
        const spherical::MapSnapshot& map = seen.map();
        const double distance = glm::length(map.decision.eye);
        const Vec3 axis = map.decision.eye / distance;
        const auto slope = [&](double radius, double alpha) {
            return radius * std::sin(alpha) / (distance - radius * std::cos(alpha));
        };
        ASSERT_GT(map.decision.walk->outline.size(), 12u);
        for (const Vec3& point : map.decision.walk->outline) {
            const double along = glm::dot(point, axis), across = glm::length(point - along * axis);
            const Vec3 aside = (point - along * axis) / across;
            for (double alpha = 20.0 * kDegree; alpha < 150.0 * kDegree; alpha += kDegree) {
                const Vec3 direction = std::cos(alpha) * axis + std::sin(alpha) * aside;
                // The bands are some degrees apart, hence the factor.
                EXPECT_LE(slope(map.kernel->radiusAround(direction), alpha), 1.1 * across / (distance - along));
            }
        }
    }
}

TEST(HorizonLine, followsTheOutlineAndCloses) {
    for (const Vec3& eye : {Vec3(0.05, 0.02, 3.0), Vec3(-3.0, 0.1, 0.2), Vec3(3.0, -0.1, 0.1), Vec3(0.1, 0.1, -3.0)}) {
        const LosslessMap seen(sphereMesh(20000), MapLayout::Octahedral, eye);
        const std::vector<Vec2> line = horizonLine(seen.map());
        ASSERT_FALSE(line.empty());
        // The outline of a ball is a circle; around a pole φ changes by a whole turn.
        const Vec3 axis = glm::normalize(seen.map().decision.eye);
        for (size_t i = 1; i < line.size(); ++i) {
            EXPECT_LT(glm::distance(line[i], line[i - 1]), 4.0 * kDegree);
            const double alpha = std::acos(glm::dot(axis, directionOf(line[i].x / kDegree, line[i].y / kDegree)));
            EXPECT_NEAR(alpha, std::acos(1.0 / 3.0), 8.0 * kDegree);
        }
        EXPECT_NEAR(line.back().x, line.front().x, 1e-9);
        EXPECT_NEAR(std::abs(line.back().y - line.front().y), std::abs(eye.z) > 2.0 ? kTurn : 0.0, 1e-9);
    }
    EXPECT_TRUE(horizonLine(LosslessMap(sphereMesh(20000), MapLayout::Octahedral, {0, 0, 0.3}).map()).empty()) << "from within";
    EXPECT_TRUE(horizonLine(sphereMap()).empty());
}

TEST(CellValues, levelIsThatOfTheWalk) {
    for (const MapLayout layout : kLayouts)
        for (const Vec3& target : {Vec3(0.0), Vec3(0.4, 0.3, 6.0)}) {
            const LosslessMap seen(starMesh(3, 20000), layout, {0.4, 0.3, 3.0}, target);
            const spherical::MapSnapshot& map = seen.map();
            const MapValues shares = cellValues(map, MapQuantity::Level);
            EXPECT_EQ(shares.least, Term::count(0));
            EXPECT_LE(shares.most.number, map.tree->deepestLevel());
            const SphericalGrid& grid = map.maps->grid();
            const spherical::CellDirections directions(grid);
            std::set<uint32_t> levels;
            for (uint32_t cell = 0; cell < grid.cellCount(); ++cell) {
                const Vec3 middle = directions.middle(grid.cell(cell));
                const CellTree::Node* node = map.tree->leafAt(middle);
                if (const spherical::JudgedCell* judged = judgedCellAt(map, middle)) node = &map.tree->nodes()[judged->node];
                if (node == nullptr) {
                    ASSERT_LT(shares.shares[cell], 0.0f);
                    continue;
                }
                ASSERT_NEAR(shares.shares[cell] * shares.most.number, node->level, 1e-4);
                levels.insert(node->level);
            }
            EXPECT_GT(levels.size(), 1u);
        }
}

TEST(CellValues, kernelIsFilledToThere) {
    const LosslessMap seen(starMesh(3, 20000), MapLayout::Octahedral, {0.4, 0.3, 3.0});
    const spherical::MapSnapshot& map = seen.map();
    ASSERT_TRUE(hasQuantity(map, MapQuantity::Kernel));
    const MapValues shares = cellValues(map, MapQuantity::Kernel);
    EXPECT_EQ(shares.most, Term::share(1.0)) << "of the sphere's radius";
    const double radius = map.maps.sphere().radius;
    const spherical::CellDirections directions(map.maps->grid());
    for (uint32_t cell = 0; cell < shares.shares.size(); cell += 7) {
        const Vec3 middle = directions.middle(map.maps->grid().cell(cell));
        ASSERT_NEAR(shares.shares[cell] * radius, map.kernel->radius(octahedralCell(middle, map.kernel->level())), 1e-5);
    }
}

TEST(CellValues, missingStructureHasNoColours) {
    // The knot's centre lies outside it; the maps of the paper's strategy have no quadtree.
    const LosslessMap knot(knotMesh(20000), MapLayout::Octahedral, {0.4, 0.3, 3.0});
    EXPECT_TRUE(hasQuantity(knot.map(), MapQuantity::Level));
    EXPECT_FALSE(hasQuantity(knot.map(), MapQuantity::Kernel));
    EXPECT_FALSE(hasQuantity(sphereMap(), MapQuantity::Level));
    EXPECT_TRUE(hasQuantity(sphereMap(), MapQuantity::State));
    for (const float share : cellValues(knot.map(), MapQuantity::Kernel).shares) ASSERT_LT(share, 0.0f);
    for (const float share : cellValues(sphereMap(), MapQuantity::Level).shares) ASSERT_LT(share, 0.0f);
}

TEST(CellColours, judgedCellHasTheColourOfItsState) {
    const DrawStyle style{Vec3f(1.0f)};
    const auto palette = verdictPalette(style.background);
    const LosslessMap seen(starMesh(3, 2400), MapLayout::Octahedral, {0.4, 0.3, 3.0}, {0.5, 0.0, 0.0}, 25.0);
    const spherical::MapSnapshot& map = seen.map();
    const std::vector<Vec3f> colours = cellColours(*indexMap(map, "object", 1), "state", style.background);
    const std::vector<spherical::CellState> states = spherical::cellStates(map);
    const spherical::CellDirections directions(map.maps->grid());
    std::set<size_t> shown;
    for (uint32_t cell = 0; cell < colours.size(); ++cell) {
        if (states[cell] != spherical::CellState::Empty) continue;
        const auto [row, column] = map.maps->grid().cell(cell);
        const spherical::JudgedCell* judged =
            judgedCellAt(map, directionOf(0.5 * (map.maps->grid().thetaOf(row) + map.maps->grid().thetaOf(row + 1)) / kDegree,
                                          0.5 * (map.maps->grid().phiOf(column) + map.maps->grid().phiOf(column + 1)) / kDegree));
        if (judged == nullptr) continue;
        const size_t state = size_t(judged->cause ? stateOfCause(*judged->cause) : TriangleState::Visible);
        ASSERT_EQ(colours[cell], palette[state].colour) << cell;
        shown.insert(state);
    }
    for (const TriangleState state : {TriangleState::Visible, TriangleState::OutsideFrustum, TriangleState::BackFacing})
        EXPECT_EQ(shown.count(size_t(state)), 1u) << triangleStateName(state);
}

TEST(MapPicture, horizonAndBordersOfCellsAreDrawn) {
    const DrawStyle style{Vec3f(1.0f)};
    constexpr Viewport kSize{748, 388};  // the margin of 14 leaves two pixels for each degree
    const LosslessMap seen(sphereMesh(20000), MapLayout::LatitudeLongitude, {0.4, 0.3, 3.0});
    const std::vector<uint8_t> rgba = cellMapPicture(*indexMap(seen.map(), "object", 1), "kernel", kSize, style);
    const auto at = [&](const Vec2& angles) {
        const int x = 14 + int(2.0 * angles.y / kDegree), y = 14 + int(2.0 * angles.x / kDegree);
        const uint8_t* pixel = &rgba[4 * (size_t(kSize.height - 1 - y) * size_t(kSize.width) + size_t(x))];
        return Vec3f(pixel[0], pixel[1], pixel[2]) / 255.0f;
    };
    for (const Vec2& point : horizonLine(seen.map())) {
        const double phi = std::fmod(point.y + kTurn, kTurn);
        if (phi < kDegree || phi > kTurn - kDegree) continue;
        EXPECT_GT(at({point.x, phi}).x, at({point.x, phi}).z + 0.3f) << point.x << " " << phi;
    }
    size_t borders = 0;
    for (const std::vector<Vec2>& outline : cellOutlines(seen.map(), 6.0 * kDegree)) {
        const Vec2 middle = 0.5 * (outline[0] + outline[outline.size() / 2]), side(middle.x, outline[0].y);
        if (side.y < kDegree) continue;
        const Vec3f snapshot = at(middle), left = at(side), before = at(side - Vec2(0.0, 0.5 * kDegree));
        borders += std::max(left.x, before.x) > snapshot.x + 0.2f ? 1 : 0;
    }
    EXPECT_GT(borders, 50u);
}

}  // namespace
}  // namespace cullscope::test::judged_cells_test
