#pragma once

#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope {

/// What the table of the lecture's methods varies, and how it is measured.
struct LectureTableSize {
    std::vector<int> overlaps{1, 2, 8, 32};         ///< layers of which each fills the picture
    std::vector<int> surfaces{10, 1'000, 100'000};  ///< triangles of all layers together, two a layer at least
    std::vector<int> views{1, 100};                 ///< of the static scene
    Viewport size{320, 240};
    int repetitions = 5;             ///< of a single view; of many views each is drawn once (unless the user says how often)
    double secondsOfAMethod = 20.0;  ///< of counted frames in one setting, after which it is given up
};

/// "lecture-table": the lecture's methods of visible-surface determination beside each other, in time and memory, and its
/// verdicts on them (section "Comparisons").
[[nodiscard]] Experiment lectureTable(const LectureTableSize& size = {});

/// The ids of the strategies that it compares: the lecture's six methods, the depth buffer in software and on the GPU.
[[nodiscard]] std::vector<std::string> lectureMethods();

}  // namespace cullscope
