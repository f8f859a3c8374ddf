#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::overlay_drawing_test {
namespace {

constexpr Vec3f kRed(1, 0, 0);

View downMinusZ(const Viewport& size = {100, 100}, const Vec3& eye = Vec3(0.0)) {
    return {{eye, eye + Vec3(0, 0, -1), {0, 1, 0}, Angle::fromDegrees(90), 1, 100}, size};
}

/// The pixels that lines make red, over a square at z = −10 that covers the left half of the picture.
std::vector<uint8_t> redPixels(const View& view, const std::vector<LineSegment>& lines, const LineStyle& style,
                               const Vec3& moved = Vec3(0.0)) {
    const ScenePointer scene = sceneOf({squareMesh(10, 0)}, {translation(moved + Vec3(-10, 0, -10))});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Framebuffer target(view.viewport());
    GlEnvironment::renderer().draw(buffers, view, everything(*scene, Facing::TwoSided), target);
    const std::vector<float> depth = target.readDepth();
    GlEnvironment::renderer().drawLines(view, lines, style, target);
    EXPECT_EQ(target.readDepth(), depth) << "lines left depth";
    const std::vector<uint8_t> colour = target.readColour();
    std::vector<uint8_t> red;
    for (size_t i = 0; i < colour.size(); i += 4) red.push_back(colour[i] == 255 && colour[i + 1] == 0 ? 1 : 0);
    return red;
}

size_t count(const std::vector<uint8_t>& mask) { return size_t(std::count(mask.begin(), mask.end(), uint8_t{1})); }

TEST(Lines, hiddenPartIsSeenOnlyWhereLinesAreTopmost) {
    const std::vector<LineSegment> behind{{{-15, 1.1, -20}, {15, 1.1, -20}, kRed}};
    EXPECT_NEAR(double(count(redPixels(downMinusZ(), behind, {1, true}))), 37.5, 2) << "only the half that nothing covers";
    EXPECT_NEAR(double(count(redPixels(downMinusZ(), behind, {1, false}))), 75, 2);
    const std::vector<LineSegment> on{{{-9, 1.1, -10}, {-1, 1.1, -10}, kRed}};
    EXPECT_NEAR(double(count(redPixels(downMinusZ(), on, {1, true}))), 40, 2) << "a line on a surface is before it";
}

TEST(Lines, widthIsTheOneAskedFor) {
    // 40 pixels long, with square ends of half the width.
    const std::vector<LineSegment> line{{{-4, 1.07, -10}, {4, 1.07, -10}, kRed}};
    for (const float width : {1.0f, 2.0f, 3.0f, 7.0f, 20.0f})
        EXPECT_NEAR(double(count(redPixels(downMinusZ(), line, {width, false}))), width * (40 + width), width + 42);
    const std::vector<LineSegment> dot{{{2.07, 1.07, -10}, {2.07, 1.07, -10}, kRed}};
    EXPECT_EQ(count(redPixels(downMinusZ(), dot, {5, false})), 25u) << "a line without length is a dot";
}

TEST(Lines, partBeyondTheDepthRangeIsDrawn) {
    // In the direction of the right edge, from behind the eye to far beyond the far plane.
    const std::vector<LineSegment> through{{{5, 2, 50}, {5, 2, -1e6}, kRed}};
    EXPECT_NEAR(double(count(redPixels(downMinusZ(), through, {1, true}))), 54, 7) << "from the border to the vanishing point";
    EXPECT_EQ(count(redPixels(downMinusZ(), {{{5, 2, 50}, {5, 2, 1}, kRed}}, {1, true})), 0u) << "all of it behind the eye";
    EXPECT_GT(count(redPixels(downMinusZ(), {{{-.3, .1, -.5}, {.3, .1, -.5}, kRed}}, {1, true})), 50u) << "before the near plane";
    EXPECT_GT(count(redPixels(downMinusZ(), {{{50, 10, -500}, {400, 10, -500}, kRed}}, {1, true})), 30u) << "beyond far";
    EXPECT_EQ(count(redPixels(downMinusZ(), {}, {1, true})), 0u);
}

TEST(Lines, farFromTheOriginTheyLieInTheSamePlace) {
    const Vec3 moved(1e7, -1e7, 1e7);
    const std::vector<LineSegment> here{{{-4, 1.25, -10}, {6, -3.5, -20}, kRed}, {{3, 2, -5}, {3.5, -2, -40}, kRed}};
    std::vector<LineSegment> there = here;
    for (LineSegment& line : there) {
        line.from += moved;
        line.to += moved;
    }
    const std::vector<uint8_t> a = redPixels(downMinusZ(), here, {3, true});
    EXPECT_GT(count(a), 100u);
    EXPECT_EQ(a, redPixels(downMinusZ({100, 100}, moved), there, {3, true}, moved));
}

TEST(Pick, givesTheItemBuffersTriangle) {
    const ScenePointer scene =
        sceneOf({knotMesh(4000), starMesh(7, 3000), sphereMesh(1000)},
                {translation({-2.5, 0, 0}), translation({2, 0, 0}) * scaling({-1, 1, 1}), translation({0, 0, -5})});
    const View view({{0, 2, 5}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {320, 240});
    for (const Upload upload : {Upload::Vbo, Upload::VertexArray}) {
        const SceneBuffers buffers(scene, upload);
        for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
            DrawList list = everything(*scene, facing);
            list.ranges[0].indexCount /= 2;
            list.ranges[0].indexCount -= list.ranges[0].indexCount % 3;
            const Renderer::ItemBuffer items = GlEnvironment::renderer().drawItemBuffer(buffers, view, list);
            Random random(17);
            size_t hits = 0;
            const uint64_t pixels = howMany(500, 500);
            for (uint64_t i = 0; i < pixels; ++i) {
                const int x = int(random.between(0, 320)), y = int(random.between(0, 240));
                const size_t pixel = size_t(y) * 320 + size_t(x);
                const auto picked = GlEnvironment::renderer().pick(buffers, view, list, x, y);
                ASSERT_EQ(picked.has_value(), items.triangle[pixel] != 0) << x << "," << y;
                if (!picked) continue;
                ++hits;
                EXPECT_EQ(picked->triangle + 1, items.triangle[pixel]) << x << "," << y;
                EXPECT_EQ(picked->depth, double(items.depth[pixel]));
            }
            EXPECT_GT(hits, pixels / 6);
            EXPECT_LT(hits, pixels * 9 / 10);
        }
    }
}

TEST(Pick, pixelOutsideTheViewportShowsNothing) {
    const ScenePointer scene = sceneOf({squareMesh(100, -5)});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const DrawList list = everything(*scene, Facing::TwoSided);
    const auto picked = [&](int x, int y) {
        return GlEnvironment::renderer().pick(buffers, downMinusZ(), list, x, y).has_value();
    };
    EXPECT_TRUE(picked(0, 0));
    EXPECT_TRUE(picked(99, 99));
    for (const auto& [x, y] : {std::pair(-1, 0), std::pair(0, -1), std::pair(100, 0), std::pair(0, 100)})
        EXPECT_FALSE(picked(x, y));
}

TEST(DrawByState, isTheSameByEitherUploadAndFollowsTheFacing) {
    const ScenePointer scene =
        sceneOf({knotMesh(2001), sphereMesh(500), squareMesh(1, 0)},
                {translation({-2, 0, 0}), translation({2, 0, 0}) * scaling({-1, 1, 1}), translation({0, 2, 0})});
    const View view({{0, 3, 9}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {160, 120});
    std::vector<uint8_t> states(scene->triangleCount());
    for (size_t i = 0; i < states.size(); ++i) states[i] = uint8_t(i % 4);
    const auto drawn = [&](Upload upload, Facing facing, const std::vector<PaletteEntry>& palette) {
        const SceneBuffers buffers(scene, upload);
        Framebuffer target(view.viewport());
        GlEnvironment::renderer().drawByState(buffers, view, facing, states, palette, target);
        return Picture{target.readColour(), target.readDepth()};
    };
    using enum PaletteEntry::Look;
    const std::vector<PaletteEntry> palette{{kRed, Filled}, {{0, 1, 0}, Wireframe}, {{0, 0, 1}, Marked}, {{1, 1, 1}, Absent}};
    EXPECT_EQ(drawn(Upload::Vbo, Facing::TwoSided, palette), drawn(Upload::VertexArray, Facing::TwoSided, palette));
    // With all triangles filled, the depth is that of the picture, under the same facing rule.
    const std::vector<PaletteEntry> filled(4, {kRed, Filled});
    for (const Facing facing : {Facing::TwoSided, Facing::Front})
        EXPECT_EQ(drawn(Upload::Vbo, facing, filled).depth, picture(scene, view, facing).depth);
    const std::vector<PaletteEntry> absent(4, {kRed, Absent});
    EXPECT_THAT(drawn(Upload::Vbo, Facing::TwoSided, absent).depth, testing::Each(0.0f));
}

}  // namespace
}  // namespace cullscope::test::overlay_drawing_test
