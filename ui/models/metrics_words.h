#pragma once

#include <QString>

#include "core/gpu/context.h"
#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// Line 2 of a view's header: `×3.1 · 15 % · 0 missed`; "…" while stale.
[[nodiscard]] QString metricsLine(const ViewMetrics& figures);
/// Everything that the header has no place for, several lines.
[[nodiscard]] QString metricsDetails(const ViewMetrics& figures, const GlInfo& gl);

}  // namespace cullscope::ui
