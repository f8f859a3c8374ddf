#pragma once

#include "core/experiments/run_rows.h"

/// What the experiments after Han & Hong 2008 share.
namespace cullscope::han_hong {

inline constexpr const char* kSource = "Han & Hong 2008";
/// Section 2.2 has 144,046 faces, Table 2 has 144,078.
inline constexpr const char* kBunny = "mesh:bunny,triangles=144046";

/// Section 3: windows of 320 × 240 and 640 × 480.
inline constexpr Viewport kSmall{320, 240}, kLarge{640, 480};
/// A label of settings: the vertical field of view in degrees.
inline constexpr const char* kField = "field_degrees";

/// That the paper counts no lost pixels.
[[nodiscard]] Message lossNote();
/// How many faces the paper's bunny has, and that of the tables; other scenes go without this note.
[[nodiscard]] Message facesNote();

/// The rows of runs, with the faces considered and those in the frustum, the cases found, and the corner rays that hit.
[[nodiscard]] Rows sphericalRows(const Setting& setting, const MeasureResult& result);
/// The columns of such rows: those of the axes first, then `paper`.
[[nodiscard]] std::vector<ResultColumn> timedColumns(const std::vector<Axis>& axes, const std::vector<ResultColumn>& paper);

/// A timed setting of the bunny along a path, with `spherical` on screen.
[[nodiscard]] Setting bunnySetting(const std::string& path, Viewport size);
/// The strategies that the paper compares, the strong baseline, further ones, and the limit of culling, to be measured in turns.
[[nodiscard]] Axis strategiesAxis(const std::vector<std::string>& further);
/// Adds a setting with what the experiment's axes vary within it.
void addTimed(Experiment& experiment, const Setting& setting);

/// The same experiment, which also measures any other scene: then without what the paper states of its own.
[[nodiscard]] Experiment withOtherScenes(Experiment experiment);

}  // namespace cullscope::han_hong
