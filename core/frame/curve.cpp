#include "core/frame/curve.h"

#include <algorithm>

namespace cullscope {

const CurveInterval* Curve::intervalAt(double value) const {
    if (intervals.empty()) return nullptr;
    const auto after = std::ranges::upper_bound(intervals, value, {}, &CurveInterval::from);
    return after == intervals.begin() ? &intervals.front() : &*std::prev(after);
}

}  // namespace cullscope
