// The index map as plain data, and its picture.
#include "core/image/cell_map_picture.h"

#include "core/base/error.h"
#include "core/gpu/colour.h"
#include "core/visibility/spherical/index_map.h"
#include "core/visibility/spherical/map_values.h"
#include "core/visibility/verdict_palette.h"
#include "tests/support/hand_made_map.h"

namespace cullscope::test::map_picture_test {
namespace {

using namespace spherical;

const DrawStyle kLight{Vec3f(1.0f)};
constexpr Viewport kSize{748, 388};  // the margin of 14 leaves two pixels for each degree

/// Access to a picture by the degrees that it shows.
struct Shown {
    std::vector<uint8_t> rgba;

    [[nodiscard]] Vec3f at(double theta, double phi) const {
        const int x = 14 + int(2.0 * phi), y = 14 + int(2.0 * theta);
        const uint8_t* pixel = &rgba[4 * (size_t(kSize.height - 1 - y) * size_t(kSize.width) + size_t(x))];
        return Vec3f(pixel[0], pixel[1], pixel[2]) / 255.0f;
    }
    [[nodiscard]] bool near(double theta, double phi, const Vec3f& wanted, double reach) const {
        for (double dt = -reach; dt <= reach; dt += 0.5)
            for (double dp = -reach; dp <= reach; dp += 0.5)
                if (glm::distance(at(theta + dt, phi + dp), wanted) < 0.1f) return true;
        return false;
    }
};

CellMapPointer made(const spherical::MapSnapshot& map) { return indexMap(map, "object", 1); }

Shown shown(const spherical::MapSnapshot& map, const char* colouring = "entries") {
    return {cellMapPicture(*made(map), colouring, kSize, kLight)};
}

const Vec3f kRed(0.86f, 0.08f, 0.08f);

bool reddish(const Vec3f& colour) { return colour.x > 0.7f && colour.y < 0.3f && colour.z < 0.3f; }

TEST(CellColours, everyStateHasItsColour) {
    spherical::MapSnapshot map = sphereMap();
    map.decision.drawn = {{0, 900}};
    const auto palette = verdictPalette(kLight.background);
    const std::vector<spherical::CellState> states = spherical::cellStates(map);
    std::vector<Vec3f> colours = cellColours(*made(map), "state", kLight.background);
    ASSERT_EQ(colours.size(), 90u * 45u);
    size_t drawn = 0;
    for (size_t cell = 0; cell < colours.size(); ++cell) {
        const Vec3f expected = states[cell] == spherical::CellState::Empty
                                   ? kLight.background
                                   : palette[size_t(cell < 900 ? TriangleState::Visible : TriangleState::OutsideFrustum)].colour;
        ASSERT_EQ(colours[cell], expected) << cell;
        drawn += states[cell] == spherical::CellState::Drawn ? 1 : 0;
    }
    EXPECT_GT(drawn, 500u);
    map.decision.bands.emplace();
    colours = cellColours(*made(map), "state", kLight.background);
    EXPECT_EQ(colours[45 * 45], palette[size_t(TriangleState::Hidden)].colour);
}

TEST(CellColours, moreEntriesStandOutMore) {
    spherical::MapSnapshot map;
    map.maps = std::make_shared<SphericalMaps>(knotMesh(20000), SphericalGrid(90, 45));
    for (const Vec3f& background : {Vec3f(1.0f), Vec3f(0.078f, 0.09f, 0.11f)}) {
        const std::vector<Vec3f> entries = cellColours(*made(map), "entries", background);
        const std::vector<Vec3f> radii = cellColours(*made(map), "radius", background);
        const auto contrast = [&](const Vec3f& colour) {
            return std::abs(relativeLuminance(colour) - relativeLuminance(background));
        };
        size_t compared = 0;
        for (uint32_t a = 0; a < entries.size(); ++a) {
            const uint32_t b = (a + 517) % uint32_t(entries.size());
            const size_t more = map.maps->triangles(a).size(), fewer = map.maps->triangles(b).size();
            EXPECT_EQ(entries[a] == background, more == 0) << a;
            EXPECT_EQ(radii[a] == background, more == 0) << a;
            if (fewer == 0 || more < 2 * fewer) continue;
            EXPECT_GT(contrast(entries[a]), contrast(entries[b]));
            ++compared;
        }
        EXPECT_GT(compared, 50u);
    }
}

TEST(MapQuantityId, isReadBack) {
    for (const MapQuantity quantity :
         {MapQuantity::Entries, MapQuantity::Radius, MapQuantity::State, MapQuantity::Level, MapQuantity::Kernel})
        EXPECT_EQ(mapQuantityFromId(mapQuantityId(quantity)), quantity);
    EXPECT_THROW((void)mapQuantityFromId("R"), Error);
}

TEST(Contours, pointsLieAtTheirAngle) {
    for (const Vec3& axis :
         {directionOf(90, 0), directionOf(37, 200), directionOf(0, 0), directionOf(14.9, 80), directionOf(165, 3)}) {
        const spherical::ContourBands bands = *bandedMap(axis).decision.bands;
        const std::vector<CutCircle> all = cutCircles(*made(bandedMap(axis))->circles);
        ASSERT_EQ(all.size(), 11u);
        for (const CutCircle& contour : all) {
            double azimuths = 0.0;
            for (const std::vector<Vec2>& line : contour.lines)
                for (size_t i = 0; i < line.size(); ++i) {
                    ASSERT_TRUE(line[i].y >= 0.0 && line[i].y <= 2.0 * std::numbers::pi) << line[i].y;
                    const double alpha = bands.anglesOf(directionOf(line[i].x / kDegree, line[i].y / kDegree)).x;
                    ASSERT_NEAR(alpha, contour.alpha, 0.3 * kDegree);
                    const Vec2 step = i > 0 ? line[i] - line[i - 1] : Vec2(0.0);
                    ASSERT_LT(std::abs(step.x), 3 * kDegree) << "a line across the map";
                    azimuths += step.y;
                }
            // A whole turn around a pole, else none.
            const double beyondPole = std::abs(axis.z) - std::abs(std::cos(contour.alpha));
            if (std::abs(beyondPole) < 1e-9) continue;  // through the pole: both are right
            const bool aroundPole = beyondPole > 0.0;
            EXPECT_NEAR(std::abs(azimuths), aroundPole ? 2.0 * std::numbers::pi : 0.0, 1e-6) << contour.alpha / kDegree;
        }
    }
}

TEST(MapPicture, everyCellHasItsColour) {
    spherical::MapSnapshot map = sphereMap();
    map.decision.drawn = {{0, 90 * 20}};
    const Shown picture = shown(map, "state");
    const std::vector<Vec3f> colours = cellColours(*made(map), "state", kLight.background);
    for (uint32_t row = 0; row < 45; ++row)
        for (uint32_t column = 1; column < 89; ++column)
            ASSERT_LT(glm::distance(picture.at(row * 4.0 + 2.0, column * 4.0 + 2.0), colours[row * 90 + column]), 0.01f);
    EXPECT_LT(glm::distance(Vec3f(picture.rgba[0], picture.rgba[1], picture.rgba[2]) / 255.0f, kLight.background), 0.01f);
}

TEST(MapPicture, regionOverTheSeamIsDrawnOnBothSides) {
    const auto red = [](const Shown& picture, double theta, double from, double to) {
        size_t pixels = 0;
        for (double phi = from; phi < to; phi += 0.5)
            pixels += reddish(picture.at(theta, phi)) || reddish(picture.at(theta - 0.5, phi)) ? 1 : 0;
        return double(pixels) / (2.0 * (to - from));
    };
    const Shown seam = shown(cutMap(320.0, 400.0)), clump = shown(cutMap(100.0, 200.0));
    for (const double theta : {60.0, 100.0}) {
        // Dashed: about half of the pixels.
        EXPECT_NEAR(red(seam, theta, 325.0, 358.0), 0.5, 0.25);
        EXPECT_NEAR(red(seam, theta, 2.0, 35.0), 0.5, 0.25);
        EXPECT_EQ(red(seam, theta, 45.0, 315.0), 0.0);
        EXPECT_NEAR(red(clump, theta, 110.0, 190.0), 0.5, 0.25);
        EXPECT_EQ(red(clump, theta, 210.0, 358.0), 0.0);
    }
    // Between its corners, down along both sides, and not along the seam.
    EXPECT_TRUE(seam.near(80, 320, kRed, 3) && seam.near(80, 40, kRed, 3));
    EXPECT_FALSE(seam.near(80, 355, kRed, 3) || seam.near(80, 5, kRed, 3));
}

TEST(MapPicture, rayIsMarkedWhereItHits) {
    const spherical::MapSnapshot map = cutMap(100.0, 200.0);
    const Shown picture = shown(map);
    for (const auto& [theta, phi] : {std::pair(100, 100), std::pair(100, 200), std::pair(60, 200)})
        EXPECT_LT(glm::distance(picture.at(theta, phi), kRed), 0.02f) << theta << " " << phi;
    EXPECT_TRUE(picture.near(60, 100, Vec3f(0.0f), 1)) << "the ray that missed has a cross";
    EXPECT_FALSE(picture.near(60, 100, kRed, 0.5));
}

TEST(MapPicture, walkedCellsStandOut) {
    spherical::MapSnapshot map = cutMap(100.0, 200.0);
    const Shown before = shown(map);
    map.decision.rays[0].walkedCells = {{{30, 60}, {}}, {{31, 60}, {}}};
    const Shown after = shown(map);
    EXPECT_GT(glm::distance(before.at(30 * 4 + 2, 60 * 4 + 2), after.at(30 * 4 + 2, 60 * 4 + 2)), 0.1f);
    EXPECT_GT(glm::distance(before.at(31 * 4 + 2, 60 * 4 + 2), after.at(31 * 4 + 2, 60 * 4 + 2)), 0.1f);
    EXPECT_EQ(before.at(33 * 4 + 2, 60 * 4 + 2), after.at(33 * 4 + 2, 60 * 4 + 2));
}

TEST(MapPicture, everyContourIsDrawn) {
    const spherical::MapSnapshot map = bandedMap(directionOf(90, 180));
    spherical::MapSnapshot bare = map;
    bare.decision.bands.reset();
    const Shown picture = shown(map), without = shown(bare);
    const auto drawn = [&](double theta, double phi) {
        for (const double side : {-0.5, 0.0, 0.5})
            for (const Vec2& way : {Vec2(side, 0.0), Vec2(0.0, side)}) {
                const float before = relativeLuminance(without.at(theta + way.x, phi + way.y));
                const float after = relativeLuminance(picture.at(theta + way.x, phi + way.y));
                // The line is seen on light cells, its casing on dark ones.
                if (after < 0.6f * before || before < 0.6f * after) return true;
            }
        return false;
    };
    for (int band = 1; band < 12; ++band) {
        EXPECT_TRUE(drawn(90, 180 + 15 * band)) << band;
        EXPECT_TRUE(drawn(90, 180 - 15 * band)) << band;
        EXPECT_FALSE(drawn(90, 180 + 15 * band - 7.5)) << band;
    }
    for (int band = 1; band < 6; ++band) EXPECT_TRUE(drawn(90 - 15 * band, 180)) << band;
    EXPECT_EQ(picture.at(90, 180.5), Vec3f(0.0f)) << "the start's dot";
    EXPECT_TRUE(picture.near(90, 2, Vec3f(0.0f), 1)) << "the end's ring";
    EXPECT_FALSE(picture.near(90, 0.5, Vec3f(0.0f), 0.5)) << "which is open";
}

TEST(MapPicture, smallestSizesAreDrawn) {
    for (const Viewport& size : {Viewport{1, 1}, Viewport{7, 500}, Viewport{500, 3}})
        EXPECT_EQ(cellMapPicture(*made(bandedMap(directionOf(90, 180))), "radius", size, kLight).size(),
                  size_t(size.width) * size_t(size.height) * 4);
}

}  // namespace
}  // namespace cullscope::test::map_picture_test
