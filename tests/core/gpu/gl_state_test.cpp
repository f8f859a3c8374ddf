#include <chrono>
#include <functional>
#include <thread>

#include "core/base/error.h"
#include "core/gpu/program.h"
#include "tests/support/gl_environment.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::gl_state_test {
namespace {

GLint integer(GLenum name) {
    GLint value = -1;
    glGetIntegerv(name, &value);
    return value;
}

/// Checks by name every state that the renderer changes and Qt relies on.
void expectDefaults() {
    EXPECT_EQ(integer(GL_CLIP_ORIGIN), GL_LOWER_LEFT);
    EXPECT_EQ(integer(GL_CLIP_DEPTH_MODE), GL_NEGATIVE_ONE_TO_ONE);
    for (const GLenum capability : {GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST, GL_BLEND, GL_STENCIL_TEST, GL_DEPTH_CLAMP})
        EXPECT_FALSE(glIsEnabled(capability)) << std::hex << capability;
    EXPECT_EQ(integer(GL_DEPTH_FUNC), GL_LESS);
    EXPECT_EQ(integer(GL_DEPTH_WRITEMASK), GL_TRUE);
    EXPECT_EQ(integer(GL_CULL_FACE_MODE), GL_BACK);
    EXPECT_EQ(integer(GL_FRONT_FACE), GL_CCW);
    for (const GLenum binding : {GL_VERTEX_ARRAY_BINDING, GL_CURRENT_PROGRAM, GL_ARRAY_BUFFER_BINDING,
                                 GL_ELEMENT_ARRAY_BUFFER_BINDING, GL_TEXTURE_BINDING_2D, GL_SHADER_STORAGE_BUFFER_BINDING})
        EXPECT_EQ(integer(binding), 0) << std::hex << binding;
    GLfloat clearDepth = 0;
    glGetFloatv(GL_DEPTH_CLEAR_VALUE, &clearDepth);
    EXPECT_EQ(clearDepth, 1.0f);
    std::array<GLboolean, 4> mask{};
    glGetBooleanv(GL_COLOR_WRITEMASK, mask.data());
    EXPECT_THAT(mask, testing::Each(GLboolean{GL_TRUE}));
    std::array<GLfloat, 4> clearColour{9, 9, 9, 9};
    glGetFloatv(GL_COLOR_CLEAR_VALUE, clearColour.data());
    EXPECT_THAT(clearColour, testing::Each(0.0f));
    GLint image = -1;
    glGetIntegeri_v(GL_IMAGE_BINDING_NAME, 0, &image);
    EXPECT_EQ(image, 0);
    for (const GLuint index : {0u, 1u}) {
        GLint buffer = -1;
        glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, index, &buffer);
        EXPECT_EQ(buffer, 0) << index;
    }
    std::array<GLint, 2> polygonMode{};  // compatibility profiles return one value for each side
    glGetIntegerv(GL_POLYGON_MODE, polygonMode.data());
    EXPECT_EQ(polygonMode[0], GL_FILL);
    EXPECT_EQ(integer(GL_PACK_ALIGNMENT), 4);
    EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

/// A framebuffer bound by the caller before the renderer is called.
class Bound {
public:
    Bound() { glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id()); }
    ~Bound() { glBindFramebuffer(GL_FRAMEBUFFER, 0); }
    Bound(const Bound&) = delete;
    Bound& operator=(const Bound&) = delete;
    void expectStillBound() const {
        EXPECT_EQ(integer(GL_DRAW_FRAMEBUFFER_BINDING), GLint(m_framebuffer.id()));
        EXPECT_EQ(integer(GL_READ_FRAMEBUFFER_BINDING), GLint(m_framebuffer.id()));
    }

private:
    Framebuffer m_framebuffer{Viewport{8, 8}};
};

class GlState : public testing::TestWithParam<Upload> {};

TEST_P(GlState, rendererLeavesNothingBehind) {
    if (GetParam() == Upload::VertexArray && !GlEnvironment::info().compatibilityProfile)
        FAIL() << "no compatibility profile: the listed Mesa has one (LIBGL_ALWAYS_SOFTWARE=1)";
    const ScenePointer scene = sceneOf({squareMesh(1, -5), squareMesh(1, -6)}, {scaling({-1, 1, 1}), Mat4(1.0)});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 100}, {32, 32});
    const SceneBuffers buffers(scene, GetParam());
    for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
        const Bound bound;
        (void)picture(buffers, view, everything(*scene, facing));
        expectDefaults();
        bound.expectStillBound();
        (void)GlEnvironment::renderer().drawItemBuffer(buffers, view, everything(*scene, facing));
        expectDefaults();
        bound.expectStillBound();
        (void)GlEnvironment::renderer().pick(buffers, view, everything(*scene, facing), 16, 16);
        expectDefaults();
        bound.expectStillBound();
    }
}

