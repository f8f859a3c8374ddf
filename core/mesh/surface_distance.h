#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/base/progress.h"
#include "core/geometry/types.h"

namespace cullscope {

/// The distance of a surface from others between the same points.
class SurfaceDistance {
public:
    /// `points` and `indices` (three for each triangle) outlive this object.
    SurfaceDistance(std::span<const Vec3f> points, std::span<const uint32_t> indices);
    ~SurfaceDistance();
    SurfaceDistance(const SurfaceDistance&) = delete;
    SurfaceDistance& operator=(const SurfaceDistance&) = delete;

    /// An upper bound on the Hausdorff distance: no point of either surface lies farther than this from the other. By branch and
    /// bound: exact distances at corners, and triangles divided into four as long as a point within one might lie farther than
    /// what is known. At most a tenth above the true distance, or 1/4096 of the surfaces' extent. Infinity where one surface
    /// alone has no triangles. Throws Error(Interrupted) on a stop request.
    [[nodiscard]] double to(std::span<const uint32_t> other, const Progress& progress = {}) const;

private:
    struct Surface;
    std::unique_ptr<const Surface> m_surface;
};

}  // namespace cullscope
