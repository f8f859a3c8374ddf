#pragma once

#include "core/experiments/plant_figures.h"
#include "core/experiments/run_rows.h"

// Shared by the experiments on process plants; not for use outside of this folder.

namespace cullscope::plants {

inline constexpr const char* kPipelines = "pipelines";
inline constexpr const char* kFeature = "small-feature";
inline constexpr const char* kTriangle = "small-feature-triangle";
inline constexpr const char* kBounded = "small-feature-bounded";
inline constexpr const char* kOctree = "frustum-octree";

/// The paper's field of view, from side to side.
inline const Angle kField = Angle::fromDegrees(30.0);

/// A plant as a scene specification.
[[nodiscard]] std::string plantOf(int pipelines);
/// A path's views with the paper's field of view.
[[nodiscard]] CameraPath withField(CameraPath path, const Viewport& size);
/// Views in the middles of as many equal parts of the walk: however many there are, their mean stands for the whole walk.
[[nodiscard]] CameraPath partsOfWalk(const Scene& scene, int views, const Viewport& size);

/// The cells of plantColumns but for those of the plant.
[[nodiscard]] Row runCells(const Setting& setting, const MeasureResult& result, const RunMeasurement& run);
/// The columns of the axes, and all that may be measured.
[[nodiscard]] std::vector<ResultColumn> plantColumns(const std::vector<Axis>& axes);

/// What all settings have in common. Frames are timed as often as `size` says, and warmed up before the first view alone: of so
/// many views each is a repetition.
[[nodiscard]] Setting commonSetting(const PlantFiguresSize& size);
/// That small-feature-bounded missed no more pixels than it states.
[[nodiscard]] Check boundCheck();

/// "plant-losses".
[[nodiscard]] Experiment lossCurve(const PlantFiguresSize& size);

}  // namespace cullscope::plants
