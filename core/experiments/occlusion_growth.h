#pragma once

#include <string>
#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope {

/// How large the scenes of the experiments on growth are, and how they are measured.
struct OcclusionGrowthSize {
    std::string court = "plant";          ///< the scene of each court
    std::vector<int> courts{1, 2, 4, 8};  ///< along each side
    std::vector<int> bunnies{4, 13};      ///< likewise, of the field: 1.1 and 12 million triangles of the installed bunny
    int views = 8;
    Viewport size{640, 480};
    int repetitions = 3;  ///< of each frame (unless the user says how often)
};

/// The sizes for a graphics card: a field of up to 10^9 triangles, and 961 courts, which are as many of a court of 10^6.
[[nodiscard]] OcclusionGrowthSize sizeForGraphicsCard();

/// "occlusion-growth": the time of a frame in one of ever more courts (`courts:`), none of which is seen from another.
/// "occlusion-sizes": the same over a field of ever more bunnies, of which the first rows hide most of the others.
[[nodiscard]] std::vector<Experiment> occlusionGrowth(const OcclusionGrowthSize& size = {});

}  // namespace cullscope
