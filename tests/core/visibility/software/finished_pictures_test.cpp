// Pictures that a strategy made without OpenGL, in a framebuffer.
#include <gtest/gtest.h>

#include "core/gpu/renderer.h"
#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::finished_pictures_test {
namespace {

TEST(FinishedPictures, depthIsInTheFramebufferWhereItIsAskedForAndNoneIsLeftInTheNextFrame) {
    const ScenePointer scene = sceneOf({starMesh(3, 800)});
    const View view({{0.5, 1, 3}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(50), 0.1, 100}, {60, 44});
    const SceneBuffers buffers(scene, Upload::Vbo);
    Renderer& renderer = GlEnvironment::renderer();
    const CullerPointer culler = makeCuller("depth-buffer");
    culler->build(*scene);
    const FrameLog log = culler->cull(view).log;
    const PictureTile tile{16, 9, {31, 22}};
    Framebuffer whole(view.viewport()), part(tile);
    for (Framebuffer* target : {&whole, &part}) renderer.draw(buffers, view, log, *target);
    const std::vector<float> depth = whole.readDepth();
    EXPECT_EQ(depth, std::get<FinishedPicturePointer>(log.commands.at(0))->depth);
    const std::vector<float> ofTile = part.readDepth();
    for (size_t pixel = 0; pixel < ofTile.size(); ++pixel)
        ASSERT_EQ(ofTile[pixel], depth[(pixel / 31 + 9) * 60 + 16 + pixel % 31]) << "pixel " << pixel << " of the tile";

    // A triangle behind the star is hidden where it is drawn over the picture, and alone where its frame begins anew.
    const ScenePointer behind = sceneOf({squareMesh(1, -1.5f)});
    const SceneBuffers square(behind, Upload::Vbo);
    const Command command = everything(*behind, Facing::TwoSided);
    renderer.draw(buffers, view, log, whole);
    renderer.execute(square, view, command, whole, {}, false);
    const std::vector<float> both = whole.readDepth();
    renderer.draw(buffers, view, log, whole);
    renderer.execute(square, view, command, whole, {}, true);
    const std::vector<float> alone = whole.readDepth();
    size_t hidden = 0;
    for (size_t pixel = 0; pixel < depth.size(); ++pixel) {
        ASSERT_EQ(both[pixel], std::max(depth[pixel], alone[pixel])) << "pixel " << pixel;
        hidden += depth[pixel] > alone[pixel] && alone[pixel] > 0.0f ? 1 : 0;
    }
    EXPECT_GT(hidden, 50u);
}

}  // namespace
}  // namespace cullscope::test::finished_pictures_test
