#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

#include "core/gpu/drawing.h"
#include "core/raster/picture_shading.h"

namespace cullscope {
namespace {

uint8_t byteOf(float value) { return static_cast<uint8_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 255.0f)); }

}  // namespace

void writePicture(const Scene& scene, const View& view, const FinishedPicturePointer& picture, const DrawStyle& style,
                  Framebuffer& target) {
    const PictureTile& tile = target.tile();
    const PictureColours colours{
        style.surface,
        {byteOf(style.background.x), byteOf(style.background.y), byteOf(style.background.z), byteOf(style.backgroundAlpha)}};
    const auto rgba = shadedPicture(scene, view, *picture, {tile.x, tile.y, tile.size}, colours);
    glTextureSubImage2D(target.colourTexture(), 0, 0, 0, tile.size.width, tile.size.height, GL_RGBA, GL_UNSIGNED_BYTE,
                        rgba.get());
    target.setDepth(picture);
}

}  // namespace cullscope
