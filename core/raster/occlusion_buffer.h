#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/draw_list.h"
#include "core/raster/occlusion_tiles.h"
#include "core/raster/scene_triangles.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

struct ClippedCorners;

/// How an occlusion buffer keeps depths.
enum class OcclusionForm {
    Depth,  ///< of every pixel
    Masked  ///< two for each block of 8 × 4 pixels, and a mask: 96 bytes for 256 pixels; hides a little less
};

/// What of a picture a box may cover, and how near.
struct BoxInPicture {
    int32_t firstColumn = 0, endColumn = 0, firstRow = 0, endRow = 0;
    float depth = 0.0f;  ///< reversed; no point of the box is nearer

    /// 0 where it lies beside the picture.
    [[nodiscard]] int64_t pixels() const {
        return int64_t(std::max(endColumn - firstColumn, 0)) * std::max(endRow - firstRow, 0);
    }
    bool operator==(const BoxInPicture&) const = default;
};

/// What a buffer drew since its begin().
struct OccluderCounts {
    uint64_t given = 0;  ///< triangles
    uint64_t drawn = 0;  ///< triangles, or pieces of clipped ones

    bool operator==(const OccluderCounts&) const = default;
};

/// A picture of occluders in software, without OpenGL, which answers whether something lies behind them. It may be wrong in one
/// direction only: what it hides is not visible in the picture that OpenGL draws of a view, as long as this picture shows the
/// occluders, or what hides them.
///
/// Why: a pixel is covered by a triangle as in OpenGL's picture, with corners rounded to 1/256 pixel. Where an OpenGL rounds them
/// otherwise, an edge lies elsewhere by 1/128 pixel; so a pixel counts only together with the eight around it (a question is
/// about a pixel more on each side). Depths are pushed back by a bound on the rounding of a triangle's plane, four roundings of
/// its terms, which grows as the triangle gets narrow (occlusion_buffer.cpp); triangles narrower than a pixel are left out. A
/// masked block moves back only (occlusion_kernel.h).
///
/// Memory is kept from view to view. Not for several threads at once, but for questions.
class OcclusionBuffer {
public:
    /// `simd` changes nothing in the buffer.
    explicit OcclusionBuffer(OcclusionForm form, RasterSimd simd = availableRasterSimd().back());

    /// Begins a view's picture, without occluders.
    void begin(const View& view);
    /// Draws triangles of an instance: by its mesh's float positions, or a copy of some of them, and three indices each.
    /// `facing`: the facing rule of the frame; back faces that the frame does not draw hide nothing.
    void draw(const Scene& scene, uint32_t instance, Facing facing, std::span<const Vec3f> positions,
              std::span<const uint32_t> indices);

    /// Whether nothing was drawn: then nothing is hidden.
    [[nodiscard]] bool empty() const { return m_counts.drawn == 0; }
    [[nodiscard]] const OccluderCounts& counts() const { return m_counts; }

    /// Where a box, relative to the eye, lies in the picture, with the pixels around it. None where it reaches before the near
    /// plane: such a box is never hidden. `box` has grown by what the rounding of a picture displaces
    /// (visibility/eye_bounds.h, boxRounding); `towardsEye`: by how much what it holds may seem nearer besides.
    [[nodiscard]] std::optional<BoxInPicture> place(const EyeBox& box, double towardsEye) const;
    /// Whether occluders lie before all of it. By one thread at a time: it keeps what it finds out about tiles.
    [[nodiscard]] bool hides(const BoxInPicture& box);
    /// The same; several threads may ask while nothing is drawn. Faster after settle().
    [[nodiscard]] bool hides(const BoxInPicture& box) const;
    /// Finds out about all tiles what questions need to know.
    void settle();
    /// The farthest reversed depth of the buffer where the box lies: the box is hidden where it is above the box's own.
    [[nodiscard]] float farthestIn(const BoxInPicture& box) const;

    [[nodiscard]] OcclusionForm form() const { return m_form; }
    /// By pixel, from the lower left one, what the buffer knows of its reversed depth.
    [[nodiscard]] std::vector<float> depths() const;
    /// Of the picture, without what is only needed while triangles are drawn.
    [[nodiscard]] uint64_t bytes() const;

private:
    template <typename FarthestInTile>
    [[nodiscard]] bool depthHides(const BoxInPicture& box, const FarthestInTile& farthest) const;
    float farthestOf(size_t tile);
    [[nodiscard]] bool maskedHides(const BoxInPicture& box) const;
    [[nodiscard]] size_t tileAt(int32_t column, int32_t row) const {
        return size_t(row / kOcclusionRows) * size_t(m_tilesInRow) + size_t(column / kOcclusionColumns);
    }
    [[nodiscard]] float depthAt(int32_t column, int32_t row) const;
    void clear();
    [[nodiscard]] size_t addPieces(const ClippedCorners& clipped, size_t end);

    OcclusionForm m_form;
    RasterSimd m_simd;
    std::optional<View> m_view;
    int32_t m_tilesInRow = 0;
    bool m_cleared = false;
    std::vector<DepthTile> m_depths;
    std::vector<float> m_farthest;
    std::vector<MaskedTile> m_masked;
    OccluderCounts m_counts;
    // While triangles are drawn.
    std::vector<RasterVertex> m_vertices;
    std::vector<uint32_t> m_places;
    std::vector<uint32_t> m_onRaster;  ///< three indices of each triangle that may be an occluder, and room for more
    std::vector<OccluderTriangle> m_triangles;
};

}  // namespace cullscope
