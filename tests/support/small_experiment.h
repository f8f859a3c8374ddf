#pragma once

#include "core/measure/meter.h"
#include "core/mesh/parametric.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

inline StrategyRequest request(const std::string& id) { return {id, ParameterSet(findStrategy(id).info.parameters)}; }

/// Nine closed bodies, three poses, few repetitions: a measurement that takes a tenth of a second.
inline MeasureRequest smallExperiment(const std::vector<std::string>& strategies) {
    std::vector<Mat4> places;
    for (int i = 0; i < 9; ++i) places.push_back(translation({3.0 * (i % 3 - 1), 0, 3.0 * (i / 3 - 1)}));
    MeasureRequest experiment;
    experiment.scene = copiesOf(starMesh(7, 500), places);
    for (const std::string& id : strategies) experiment.strategies.push_back(request(id));
    experiment.path = cameraPath("walk:3", *experiment.scene);
    experiment.size = {64, 48};
    experiment.timing.fixedRepetitions = 3;
    return experiment;
}

}  // namespace cullscope::test
