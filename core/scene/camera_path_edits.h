#pragma once

#include "core/scene/camera_path.h"

namespace cullscope {

/// The poses `first` … `last` of a path, both of which it has, under its name.
[[nodiscard]] CameraPath trimmed(const CameraPath& path, size_t first, size_t last);

/// A path without the jerks of a hand: each eye and each point looked at is the mean over the pose, twice its weight, and both of
/// its neighbours. The first and the last pose stay. Where the means fall together or a direction would be lost, a pose stays as
/// it is.
[[nodiscard]] CameraPath smoothed(const CameraPath& path);

}  // namespace cullscope
