// Curves and maps of directions as plain data, of a strategy that only the tests know.

#include "core/image/cell_map_picture.h"
#include "core/mesh/parametric.h"
#include "core/visibility/built_strategy.h"
#include "core/visibility/verdict_palette.h"
#include "tests/support/directions_strategy.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::plain_data_test {
namespace {

struct PlainData : ::testing::Test {
    StructureStore structures;
    ScenePointer scene = sceneOf({sphereMesh(800)});
    RegisteredStrategy strategy = directionsStrategy();
    BuiltStrategyPointer built = buildStrategy(strategy, ParameterSet(strategy.info.parameters), scene, structures);
    View view{Camera{{0, 0, 5}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45.0), 0.1, 100.0}, {64, 48}};
    FrameLog log = built->decide(view, *built->begin(), true);
};

TEST_F(PlainData, isGivenByWhatTheStrategyDeclares) {
    EXPECT_TRUE(built->directionMap("by-direction", log));
    EXPECT_TRUE(built->curve("by-column", log, {}, {}));
    EXPECT_FALSE(built->directionMap("by-column", log));
    EXPECT_FALSE(built->directionMap("index-map", log)) << "which another strategy declares";
    EXPECT_FALSE(built->curve("band-sizes", log, {}, {}));
    const FrameLog unrecorded = built->decide(view, *built->begin(), false);
    EXPECT_FALSE(built->directionMap("by-direction", unrecorded));
}

TEST_F(PlainData, mapIsPaintedWithoutAWindow) {
    const CellMapPointer map = built->directionMap("by-direction", log);
    const DrawStyle style{Vec3f(1.0f)};
    const std::vector<uint8_t> rgba = cellMapPicture(*map, "fate", {748, 388}, style);
    // The margin of 14 leaves two pixels for each degree, cells have 45°.
    const auto at = [&](int theta, int phi) {
        const uint8_t* pixel = &rgba[4 * (size_t(388 - 1 - (14 + 2 * theta)) * 748 + size_t(14 + 2 * phi))];
        return Vec3f(pixel[0], pixel[1], pixel[2]) / 255.0f;
    };
    EXPECT_LT(glm::distance(at(22, 300), verdictPalette(style.background)[size_t(TriangleState::Visible)].colour), 0.01f);
    const auto degrees = [](double radians) { return int(radians * 180.0 / 3.14159265358979); };
    EXPECT_NE(at(degrees(1.0), degrees(2.0)), at(22, 300)) << "the mark";
    EXPECT_NE(rgba, cellMapPicture(*map, "number", {748, 388}, style));
}

TEST_F(PlainData, partOfACurveIsShownAlone) {
    const auto sum = [](const Curve& curve) {
        double all = 0.0;
        for (const CurveArea::Box& box : curve.areas.front().boxes) all += box.top;
        return all;
    };
    double parts = 0.0;
    for (uint32_t part = 1; part <= 4; ++part) {
        const std::optional<Curve> curve = built->curve("by-column", log, {}, part);
        EXPECT_EQ(curve->parts->shown, part);
        parts += sum(*curve);
    }
    EXPECT_EQ(parts, double(scene->triangleCount()));
    EXPECT_EQ(sum(*built->curve("by-column", log, {}, 0)), parts);
}

TEST(CurveIntervals, areFoundByTheirValues) {
    Curve curve;
    EXPECT_EQ(curve.intervalAt(1.0), nullptr);
    curve.intervals = {{0.0, 2.0, {}}, {2.0, 3.0, {}}, {3.0, 7.0, {}}};
    for (const auto& [value, place] : {std::pair(-1.0, 0), {0.0, 0}, {1.9, 0}, {2.0, 1}, {3.0, 2}, {9.0, 2}})
        EXPECT_EQ(curve.intervalAt(value), &curve.intervals[size_t(place)]) << value;
}

TEST(WordsInEnglish, haveTheirNumbers) {
    const Words words{"%1: %2 of %3, %4, %5",
                      {Term::name("bunny"), Term::count(69451), Term::length(0.123456), Term::angle(1.0), Term::share(0.25)}};
    EXPECT_EQ(words.english(), "bunny: 69451 of 0.123, 57.3°, 25 %");
}

}  // namespace
}  // namespace cullscope::test::plain_data_test
