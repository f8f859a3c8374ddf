#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/commands.h"
#include "core/raster/scene_triangles.h"

namespace cullscope {

/// What a rasteriser counted in some rows of a picture.
struct RowCounts {
    int firstRow = 0, endRow = 0;
    uint64_t triangles = 0;    ///< that reach these rows
    uint64_t samples = 0;      ///< that triangles cover, each as often as it is covered
    uint64_t comparisons = 0;  ///< of depths; the depth buffer compares every sample
    uint64_t edges = 0;        ///< of the scan line: those that bound the pixels of a surface in a row
    uint64_t crossings = 0;    ///< of the scan line: places where a surface passes another one
    uint64_t spans = 0;        ///< of the scan line
    uint64_t written = 0;      ///< samples that were stored, the same pixel as often as a nearer surface replaced another one
    uint64_t covered = 0;      ///< pixels that show a surface
};

/// A picture made without OpenGL, and its counts from the bottom to the top.
struct RasterPicture {
    std::shared_ptr<FinishedPicture> picture;
    std::vector<RowCounts> rows;
    std::vector<uint8_t> fates;  ///< by scene triangle, a TriangleFate: kCovers where it covers a sample, shown or not
    uint64_t bytes = 0;          ///< of the tables that it took besides, where there are any: the largest of those at one time

    [[nodiscard]] RowCounts total() const;
};

/// A picture by the depth buffer: every triangle in its order; each of its samples is compared with the depth stored at the pixel
/// and replaces it where it is nearer. At equal depths the first one drawn stays. `parallel`, by bands of rows, and `simd` change
/// nothing in the picture. Throws Error(Interrupted) soon after a stop is requested.
[[nodiscard]] RasterPicture drawDepthBuffer(const SceneOnRaster& scene, bool parallel = true,
                                            RasterSimd simd = availableRasterSimd().back(), const Progress& progress = {});

/// What the depth buffer did with one triangle.
struct FollowedTriangle {
    uint32_t triangle = 0;  ///< of the scene
    uint64_t samples = 0;   ///< that it covers
    uint64_t written = 0;   ///< of these, where it is nearer
    uint64_t first = 0;     ///< of these, where nothing was stored before
    // At the first sample where it is nearer, or else at the first one: the pixel, the triangle's depth and the stored one.
    int column = 0, row = 0;
    float depth = 0.0f, stored = 0.0f;
};
/// Triangles whose boxes in the picture have more pixels together are not followed: it would take longer than a few hundredths
/// of a second.
inline constexpr uint64_t kMostFollowed = 1 << 24;
/// A picture with what became of each triangle.
struct FollowedPicture {
    RasterPicture drawn;                      ///< as drawDepthBuffer's, to the bit, with its counts
    std::vector<FollowedTriangle> triangles;  ///< those that cover a sample
};
/// The same drawing, one triangle after the other. None where there are more than kMostFollowed pixels to look at.
[[nodiscard]] std::optional<FollowedPicture> followDepthBuffer(const SceneOnRaster& scene, const Progress& progress = {});

}  // namespace cullscope
