#pragma once

#include <string>

#include "core/frame/curve.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::spherical {

/// A band of the curve: one sector of it, or the largest sizes of all its sectors. Angles are in radians.
struct CurveBand {
    double from = 0.0, to = 0.0;
    double drawn = 0.0;   ///< largest size of its drawn sectors; 0: there are none, or all of them are empty
    double hidden = 0.0;  ///< largest size of its hidden sectors
    double horizon = 0.0;
    bool anyDrawn = false, anyHidden = false;
};
/// The bands of one sector, counted from 0; none: of all sectors together.
[[nodiscard]] std::vector<CurveBand> curveBands(const ContourBands& bands, const std::optional<uint32_t>& sector);
/// The α in radians beyond which no band is drawn; none: no hidden band lies beyond the last drawn one.
[[nodiscard]] std::optional<double> cutOf(const std::vector<CurveBand>& bands);
/// The sector, from 0, that is drawn up to the largest α before its hidden rest begins. The first one of several; 0 if no sector
/// has a hidden rest.
[[nodiscard]] uint32_t farthestCutSector(const ContourBands& bands);

/// The decision on an object's contour bands: sizes (S, or the slope) of the drawn and hidden bands over α, the largest size of
/// the nearer bands as a step line, and the angle beyond which no band is drawn. Its parts are the sectors about the axis;
/// without a `part` that there is, the one that is drawn farthest is shown. The step line is omitted for all sectors together,
/// because each sector is compared with its own bands only.
[[nodiscard]] Curve bandCurve(const SphericalDecision& decision, const std::string& object, const std::optional<uint32_t>& part);

}  // namespace cullscope::spherical
