#include "core/frame/curve.h"

#include <algorithm>

namespace cullscope {

const CurveInterval* Curve::intervalAt(double value) const {
    if (intervals.empty()) return nullptr;
    const auto after = std::ranges::upper_bound(intervals, value, {}, &CurveInterval::from);
    return after == intervals.begin() ? &intervals.front() : &*std::prev(after);
}

Curve curveUpTo(Curve curve, double x) {
    for (CurveArea& area : curve.areas) std::erase_if(area.boxes, [x](const CurveArea::Box& box) { return box.left >= x; });
    for (CurveLine& line : curve.lines) std::erase_if(line.points, [x](const Vec2& point) { return point.x > x; });
    // Lines that only guide the eye stay; a limit beyond x is not known yet.
    for (CurveUpright& upright : curve.uprights)
        if (upright.limit && upright.at && *upright.at > x) upright.at.reset();
    std::erase_if(curve.intervals, [x](const CurveInterval& interval) { return interval.from >= x; });
    // The first words say what the axes mean, the others what came out.
    if (curve.summary.size() > 1) curve.summary.resize(1);
    return curve;
}

}  // namespace cullscope
