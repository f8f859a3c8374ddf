#pragma once

#include "core/visibility/object_record.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// The numbers of the groups of cells (Subject::Kind::Cells) of which decisions speak: the visible region, the boxes around it,
/// and the ranges of SphericalDecision::drawn.
struct CellGroups {
    static constexpr uint32_t kRegion = 0;

    explicit CellGroups(const SphericalDecision& decision)
        : boxes(decision.region ? uint32_t(decision.region->boxes.size()) : 0) {}

    [[nodiscard]] static uint32_t box(size_t index) { return 1 + uint32_t(index); }
    [[nodiscard]] uint32_t range(size_t index) const { return 1 + boxes + uint32_t(index); }
    /// The box or the range that has a number; none: it is that of another group.
    [[nodiscard]] std::optional<size_t> boxOf(uint32_t number) const;
    [[nodiscard]] std::optional<size_t> rangeOf(uint32_t number) const;

    uint32_t boxes;
};

// Each of these is called where what it says was found. Where a record holds no tests, they say nothing; what was found besides
// is attached all the same.

/// The entry of corner ray `number`, from 0, into the bounding sphere, or into the `box`.
void sayEntry(const CornerRay& ray, uint32_t number, bool box, ObjectRecord& record);
/// What the search along a corner ray found in a cell.
void sayWalkedCell(const SphericalMaps& maps, const WalkedCell& walked, uint32_t number, ObjectRecord& record);
/// What a corner ray found in the end.
void sayRay(const CornerRay& ray, uint32_t number, ObjectRecord& record);
/// That bands decide about an object that is not inside the frustum, as so many corner rays meet it.
void sayBranch(size_t hits, ObjectRecord& record);
/// The region between the rays' points with so many triangles in its cells, then the boxes around it.
void sayRegion(const VisibleRegion& region, uint64_t triangles, ObjectRecord& record);
/// The test of a sector of a contour band by S.
void saySector(const ContourBands& bands, uint32_t band, uint32_t sector, ObjectRecord& record);
/// The range of cells with this index in SphericalDecision::drawn, which is drawn; nothing for one without triangles, and for an
/// object that was not decided by rays or bands. `line`: of the strategy's listing.
void sayRange(const SphericalMaps& maps, const SphericalDecision& decision, size_t index, uint8_t line, ObjectRecord& record);

}  // namespace cullscope::spherical
