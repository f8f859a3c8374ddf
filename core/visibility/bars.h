#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/visibility/triangle_states.h"

namespace cullscope {

/// One count of a recorded frame, shown as a bar.
struct Bar {
    std::string name;  ///< English, marked for translation
    uint64_t value = 0;
    std::optional<TriangleState> colour{};  ///< that state's; none: the plot's own
};

/// Counts that are compared with each other, in the order in which they are shown.
struct Bars {
    std::string title;  ///< what is counted: English, marked for translation
    std::vector<Bar> bars;
};

}  // namespace cullscope
