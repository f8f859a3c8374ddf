#include "core/raster/canvas.h"

#include <array>

namespace cullscope::test::canvas_test {
namespace {

TEST(Canvas, lineHasItsWidthAndPlace) {
    Canvas canvas({40, 20}, Vec3f(1.0f), 1.0f);
    canvas.clipTo({0.0, 0.0, 30.0, 20.0});
    canvas.line(std::array{Vec2(5.0, 10.0), Vec2(50.0, 10.0)}, {Vec3f(0.0f), 4.0});
    const std::vector<uint8_t> rgba = canvas.rgba();
    const auto at = [&](int x, int y) { return rgba[4 * (size_t(19 - y) * 40 + size_t(x))]; };
    for (int y = 0; y < 20; ++y) EXPECT_EQ(at(20, y), y >= 8 && y < 12 ? 0 : 255) << y;
    EXPECT_EQ(at(1, 10), 255);
    EXPECT_EQ(at(35, 10), 255) << "beyond the clip";
}

TEST(Canvas, transparentBackgroundIsNotBlendedIn) {
    Canvas canvas({4, 4}, Vec3f(1.0f), 0.0f);
    canvas.fill({0.0, 0.0, 2.0, 4.0}, Vec3f(0.2f, 0.4f, 0.6f), 0.5);
    const std::vector<uint8_t> rgba = canvas.rgba();
    EXPECT_EQ(rgba[0], 51) << "straight alpha: the colour itself";
    EXPECT_EQ(rgba[3], 128);
    EXPECT_EQ(rgba[15], 0);
}

TEST(Canvas, polygonIsFilledByTheEvenOddRule) {
    Canvas canvas({12, 12}, Vec3f(1.0f), 1.0f);
    // A square with a square within it, as one line.
    canvas.fill(std::array{Vec2(1, 1), Vec2(11, 1), Vec2(11, 11), Vec2(1, 11), Vec2(1, 1), Vec2(4, 4), Vec2(4, 8), Vec2(8, 8),
                           Vec2(8, 4), Vec2(4, 4)},
                Vec3f(0.0f), 1.0);
    const std::vector<uint8_t> rgba = canvas.rgba();
    for (int y = 0; y < 12; ++y)
        for (int x = 0; x < 12; ++x) {
            const bool outer = x >= 1 && x < 11 && y >= 1 && y < 11, inner = x >= 4 && x < 8 && y >= 4 && y < 8;
            EXPECT_EQ(rgba[4 * (size_t(11 - y) * 12 + size_t(x))], outer && !inner ? 0 : 255) << x << ", " << y;
        }
}

}  // namespace
}  // namespace cullscope::test::canvas_test
