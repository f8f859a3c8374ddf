#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/frame/frame_log.h"
#include "core/visibility/spherical/contour_bands.h"

namespace cullscope::spherical {

/// An object's bands while they are tested one sector after the other, and until it is said what became of the object.
struct BandsSoFar {
    ContourBands bands;
    std::vector<std::optional<Containment>> found;  ///< by ContourBands::table; none: not tested yet
};

/// Of the objects in hand after so many decisions of a recorded frame, by instance. Bands of slopes, which all are drawn in part,
/// are not among them.
[[nodiscard]] std::map<uint32_t, BandsSoFar> bandsInHand(const FrameLog& log, size_t decisions);

/// The cells with triangles, in ascending runs between whose cells there may only be cells without.
struct CellsSoFar {
    std::vector<CellRun> drawn;      ///< of sectors that were found to be drawn, wholly or within 90° of the axis
    std::vector<CellRun> undecided;  ///< of sectors that were not tested yet
};
[[nodiscard]] CellsSoFar cellsSoFar(const BandCells& cells, const BandsSoFar& of);

}  // namespace cullscope::spherical
