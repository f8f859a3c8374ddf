#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "core/gpu/drawing.h"
#include "core/raster/picture_shading.h"

namespace cullscope {
namespace {

uint8_t byteOf(float value) { return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f)); }

}  // namespace

void writePicture(const Scene& scene, const View& view, const FinishedPicture& picture, const DrawStyle& style,
                  Framebuffer& target) {
    const PictureTile& tile = target.tile();
    const PictureColours colours{
        style.surface,
        {byteOf(style.background.x), byteOf(style.background.y), byteOf(style.background.z), byteOf(style.backgroundAlpha)}};
    const auto rgba = shadedPicture(scene, view, picture, {tile.x, tile.y, tile.size}, colours);
    glTextureSubImage2D(target.colourTexture(), 0, 0, 0, tile.size.width, tile.size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        rgba.get());
    // OpenGL takes the tile's rows out of those of the picture.
    glPixelStorei(GL_UNPACK_ROW_LENGTH, picture.size.width);
    glTextureSubImage2D(target.depthTexture(), 0, 0, 0, tile.size.width, tile.size.height, GL_DEPTH_COMPONENT, GL_FLOAT,
                        &picture.depth[size_t(tile.y) * size_t(picture.size.width) + size_t(tile.x)]);
    glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
}

}  // namespace cullscope
