#include <fmt/format.h>

#include "core/image/drawing_svg.h"

namespace cullscope {

std::string linePlotsSvg(const std::vector<LinePlot>& plots) {
    const PlotStyle style = svgStyle();
    std::string svg = svgBeginning(kPlotWidth, kPlotHeight * double(plots.size()));
    for (size_t i = 0; i < plots.size(); ++i)
        svg += fmt::format("<g transform=\"translate(0,{})\">\n", kPlotHeight * double(i)) +
               svgElements(drawPlots({plots[i]}, kPlotWidth, kPlotHeight, style)) + "</g>\n";
    return svg + "</svg>\n";
}

}  // namespace cullscope
