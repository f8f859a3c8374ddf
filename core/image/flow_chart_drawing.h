#pragma once

#include "core/frame/flow_chart.h"
#include "core/image/plot_drawing.h"

namespace cullscope {

/// Colours of a flow chart's boxes; the letters' are PlotStyle::text.
struct FlowColours {
    PlotColour line = 0xFF666666, structure = 0xFFE8EDF2, lit = 0xFFFFD54A, litText = 0xFF111111;
};

/// A flow chart within a width, with the boxes of a listing's line lit (0: none). `say` gives a marked text in the user's
/// language. `height` becomes what it needs.
[[nodiscard]] PlotDrawing drawFlowChart(const FlowChart& chart, uint8_t line, double width, double& height,
                                        const PlotStyle& style, const FlowColours& colours,
                                        const std::function<std::string(const std::string& text)>& say);

}  // namespace cullscope
