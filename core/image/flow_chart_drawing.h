#pragma once

#include "core/frame/flow_way.h"
#include "core/image/plot_drawing.h"

namespace cullscope {

/// Colours of a flow chart's boxes; the letters' are PlotStyle::text.
struct FlowColours {
    PlotColour line = 0xFF666666, structure = 0xFFE8EDF2, lit = 0xFFFFC21A, litText = 0xFF111111;
    PlotColour way = 0xFF1B5FAA, passed = 0xFFCFE2F6,
               passedText = 0xFF111111;  ///< the way taken: its arrows and edges, its boxes
};

/// A flow chart within a width, with the boxes of a listing's line lit (0: none). `say` gives a marked text in the user's
/// language. `height` becomes what it needs. `way`: its boxes and arrows are drawn as passed.
[[nodiscard]] PlotDrawing drawFlowChart(const FlowChart& chart, uint8_t line, double width, double& height,
                                        const PlotStyle& style, const FlowColours& colours,
                                        const std::function<std::string(const std::string& text)>& say, const FlowWay& way = {});

}  // namespace cullscope
