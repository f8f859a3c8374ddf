#pragma once

#include "core/visibility/registry.h"

namespace cullscope::baseline {

/// `oracle`: exactly the visible triangles of the view, or exactly the visible objects or clusters (`by`), found beforehand and
/// outside of the frame's times: what any culling of that unit could gain at most. Exact by triangles, else conservative.
[[nodiscard]] RegisteredStrategy oracle();

}  // namespace cullscope::baseline
