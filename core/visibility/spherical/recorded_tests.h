#pragma once

#include "core/base/message.h"
#include "core/frame/frame_context.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// In a scene of more objects the tests of an object's rays, bands and cells are not recorded, only their results: they would
/// take hundreds of megabytes.
inline constexpr size_t kMostWithTests = 64;

/// Says so of a frame.
inline void sayResultsAlone(FrameContext& frame) {
    frame.sayCoarser({CULLSCOPE_TR("results alone, above %1 objects"), {std::to_string(kMostWithTests)}});
}

/// The numbers of the groups of cells (Subject::Kind::Cells) of which decisions speak: the visible region, the boxes around it,
/// and the ranges of SphericalDecision::drawn.
struct CellGroups {
    static constexpr uint32_t kRegion = 0;

    explicit CellGroups(const SphericalDecision& decision)
        : boxes(decision.region ? uint32_t(decision.region->boxes.size()) : 0) {}

    [[nodiscard]] uint32_t box(size_t index) const { return 1 + uint32_t(index); }
    [[nodiscard]] uint32_t range(size_t index) const { return 1 + boxes + uint32_t(index); }
    /// The box or the range that has a number; none: it is that of another group.
    [[nodiscard]] std::optional<size_t> boxOf(uint32_t number) const;
    [[nodiscard]] std::optional<size_t> rangeOf(uint32_t number) const;

    uint32_t boxes;
};

/// Says the search along the four corner rays, cell by cell, then the region between their points and the boxes around it;
/// nothing for an object that was not decided by rays.
void recordRays(const SphericalMaps& maps, const SphericalDecision& decision, FrameContext& frame);

/// Says the tests of the contour bands, sector by sector and in each from the near point on; nothing for an object that was not
/// decided by bands.
void recordBands(const SphericalDecision& decision, FrameContext& frame);

/// Says the ranges of cells that are drawn of an object that was decided by rays or bands. `line`: of the strategy's listing.
void recordRanges(const SphericalMaps& maps, const SphericalDecision& decision, uint8_t line, FrameContext& frame);

}  // namespace cullscope::spherical
