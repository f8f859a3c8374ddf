#pragma once

#include "core/experiments/experiment.h"

namespace cullscope::benchmark {

/// Every step of the named own lessons (none: of all) in a window, `times` times: from going to it until its scene, pictures and
/// panels are on screen, at most a second with the default scene and two with another one, which may be larger. Needs a
/// QApplication.
Experiment lessonLatency(int times, std::vector<std::string> lessons = {});

}  // namespace cullscope::benchmark
