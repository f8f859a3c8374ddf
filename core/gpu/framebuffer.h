#pragma once

#include <cstdint>
#include <vector>

#include "core/frame/commands.h"
#include "core/scene/camera.h"

namespace cullscope {

/// A rectangle of a picture that is too large to be drawn at once; rows count from the bottom.
struct PictureTile {
    int x = 0, y = 0;  ///< its lower left pixel in the whole picture
    Viewport size;
};

/// A picture on the GPU: RGBA8 colour and 32-bit float depth (reversed: 0 is far). Rows count from the bottom.
/// The textures belong to the share group; the framebuffer object itself to the context it was made in.
class Framebuffer {
public:
    /// Throws Error(OpenGl) where this OpenGL cannot create a framebuffer of that size.
    explicit Framebuffer(const Viewport& size) : Framebuffer(PictureTile{0, 0, size}) {}
    /// A framebuffer for a tile of the picture of a View.
    explicit Framebuffer(const PictureTile& tile);
    ~Framebuffer();
    Framebuffer(const Framebuffer&) = delete;
    Framebuffer& operator=(const Framebuffer&) = delete;

    [[nodiscard]] const Viewport& size() const { return m_tile.size; }
    [[nodiscard]] const PictureTile& tile() const { return m_tile; }
    // OpenGL's names of the framebuffer object and its textures; through the first and the last the depth is read.
    [[nodiscard]] unsigned id() const {
        writeDepth();
        return m_framebuffer;
    }
    [[nodiscard]] unsigned colourTexture() const { return m_colour; }
    [[nodiscard]] unsigned depthTexture() const {
        writeDepth();
        return m_depth;
    }

    /// The depth of a finished picture, or of the tile of it. OpenGL converts depths one by one, which takes a tenth of such a
    /// frame, and most pictures are shown without it: it is written where it is asked for.
    void setDepth(FinishedPicturePointer picture) { m_depthToWrite = std::move(picture); }
    /// The depth is cleared next, so that what setDepth() set is not needed.
    void dropDepth() { m_depthToWrite = nullptr; }

    [[nodiscard]] std::vector<uint8_t> readColour() const;  ///< RGBA, width · height · 4 bytes
    [[nodiscard]] std::vector<float> readDepth() const;     ///< width · height samples

private:
    PictureTile m_tile;
    unsigned m_framebuffer = 0;
    unsigned m_colour = 0;
    unsigned m_depth = 0;
    mutable FinishedPicturePointer m_depthToWrite;  ///< null: the texture has the depth

    void writeDepth() const;
};

}  // namespace cullscope
