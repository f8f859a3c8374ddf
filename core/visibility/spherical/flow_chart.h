#pragma once

#include "core/frame/flow_chart.h"

namespace cullscope::spherical {

/// The flow chart of `spherical` (Han & Hong 2008, Figure 1), drawn after the paper's text and its Appendix 1, because the figure
/// itself did not survive: the three structures that are built once, then what is done of each object in a frame.
[[nodiscard]] FlowChart flowChart();

}  // namespace cullscope::spherical