TEST_P(GlState, overlaysLeaveNothingBehind) {
    const ScenePointer scene = sceneOf({squareMesh(1, -5), squareMesh(1, -6)}, {scaling({-1, 1, 1}), Mat4(1.0)});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 100}, {32, 32});
    const SceneBuffers buffers(scene, GetParam());
    using enum PaletteEntry::Look;
    const std::array<PaletteEntry, 4> palette{
        {{Vec3f(1.0f), Filled}, {Vec3f(1.0f), Wireframe}, {Vec3f(1.0f), Marked}, {Vec3f(1.0f), Absent}}};
    for (const Facing facing : {Facing::TwoSided, Facing::Front}) {
        const Bound bound;
        Framebuffer target(view.viewport());
        GlEnvironment::renderer().drawByState(buffers, view, facing, std::array<uint8_t, 4>{0, 1, 2, 3}, palette, target);
        expectDefaults();
        bound.expectStillBound();
        for (const bool depthTest : {true, false}) {
            GlEnvironment::renderer().drawLines(view, std::array{LineSegment{{0, 0, -1}, {1, 0, -9}, Vec3f(1.0f)}},
                                                {3.0f, depthTest}, target);
            expectDefaults();
            bound.expectStillBound();
        }
        const SphericalModel model{.sphere = {Vec3(0.0), 7.0}, .area = mapArea(view.viewport(), 0.0)};
        GlEnvironment::renderer().drawSpherical(buffers, view, everything(*scene, facing), model, target);
        expectDefaults();
        bound.expectStillBound();
    }
}

TEST_P(GlState, aStopRequestLeavesNothingBehind) {
    const ScenePointer scene = copiesOf(squareMesh(1, -5), std::vector<Mat4>(2000, Mat4(1.0)));
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 0.1, 100}, {32, 32});
    const SceneBuffers buffers(scene, GetParam());
    Renderer& renderer = GlEnvironment::renderer();
    const DrawList all = everything(*scene, Facing::TwoSided);
    const Bound bound;
    Framebuffer target(view.viewport());
    const std::vector<uint8_t> states(scene->triangleCount(), 0);
    const std::array palette{PaletteEntry{Vec3f(1.0f), PaletteEntry::Look::Wireframe}};
    const std::array<std::function<void()>, 4> draws{
        [&] { renderer.draw(buffers, view, all, target); }, [&] { (void)renderer.drawItemBuffer(buffers, view, all); },
        [&] { (void)renderer.pick(buffers, view, all, 16, 16); },
        [&] { renderer.drawByState(buffers, view, Facing::TwoSided, states, palette, target); }};
    for (const auto& draw : draws) {
        // Before the first object, and somewhere on the way.
        for (int milliseconds = 0; milliseconds < 20; ++milliseconds) {
            std::stop_source source;
            if (milliseconds == 0) source.request_stop();
            const std::jthread hand([&] {
                std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
                source.request_stop();
            });
            const Renderer::Stoppable stoppable(renderer, source.get_token());
            if (milliseconds == 0)
                EXPECT_THROW(draw(), Error);
            else
                try {
                    draw();
                } catch (const Error& error) {
                    EXPECT_EQ(error.kind(), ErrorKind::Interrupted);
                }
            expectDefaults();
        }
        bound.expectStillBound();
        EXPECT_NO_THROW(draw()) << "nothing is stopped any more";
    }
}

INSTANTIATE_TEST_SUITE_P(Uploads, GlState, testing::Values(Upload::Vbo, Upload::VertexArray),
                         [](const auto& upload) { return upload.param == Upload::Vbo ? "vbo" : "vertexArray"; });

TEST(CallersState, doesNotChangeThePicture) {
    const ScenePointer scene = sceneOf({squareMesh(1, -5)});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {32, 32});
    const Picture clean = picture(scene, view, Facing::Front);
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 4, 4);
    glEnable(GL_BLEND);
    glDepthFunc(GL_NEVER);
    glFrontFace(GL_CW);
    glPolygonMode(GL_FRONT_AND_BACK, GL_POINT);
    glColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_FALSE);
    EXPECT_EQ(picture(scene, view, Facing::Front), clean);
    expectDefaults();
}

TEST(Program, brokenShaderIsRefused) {
    try {
        const Program program("#version 450\nvoid main() { gl_Position = nonsense; }\n", "#version 450\nvoid main() {}\n");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::OpenGl);
        EXPECT_THAT(error.what(), testing::HasSubstr("nonsense")) << "the driver's log is missing";
    }
}

TEST(HeadlessContext, contextIsNewEnoughAndHasAName) {
    const GlInfo info = requireOpenGl45();
    EXPECT_GE(info.major * 10 + info.minor, 45);
    EXPECT_FALSE(info.renderer.empty());
    EXPECT_EQ(info.version, GlEnvironment::info().version);
}

}  // namespace
}  // namespace cullscope::test::gl_state_test
