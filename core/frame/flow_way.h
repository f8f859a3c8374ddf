#pragma once

#include "core/frame/flow_chart.h"
#include "core/frame/frame_log.h"

namespace cullscope {

/// The way of a frame through a chart: of each box and each arrow whether it was passed.
struct FlowWay {
    std::vector<bool> boxes, arrows;

    [[nodiscard]] bool passesBox(size_t box) const { return box < boxes.size() && boxes[box]; }
    [[nodiscard]] bool passesArrow(size_t arrow) const { return arrow < arrows.size() && arrows[arrow]; }
};
/// The way past the boxes of the lines at which a frame's decisions fell, in their order. From the first box on, and between two
/// such boxes, it is the shortest way along arrows; where there is none, as from one object to the next, it begins anew.
/// `ended`: the frame has ended, so that the way leads on to a box from which no arrow leads.
[[nodiscard]] FlowWay flowWay(const FlowChart& chart, const FrameLog& log, bool ended);

}  // namespace cullscope
