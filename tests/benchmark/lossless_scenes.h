#pragma once

#include <array>
#include <string>

#include "core/scene/camera_path.h"
#include "core/spatial/direction_map.h"
#include "tests/support/culler.h"

namespace cullscope::benchmark {

/// A triangle mesh with the same arrays and without cached properties: no bounding sphere, no topology.
[[nodiscard]] MeshPointer freshCopy(const TriangleMesh& mesh);
/// One instance of the mesh with the identity transform.
[[nodiscard]] ScenePointer sceneOf(MeshPointer mesh);

/// `spherical-lossless` before its build. `facing`: "auto", "front".
[[nodiscard]] test::CullerPointer lossless(MapLayout layout, uint32_t level, bool horizon, const char* facing);

/// The same as `strategyFromText` reads it.
[[nodiscard]] std::string losslessText(MapLayout layout, uint32_t level, bool horizon, const char* facing);

/// Paths on which the frustum cuts an object, and one that has the whole object in view, from all sides.
inline constexpr std::array kObjectPaths{"case-1", "case-2", "case-3", "within"};
/// One of them.
[[nodiscard]] CameraPath objectPath(const std::string& name, const Scene& scene, size_t views);

}  // namespace cullscope::benchmark
