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

}  // namespace
}  // namespace cullscope::test::canvas_test
