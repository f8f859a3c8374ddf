#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include "core/frame/cause.h"
#include "core/frame/frame_context.h"
#include "core/visibility/object_record.h"
#include "core/visibility/pixel_cover.h"
#include "core/visibility/sampled_triangles.h"

namespace cullscope {

/// Triangles by why they were left out.
using CulledByCause = std::array<uint64_t, kCauseCount>;

/// The cause for which most of the culled triangles were culled.
[[nodiscard]] inline Cause mainCause(const CulledByCause& culled) {
    return Cause(std::ranges::max_element(culled) - culled.begin());
}

/// Of the drawn parts of an object the triangles that certainly show nothing (SampledTriangles); none where testing them would
/// cost more than it saves: where the picture has many pixels for each, or few of them are left out. `corners`: of the instance's
/// mesh, in the order of `drawn`; `cover`: of the frame's view.
[[nodiscard]] std::optional<SampledTriangles::Found> leaveOutTriangles(const FrameContext& frame, const PixelCover& cover,
                                                                       uint32_t instance, const CornerBlocks& corners,
                                                                       std::span<const PlaceRun> drawn);

/// Adds what was left out so to what an object's parts left out.
void addLeftOut(const SampledTriangles::Found& found, CulledByCause& culled);

/// Says of each drawn part which of its triangles were left out, at a line of the strategy's listing.
void sayLeftOut(const SampledTriangles::Found& found, std::span<const PlaceRun> drawn, uint8_t line, ObjectRecord& record);

/// The triangles of some runs.
[[nodiscard]] uint64_t triangleCount(std::span<const PlaceRun> runs);

}  // namespace cullscope
