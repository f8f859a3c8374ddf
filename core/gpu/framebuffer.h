#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/camera.h"

namespace cullscope {

/// A picture on the GPU: RGBA8 colour and 32-bit float depth (reversed: 0 is far). Rows count from the bottom.
/// The textures belong to the share group; the framebuffer object itself to the context it was made in.
class Framebuffer {
public:
    /// Throws Error(OpenGl) where this OpenGL cannot make one of that size.
    explicit Framebuffer(const Viewport& size);
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    [[nodiscard]] const Viewport& size() const { return m_size; }
    [[nodiscard]] unsigned id() const { return m_framebuffer; }
    [[nodiscard]] unsigned colourTexture() const { return m_colour; }
    [[nodiscard]] unsigned depthTexture() const { return m_depth; }

    [[nodiscard]] std::vector<uint8_t> readColour() const;  ///< RGBA, width · height · 4 bytes
    [[nodiscard]] std::vector<float> readDepth() const;     ///< width · height samples

    /// Copies the colours into another framebuffer, such as a window's, lower left corner on lower left corner; leaves that one
    /// bound.
    void showIn(unsigned framebuffer) const;

private:
    Viewport m_size;
    unsigned m_framebuffer = 0;
    unsigned m_colour = 0;
    unsigned m_depth = 0;
};

/// Fills a framebuffer that is not ours, such as a window's, with one opaque colour; leaves it bound.
void fillFramebuffer(unsigned framebuffer, const Vec3f& colour);

}  // namespace cullscope
