#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/experiments/experiment.h"
#include "core/geometry/types.h"

namespace cullscope {

/// The cells of a scene that its own planes divide, with what lies in them.
struct LectureCells {
    std::vector<std::string> leaves;  ///< C1, C2, …, those behind the planes first: the part in each, "NULL" where there is none
    std::vector<std::string> order;   ///< the parts back to front, as seen from the eye
    std::vector<std::pair<std::string, std::string>> inPlanes;  ///< planes in which parts lie, by name, and these
};

/// Builds the tree of `bsp` with `plane=given` for a scene and walks it from an eye. An object that the planes cut has numbered
/// parts (A1, A2; PartNames), those before the planes first. Several parts in one leaf are joined by "+". Throws as BspTree does.
[[nodiscard]] LectureCells lectureCells(const Scene& scene, const Vec3& eye, const Progress& progress = {});

/// The lecture's quiz and its worked example, computed from their scenes, beside the answer key.
[[nodiscard]] std::vector<Experiment> lectureQuestions();

}  // namespace cullscope
