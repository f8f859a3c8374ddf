#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/frame/draw_list.h"
#include "core/raster/screen_triangle.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The rows of each band of a picture, which one processor draws.
inline constexpr int kBandRows = 32;

/// Consecutive triangles of an instance on the raster, by the bands of rows that they reach, and what became of the others.
struct TrianglesOnRaster {
    uint32_t instance = 0;
    uint32_t firstNumber = 1;           ///< of the scene's triangle, counted from 1
    const uint32_t* indices = nullptr;  ///< three of each triangle
    const RasterVertex* vertices = nullptr;
    std::vector<ScreenTriangle> setUp;  ///< large and clipped ones; those of a clipped triangle follow each other
    std::vector<uint16_t> entries;      ///< by band, then in the scene's order (screen_triangle.h)
    std::vector<uint32_t> bandBegin;    ///< where each band's entries begin, and the end of the last one's
    uint64_t onRaster = 0;              ///< pieces of triangles that the entries name, each counted once
    uint64_t given = 0;                 ///< of the scene
    uint64_t outside = 0;               ///< lie beyond one plane of the frustum with all corners
    uint64_t facingAway = 0;            ///< not drawn by the facing rule
    uint64_t withoutSample = 0;         ///< have no area on the raster, or no pixel centre in their box
    uint64_t clipped = 0;               ///< at a plane of the frustum

    [[nodiscard]] PartInBand inBand(size_t band) const;
};

/// The triangles of a scene on the raster of a picture, in the scene's order. The scene must outlive it.
struct SceneOnRaster {
    Viewport size;
    std::unique_ptr<RasterVertex[]> vertices;
    std::vector<uint32_t> ownIndices;  ///< where the triangles are of no scene
    std::vector<TrianglesOnRaster> parts;
    size_t vertexCount = 0;
    std::vector<uint8_t> fates;  ///< by scene triangle, a TriangleFate: kOutside, kFacingAway; else kNoSample, until it is drawn

    [[nodiscard]] size_t bands() const { return (size_t(size.height) + kBandRows - 1) / size_t(kBandRows); }
    [[nodiscard]] size_t triangleCount() const;
    /// The triangles of all parts that reach a band, in their order, each set up. Throws Error(Interrupted) soon after a stop is
    /// requested.
    [[nodiscard]] std::vector<ScreenTriangle> trianglesIn(size_t band, const Progress& progress = {}) const;
    /// The memory that it takes.
    [[nodiscard]] uint64_t bytes() const;
};

/// Instruction sets of the kernels; all make the same picture.
enum class RasterSimd { Portable, Avx2, Avx512 };
/// Those that this processor has, the fastest last.
[[nodiscard]] std::span<const RasterSimd> availableRasterSimd();

/// Transforms each vertex once, as OpenGL does: by a float matrix relative to the eye; depth is reversed, 1 at the near plane and
/// 0 at the far plane. Triangles that reach beyond a plane of the frustum are clipped there, before the division. `parallel` and
/// `simd` change nothing in the result. Throws Error(Usage) for a scene of more than 2^32 − 2 triangles, and Error(Interrupted)
/// soon after a stop is requested.
[[nodiscard]] SceneOnRaster trianglesOnRaster(const Scene& scene, const View& view, Facing facing, bool parallel = true,
                                              RasterSimd simd = availableRasterSimd().back(), const Progress& progress = {});

/// A corner in a picture: pixels from its lower left corner, and the reversed depth.
struct RasterCorner {
    double x = 0.0, y = 0.0;
    float depth = 0.0f;
};
/// Triangles by their corners in a picture, three each, both of their sides.
[[nodiscard]] SceneOnRaster cornersOnRaster(std::span<const RasterCorner> corners, const Viewport& size);

}  // namespace cullscope
