#pragma once

#include <array>
#include <cmath>

#include "core/raster/screen_triangle.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

// From a mesh's positions to the raster; for the source files of this folder.

namespace cullscope {

using Clip = float __attribute__((vector_size(16)));  // x, y, z, w

/// Triangles reach at most so many pixels from the picture's lower left corner: with 1/256 pixel less than 2^23.
inline constexpr float kRasterRange = 32000.0f;

/// Beyond which planes a vertex lies, and beyond which limits of the raster.
struct Beyond {
    enum : uint32_t { Left = 1, Right = 2, Bottom = 4, Top = 8, Near = 16, Far = 32, Range = 64, Nowhere = 128 };
    static constexpr uint32_t kPlane = Left | Right | Bottom | Top | Near | Far;
    static constexpr uint32_t kNeedsClipping = Near | Range;
};

/// From the positions of an instance's mesh to the raster.
class Projection {
public:
    Projection(const View& view, const Scene& scene, size_t instance)
        : m_halfWidth(0.5f * float(view.viewport().width)),
          m_halfHeight(0.5f * float(view.viewport().height)),
          m_rangeX(kRasterRange / m_halfWidth - 1.0f),
          m_rangeY(kRasterRange / m_halfHeight - 1.0f) {
        const Mat4f matrix = view.clipFromPositions(scene.instances()[instance].worldFromMesh, scene.meshOf(instance).origin());
        for (int c = 0; c < 4; ++c) m_columns[size_t(c)] = Clip{matrix[c].x, matrix[c].y, matrix[c].z, matrix[c].w};
    }

    /// For the kernels, which do the same.
    [[nodiscard]] RasterProjection forKernels() const {
        RasterProjection result{};
        for (size_t column = 0; column < 4; ++column)
            for (int axis = 0; axis < 4; ++axis) result.columns[column][axis] = m_columns[column][axis];
        result.halfWidth = m_halfWidth;
        result.halfHeight = m_halfHeight;
        // A little less than where `beyond`, which computes in double precision, draws the line.
        result.rangeX = m_rangeX * (1.0f - 0x1p-20f);
        result.rangeY = m_rangeY * (1.0f - 0x1p-20f);
        result.left = Beyond::Left;
        result.right = Beyond::Right;
        result.bottom = Beyond::Bottom;
        result.top = Beyond::Top;
        result.far = Beyond::Far;
        return result;
    }

    [[nodiscard]] Clip clip(const Vec3f& position) const {
        return ((m_columns[0] * position.x + m_columns[1] * position.y) + m_columns[2] * position.z) + m_columns[3];
    }

    [[nodiscard]] RasterVertex vertex(const Clip& clip) const {
        const float x = clip[0], y = clip[1], z = clip[2], w = clip[3];
        RasterVertex vertex{0, 0, 0.0f, beyond(clip)};
        if ((vertex.beyond & (Beyond::kNeedsClipping | Beyond::Nowhere)) != 0) return vertex;
        const float inverse = 1.0f / w;
        vertex.x = snapped(x * inverse * m_halfWidth + m_halfWidth);
        vertex.y = snapped(y * inverse * m_halfHeight + m_halfHeight);
        vertex.depth = z * inverse;
        return vertex;
    }

    /// How far a point lies within a limit of the raster: 0 is the near plane, 1 to 4 the range to the left, right, bottom, top.
    [[nodiscard]] double within(int limit, const Clip& clip) const {
        const double x = clip[0], y = clip[1], z = clip[2], w = clip[3];
        switch (limit) {
            case 0:
                return w - z;
            case 1:
                return double(m_rangeX) * w + x;
            case 2:
                return double(m_rangeX) * w - x;
            case 3:
                return double(m_rangeY) * w + y;
            default:
                return double(m_rangeY) * w - y;
        }
    }
    static constexpr int kLimits = 5;

    /// A corner of a clipped polygon, which rounding may have moved beyond a limit by a little.
    [[nodiscard]] RasterVertex clippedVertex(Clip clip) const;

private:
    [[nodiscard]] uint32_t beyond(const Clip& clip) const {
        const float x = clip[0], y = clip[1], z = clip[2], w = clip[3];
        // Nearly all vertices of what is in view.
        if (std::abs(x) <= w && std::abs(y) <= w && z >= 0.0f && z <= w && w > 0.0f && w < 0x1p98f) return 0;
        // The comparisons are false for what is not a number.
        if (!(std::abs(x) + std::abs(y) + std::abs(z) + std::abs(w) < 0x1p100f)) return Beyond::Nowhere;
        uint32_t result = (x < -w ? Beyond::Left : 0u) | (x > w ? Beyond::Right : 0u) | (y < -w ? Beyond::Bottom : 0u) |
                          (y > w ? Beyond::Top : 0u) | (z > w ? Beyond::Near : 0u) | (z < 0.0f ? Beyond::Far : 0u);
        // Nearly all are within the range by far; for the others in double, as `within`: both must agree on every vertex.
        if (!(std::abs(x) <= w && std::abs(y) <= w) &&
            (std::abs(double(x)) > double(m_rangeX) * w || std::abs(double(y)) > double(m_rangeY) * w || !(w > 0.0f)))
            result |= Beyond::Range;
        if (!(w > 0.0f)) result |= Beyond::Range;
        return result;
    }
    [[nodiscard]] static int32_t snapped(float pixels) { return int32_t(std::lrintf((pixels - 0.5f) * float(kSubPixels))); }

    std::array<Clip, 4> m_columns;
    float m_halfWidth, m_halfHeight;
    float m_rangeX, m_rangeY;  ///< in units of w
};

}  // namespace cullscope
