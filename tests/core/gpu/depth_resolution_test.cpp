// Why the depth buffer is a reversed one of 32-bit floats: stability cases 18 and 19.

#include <epoxy/gl.h>

#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::depth_resolution_test {
namespace {

constexpr Vec3f kRed{1, 0, 0}, kGreen{0, 1, 0};
constexpr Viewport kSize{32, 32};

/// Draws squares at two distances, the first one red, the second one green, over a range of depths from 0.01 to 1e6; with the
/// depth buffer of a framebuffer, or with another one in `format`. Whether the nearer one is seen everywhere.
bool nearerIsSeen(double first, double second, GLenum format) {
    const ScenePointer scene = sceneOf({squareMesh(4000, float(-first)), squareMesh(4000, float(-second))});
    const SceneBuffers buffers(scene, Upload::Vbo);
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), .01, 1e6}, kSize);
    Framebuffer target(kSize);
    unsigned depth = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &depth);
    glTextureStorage2D(depth, 1, format, kSize.width, kSize.height);
    glNamedFramebufferTexture(target.id(), GL_DEPTH_ATTACHMENT, depth, 0);
    EXPECT_EQ(glCheckNamedFramebufferStatus(target.id(), GL_FRAMEBUFFER), GLenum(GL_FRAMEBUFFER_COMPLETE));
    Renderer& renderer = GlEnvironment::renderer();
    DrawStyle style;
    style.surface = kRed;
    renderer.execute(buffers, view, DrawList{Facing::TwoSided, {{0, 0, 6}}}, target, style);
    style.surface = kGreen;
    renderer.execute(buffers, view, DrawList{Facing::TwoSided, {{1, 0, 6}}}, target, style, false);
    const std::vector<uint8_t> colour = target.readColour();
    glDeleteTextures(1, &depth);
    const size_t channel = first < second ? 0 : 1;
    for (size_t pixel = 0; pixel < colour.size() / 4; ++pixel)
        if (colour[4 * pixel + channel] == 0) return false;
    return true;
}

TEST(DepthResolution, reversedFloatsTellSurfacesApartInBothOrders) {
    EXPECT_TRUE(nearerIsSeen(1000, 1000.01, GL_DEPTH_COMPONENT32F));
    EXPECT_TRUE(nearerIsSeen(1000.01, 1000, GL_DEPTH_COMPONENT32F));
}

TEST(DepthResolution, fixedDepthOf24BitsDoesNotInOneOrder) {
    // The negative control: both surfaces have one depth, and the first one drawn stays.
    EXPECT_TRUE(nearerIsSeen(1000, 1000.01, GL_DEPTH_COMPONENT24));
    EXPECT_FALSE(nearerIsSeen(1000.01, 1000, GL_DEPTH_COMPONENT24));
}

}  // namespace
}  // namespace cullscope::test::depth_resolution_test
