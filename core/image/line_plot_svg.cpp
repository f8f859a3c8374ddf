#include <fmt/format.h>

#include "core/image/drawing_svg.h"

namespace cullscope {

std::string linePlotsSvg(const std::vector<LinePlot>& plots) {
    constexpr double kWidth = 960.0, kHeight = 480.0;
    const PlotStyle style = svgStyle();
    std::string svg = svgBeginning(kWidth, kHeight * double(plots.size()));
    for (size_t i = 0; i < plots.size(); ++i)
        svg += fmt::format("<g transform=\"translate(0,{})\">\n", kHeight * double(i)) +
               svgElements(drawPlots({plots[i]}, kWidth, kHeight, style)) + "</g>\n";
    return svg + "</svg>\n";
}

}  // namespace cullscope
