#pragma once

#include <QPainter>

#include "core/image/plot_drawing.h"
#include "ui/plots/plot_colours.h"

namespace cullscope::ui {

/// The colours and letters with which core lays plots out.
[[nodiscard]] PlotStyle plotStyle(const QFont& font, const PlotColours& colours);

/// Paints what core laid out, from the painter's origin on, in the font that it was laid out for.
void paintDrawing(QPainter& painter, const PlotDrawing& drawing);

}  // namespace cullscope::ui
