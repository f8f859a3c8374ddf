#pragma once

#include "core/image/plot_drawing.h"

namespace cullscope {

/// Words that stand at points of a plot.
struct PointLabel {
    PlotPoint point;
    std::string words;
};

/// Where the words stand: above or below their points or a little to the side of that, inside `bounds` where there is room, and
/// over no other words or point, of which each takes `marker` pixels in both directions.
[[nodiscard]] std::vector<PlotBox> placeLabels(const std::vector<PointLabel>& labels, const PlotStyle& style,
                                               const PlotBox& bounds, double marker);

/// Writes them; a line leads from words to a point that is not next to them.
void drawLabels(PlotDrawing& drawing, const std::vector<PointLabel>& labels, const PlotStyle& style, const PlotBox& bounds,
                double marker);

}  // namespace cullscope
