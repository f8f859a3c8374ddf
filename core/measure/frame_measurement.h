#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/submitted.h"
#include "core/measure/accuracy.h"
#include "core/measure/statistics.h"
#include "core/measure/timed_rounds.h"

namespace cullscope {

/// The measurement of one strategy at one view: at a pose of a path, or in a view of the desktop.
struct FrameMeasurement {
    size_t pose = 0;
    double frameMilliseconds = 0.0;  ///< median; cull + draw of all windows
    double cullMilliseconds = 0.0;   ///< median
    std::vector<Stage> stages;       ///< of one cull
    std::vector<double> frameTimes;  ///< milliseconds, by repetition; in files only as their median
    std::vector<double> cullTimes;   ///< likewise, of the culls
    int repetitions = 0;
    Submitted submitted;                                  ///< of one window
    uint64_t consideredTriangles = 0;                     ///< of one window; given to OpenGL, whole triangles and fragments alike
    std::array<uint64_t, kCauseCount> culledTriangles{};  ///< of one window, by Cause (FrameCounters)
    std::vector<CullPart> parts;                          ///< of one window (FrameCounters)
    std::vector<NamedFigure> figures;                     ///< of one window (FrameCounters)
    uint64_t nodesVisited = 0;                            ///< of one window (FrameCounters)
    uint64_t frameBytes = 0;                              ///< of one window (FrameLog::frameBytes)
    std::optional<Accuracy> accuracy;
    bool ownRaster = false;             ///< the frame shows other surfaces than the scene's, or in an order of its own
    uint64_t missedBeyondSnapping = 0;  ///< with `ownRaster`, or where the reference has another facing rule than the strategy

    uint64_t lostPixels = 0;                ///< JudgedFrame::lostPixels
    uint64_t wronglyNearerPixels = 0;       ///< extra pixels, without those that the raster's snapping explains
    uint64_t toggledPixels = 0;             ///< that are lost in this frame or in the one before on the path, and not in both
    std::vector<LostObject> lostObjects{};  ///< whose pixels are lost
    /// The shaded picture beside that of everything (field_figures.h); empty: they are equal, or were not compared.
    std::vector<uint32_t> pictureDifferences{};
};

/// The figures of the frames that were timed at a view so far, at least one of them counted; without what they lost.
[[nodiscard]] FrameMeasurement measurementOf(const TimedFrames& timed);

/// Adds what the frame lost. `lost`: the objects whose pixels those are.
void addLosses(FrameMeasurement& figures, const JudgedFrame& judged, std::vector<LostObject> lost = {});

/// "×" in a view's header, a table, a report, a paper's row and a file: ratioOfTotals of the frame times at the same views.
[[nodiscard]] RatioEstimate ratioOver(std::span<const FrameMeasurement> baseline, std::span<const FrameMeasurement> subject);

}  // namespace cullscope
