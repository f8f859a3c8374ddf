#include "core/gpu/framebuffer.h"

#include <epoxy/gl.h>

#include <utility>

#include "core/base/error.h"

namespace cullscope {
namespace {

unsigned texture(const Viewport& size, GLenum format) {
    unsigned name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, format, size.width, size.height);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

size_t pixels(const Viewport& size) { return static_cast<size_t>(size.width) * static_cast<size_t>(size.height); }

}  // namespace

Framebuffer::Framebuffer(const PictureTile& tile) : m_tile(tile) {
    const Viewport& size = tile.size;
    m_colour = texture(size, GL_RGBA8);
    m_depth = texture(size, GL_DEPTH_COMPONENT32F);
    glCreateFramebuffers(1, &m_framebuffer);
    glNamedFramebufferTexture(m_framebuffer, GL_COLOR_ATTACHMENT0, m_colour, 0);
    glNamedFramebufferTexture(m_framebuffer, GL_DEPTH_ATTACHMENT, m_depth, 0);
    if (glCheckNamedFramebufferStatus(m_framebuffer, GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throwOpenGl(CULLSCOPE_TR("This OpenGL cannot make a picture of %1x%2 pixels: choose a smaller size."),
                    {std::to_string(size.width), std::to_string(size.height)});
}

Framebuffer::~Framebuffer() {
    glDeleteFramebuffers(1, &m_framebuffer);
    glDeleteTextures(1, &m_colour);
    glDeleteTextures(1, &m_depth);
}

std::vector<uint8_t> Framebuffer::readColour() const {
    std::vector<uint8_t> colour(pixels(size()) * 4);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(m_colour, 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(colour.size()), colour.data());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    return colour;
}

std::vector<float> Framebuffer::readDepth() const {
    std::vector<float> depth(pixels(size()));
    glGetTextureImage(depthTexture(), 0, GL_DEPTH_COMPONENT, GL_FLOAT, static_cast<GLsizei>(depth.size() * sizeof(float)),
                      depth.data());
    return depth;
}

void Framebuffer::writeDepth() const {
    if (!m_depthToWrite) return;
    const FinishedPicturePointer picture = std::exchange(m_depthToWrite, nullptr);
    // OpenGL takes the tile's rows out of those of the picture.
    glPixelStorei(GL_UNPACK_ROW_LENGTH, picture->size.width);
    glTextureSubImage2D(m_depth, 0, 0, 0, size().width, size().height, GL_DEPTH_COMPONENT, GL_FLOAT,
                        &picture->depth[size_t(m_tile.y) * size_t(picture->size.width) + size_t(m_tile.x)]);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

}  // namespace cullscope
