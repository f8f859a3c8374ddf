#pragma once

#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope {

/// What the experiments on process plants vary, and how they are measured. The views are 30° wide, as in Du et al. 2017.
struct PlantFiguresSize {
    std::vector<int> plants{9'710, 5'736};  ///< pipelines of the two plants of the paper's Table 3
    int viewsOfPlants = 12;                 ///< on the walk through each
    std::vector<int> pipelines{1'942, 3'884, 5'826, 7'768, 9'710, 97'100};  ///< Figure 7, and beyond
    int views = 12;                                                         ///< on the walk through each
    int manyPipelines = 50'000, viewsOfMany = 3;                            ///< from so many on, so few views
    int curvePipelines = 971;                                               ///< of the plant of the loss curve
    std::vector<double> sides{0.25, 0.5, 1, 2, 4, 8, 16};                   ///< its thresholds, in pixels
    std::vector<double> distances{4, 8, 16, 32};                            ///< of a file's curve: pixels of the middle component
    Viewport size{1'920, 1'080};
    int repetitions = 1;  ///< of each frame (unless the user says how often)
};

/// "plant-methods", "plant-pipelines" and "plant-losses": small-feature culling after Du et al. 2017 on process plants.
[[nodiscard]] std::vector<Experiment> plantFigures(const PlantFiguresSize& size = {});

}  // namespace cullscope
