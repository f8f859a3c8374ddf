#pragma once

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <memory>

#include "core/gpu/context.h"
#include "core/gpu/renderer.h"
#include "core/gpu/scene_buffers.h"

namespace cullscope::test {

/// One OpenGL context without a display for a whole test program, and its renderer.
class GlEnvironment : public testing::Environment {
public:
    void SetUp() override {
        m_context = std::make_unique<HeadlessContext>();
        m_renderer = std::make_unique<Renderer>();
        s_current = this;
    }
    void TearDown() override {
        s_current = nullptr;
        m_renderer.reset();
        m_context.reset();
    }
    static Renderer& renderer() { return *s_current->m_renderer; }
    static const GlInfo& info() { return s_current->m_context->info(); }

private:
    inline static GlEnvironment* s_current = nullptr;
    std::unique_ptr<HeadlessContext> m_context;
    std::unique_ptr<Renderer> m_renderer;
};

/// The environment of this program; GoogleTest owns it. Include this header in one source file that every program has.
inline testing::Environment* const kGlEnvironment = testing::AddGlobalTestEnvironment(new GlEnvironment);

/// Colour and depth of a drawn picture.
struct Picture {
    std::vector<uint8_t> colour;
    std::vector<float> depth;

    bool operator==(const Picture&) const = default;
};

inline Picture picture(const SceneBuffers& buffers, const View& view, const DrawList& list) {
    Framebuffer target(view.viewport());
    GlEnvironment::renderer().draw(buffers, view, list, target);
    return {target.readColour(), target.readDepth()};
}

inline Picture picture(const ScenePointer& scene, const View& view, Facing facing, Upload upload = Upload::Vbo) {
    const SceneBuffers buffers(scene, upload);
    return picture(buffers, view, everything(*scene, facing));
}

}  // namespace cullscope::test
