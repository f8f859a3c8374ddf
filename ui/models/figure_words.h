#pragma once

#include <QString>

#include "core/gpu/context.h"
#include "ui/jobs/figures.h"

namespace cullscope::ui {

/// Line 2 of a view's header: `×3.1 · 15 % · 0 missed`; "…" while stale.
[[nodiscard]] QString figureLine(const Figures& figures);
/// Everything that the header has no place for, several lines.
[[nodiscard]] QString figureDetails(const Figures& figures, const GlInfo& gl);

}  // namespace cullscope::ui
