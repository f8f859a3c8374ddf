#pragma once

#include <string>

#include "core/image/plot_drawing.h"

namespace cullscope {

/// The letters of an SVG file are measured by common fonts' widths: the viewer of a file chooses its font.
[[nodiscard]] PlotStyle svgStyle();

/// The beginning of a document of that size in pixels, up to its ground; "</svg>\n" ends it.
[[nodiscard]] std::string svgBeginning(double width, double height, PlotColour ground = 0xFFFFFFFF);
/// What is drawn, as elements; text stays text.
[[nodiscard]] std::string svgElements(const PlotDrawing& drawing);

}  // namespace cullscope
