#pragma once

#include "core/measure/meter.h"

namespace cullscope::benchmark {

/// The mean of a figure over the views of a run, which has some.
template <typename Figure>
[[nodiscard]] double meanOver(const RunMeasurement& run, const Figure& figure) {
    double sum = 0.0;
    for (const FrameMeasurement& frame : run.frames) sum += figure(frame);
    return sum / double(run.frames.size());
}

}  // namespace cullscope::benchmark
