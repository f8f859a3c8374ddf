#include "core/mesh/parametric.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::item_buffer_test {
namespace {

View standardView(Viewport size = {64, 64}) {
    return {{Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 100}, size};
}

std::vector<uint32_t> items(const ScenePointer& scene, const View& view, const DrawList& list) {
    return GlEnvironment::renderer().drawItemBuffer(SceneBuffers(scene, Upload::Vbo), view, list).triangle;
}

TEST(ItemBuffer, tieDoesNotDependOnTheDrawingOrder) {
    // The same square three times: the lowest number stays, for every order of the list.
    const ScenePointer scene = copiesOf(squareMesh(50, -5), {Mat4(1.0), Mat4(1.0), Mat4(1.0)});
    DrawList list = everything(*scene, Facing::TwoSided);
    const std::vector<uint32_t> first = items(scene, standardView(), list);
    EXPECT_THAT(first, testing::Each(testing::AnyOf(1u, 2u)));
    std::reverse(list.ranges.begin(), list.ranges.end());
    EXPECT_EQ(items(scene, standardView(), list), first);
    std::swap(list.ranges[0], list.ranges[1]);
    EXPECT_EQ(items(scene, standardView(), list), first);
}

TEST(ItemBuffer, tieWithinOneMeshTakesTheLowerNumber) {
    const std::vector<Vec3f> corners{{-50, -50, -5}, {50, -50, -5}, {0, 50, -5}};
    const ScenePointer forward = sceneOf({meshOf(corners, {0, 1, 2, 0, 1, 2, 0, 1, 2})});
    EXPECT_THAT(items(forward, standardView(), everything(*forward, Facing::TwoSided)), testing::Each(1u));
    DrawList backward{Facing::TwoSided, {{0, 6, 3}, {0, 3, 3}, {0, 0, 3}}};
    EXPECT_THAT(items(forward, standardView(), backward), testing::Each(1u));
}

TEST(ItemBuffer, nothingIsReportedWhereNothingIs) {
    const ScenePointer scene = sceneOf({squareMesh(1, 5)});
    EXPECT_THAT(items(scene, standardView(), everything(*scene, Facing::TwoSided)), testing::Each(0u));
}

TEST(ItemBuffer, depthIsThatOfThePicture) {
    const ScenePointer scene = sceneOf({knotMesh(8000), teapotMesh(8000)}, {Mat4(1.0), translation({1, 0, -1})});
    const View view({{2, 3, 5}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(45), 0.05, 100}, {320, 240});
    const SceneBuffers buffers(scene, Upload::Vbo);
    for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
        const DrawList list = everything(*scene, facing);
        const Renderer::ItemBuffer buffer = GlEnvironment::renderer().drawItemBuffer(buffers, view, list);
        EXPECT_EQ(buffer.depth, picture(buffers, view, list).depth);
        for (size_t i = 0; i < buffer.depth.size(); ++i)
            ASSERT_EQ(buffer.depth[i] > 0.0f, buffer.triangle[i] != 0) << "pixel " << i;
    }
}

TEST(ItemBuffer, numbersNameTheInstance) {
    // Four squares side by side: every quadrant shows the numbers of its own instance's triangles.
    const ScenePointer scene = copiesOf(squareMesh(1, 0), {translation({-2.5, -2.5, -5}), translation({2.5, -2.5, -5}),
                                                           translation({-2.5, 2.5, -5}), translation({2.5, 2.5, -5})});
    const std::vector<uint32_t> seen = items(scene, standardView(), everything(*scene, Facing::Front));
    std::array<int, 4> pixels{};
    for (size_t i = 0; i < seen.size(); ++i) {
        if (seen[i] == 0) continue;
        const size_t quadrant = (i % 64 < 32 ? 0u : 1u) + (i / 64 < 32 ? 0u : 2u);
        EXPECT_EQ(scene->instanceOf(seen[i] - 1), quadrant);
        ++pixels[quadrant];
    }
    EXPECT_THAT(pixels, testing::Each(testing::Gt(50)));
}

TEST(ItemBuffer, widestAndSmallestPicturesAreCovered) {
    // Case 23: a window of 16384 × 1 and one of 1 × 1.
    const ScenePointer scene = sceneOf({squareMesh(1e6f, -5)});
    EXPECT_THAT(items(scene, standardView({16384, 1}), everything(*scene, Facing::TwoSided)), testing::Each(testing::Gt(0u)));
    EXPECT_THAT(items(scene, standardView({1, 1}), everything(*scene, Facing::TwoSided)), testing::ElementsAre(testing::Gt(0u)));
}

}  // namespace
}  // namespace cullscope::test::item_buffer_test
