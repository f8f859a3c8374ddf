#pragma once

#include <QString>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/measure/meter.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {

constexpr double kPartsPerMillion = 1e6;

/// One strategy at one pose, as the plots show it.
struct PoseFigures {
    size_t pose = 0;                 ///< from 0, as in paths and result files
    double frameMilliseconds = 0.0;  ///< median of cull + draw
    uint64_t missedPixels = 0;
    std::optional<double> missedPpm;  ///< of the covered pixels; none where it was not measured
    double azimuth = 0.0;    ///< degrees in [−180, 180], of the eye seen from the scene's centre; 0 along +z, 90 along +x
    double elevation = 0.0;  ///< degrees in [−90, 90], y up
};

/// One strategy over a path, as the plots show it.
struct RunFigures {
    QString label;  ///< the strategy's id, and its parameters where they differ from the defaults
    QString id;
    bool baseline = false;  ///< the others are compared with it
    bool limit = false;     ///< what any culling could gain at most
    BaselineRole role = BaselineRole::None;
    ParameterSet parameters;
    Promise promise = Promise::Approximate;
    double frameMilliseconds = 0.0;               ///< mean over poses
    double cullMilliseconds = 0.0;                ///< mean over poses
    RatioEstimate speedup;                        ///< over the baseline with the same facing rule
    std::optional<RatioEstimate> headroomShare;   ///< Summary
    std::optional<double> missedPpm;              ///< over all poses
    bool judged = true;                           ///< TradePoint::judged
    std::map<std::string, RatioEstimate> values;  ///< by key of the figures that may be axes (tradeFigures)
    std::vector<PoseFigures> poses;
};

/// "frustum", or "frustum box=length" where a parameter is not at its default.
[[nodiscard]] QString runLabel(const StrategyRequest& strategy);

/// What the plots show of a result; runs without a measured pose are left out.
[[nodiscard]] std::vector<RunFigures> runFigures(const MeasureResult& result);

/// The missed pixels of a frame of a run that count as lost: without those that the raster's snapping explains.
[[nodiscard]] uint64_t lostPixels(const RunMeasurement& run, const FrameMeasurement& frame);

/// Where on a scale from 0 (nothing missed) to 1 (a tenth of all pixels) a loss stands; logarithmic, and never near 0 where
/// something is missed.
[[nodiscard]] double lossShare(double missedPpm);

/// A number above 0 with two significant digits, "0" only for nothing: "0.4", "12".
[[nodiscard]] QString significantText(double value);

}  // namespace cullscope::ui
