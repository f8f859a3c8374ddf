#pragma once

#include <QString>

#include "core/gpu/context.h"
#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// The parameters that a frame's strategy moves by itself, with their values: `threshold 0.004 · outline 15 %`; empty: none.
[[nodiscard]] QString heldWords(const FrameLog& log);
/// Line 2 of a view's header: `×3.1 · 15 % · 0 missed`, behind it the words above; "…" while the metrics are stale.
[[nodiscard]] QString metricsLine(const ViewMetrics& figures);
/// How many of the covered pixels are lost, and the largest hole; on a second line the snappedSentence. Of figures that are
/// ready.
[[nodiscard]] QString missedSentence(const ViewMetrics& figures);
/// How many pixels differ within the raster's snapping, which is no loss; empty: none.
[[nodiscard]] QString snappedSentence(const ViewFigures& figures);
/// All metrics that the header does not show, in several lines.
[[nodiscard]] QString metricsDetails(const ViewMetrics& figures, const GlInfo& gl);

/// The fragments that a strategy made and submitted in place of the scene's triangles.
[[nodiscard]] QString fragmentsSentence(const Submitted& submitted);

/// The speed of a view with its interval.
[[nodiscard]] QString speedSentence(const ViewFigures& figures);

/// What any culling could gain at most, and which share of that the strategy gains.
[[nodiscard]] QString headroomSentence(const ViewHeadroom& headroom);

/// A view's name and its metrics.
struct NamedMetrics {
    QString name;
    const ViewMetrics* figures;
};

/// How many times as fast the fastest of several strategies is as the next one, with its 95 % interval: "B is 1.2 times as fast
/// as A". Of views whose frames of one camera and size were timed in the same turns; empty where those are fewer than two
/// different strategies.
[[nodiscard]] QString fastestSentence(const std::vector<NamedMetrics>& views);

}  // namespace cullscope::ui
