#pragma once

#include <array>
#include <vector>

#include "core/frame/frame_context.h"
#include "core/raster/screen_triangle.h"

// What became of the triangles of a picture made in software.

namespace cullscope::software {

/// How many of an object's triangles have each fate.
using FateCounts = std::array<uint64_t, kTriangleFates>;
[[nodiscard]] std::vector<FateCounts> countFates(const Scene& scene, const std::vector<uint8_t>& fates);

/// Why a triangle with this fate is not shown.
[[nodiscard]] Cause causeOf(uint8_t fate);

/// A recorded frame says the fates of its triangles up to so many runs of them, and beyond it only those of objects.
inline constexpr size_t kMostRunsSaid = 5000;
/// Says at a line of the listing what became of an object's triangles that are not shown, consecutive ones with one fate at once.
/// Returns false, having said nothing, where that takes more decisions than `left`; else those are fewer afterwards.
bool sayFates(FrameContext& frame, uint32_t object, const std::vector<uint8_t>& fates, uint8_t line, size_t& left);

}  // namespace cullscope::software
