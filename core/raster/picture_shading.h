#pragma once

#include <array>
#include <memory>

#include "core/frame/commands.h"
#include "core/raster/depth_buffer.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// A part of a picture: rows count from the bottom.
struct PicturePart {
    int x = 0, y = 0;  ///< its lower left pixel
    Viewport size;
};

/// How a picture's surfaces are coloured.
struct PictureColours {
    Vec3f surface{1.0f};
    std::array<uint8_t, 4> background{};  ///< red, green, blue, opacity
};

/// The colours of a part of a picture, RGBA, as the shader of scene triangles has them: a headlight at the eye, the same for both
/// sides, normals interpolated over the triangle. Every pixel is shaded once, whatever was drawn before it. `parallel`, by rows,
/// and `simd` change nothing.
[[nodiscard]] std::unique_ptr<uint32_t[]> shadedPicture(const Scene& scene, const View& view, const FinishedPicture& picture,
                                                        const PicturePart& part, const PictureColours& colours,
                                                        bool parallel = true, RasterSimd simd = availableRasterSimd().back());

}  // namespace cullscope
