#pragma once

#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "core/spatial/direction_map.h"
#include "tests/support/culler.h"

namespace cullscope::benchmark {

/// A triangle mesh with the same arrays and without cached properties: no bounding sphere, no topology.
[[nodiscard]] MeshPointer freshCopy(const TriangleMesh& mesh);
/// One instance of the mesh with the identity transform.
[[nodiscard]] ScenePointer sceneOf(MeshPointer mesh);

/// `spherical-lossless` before its build. `facing`: "auto", "front".
[[nodiscard]] test::CullerPointer lossless(MapLayout layout, uint32_t level, bool horizon, const char* facing);

/// Views of a scene at 320 × 240: case-1 to case-3, close views that cut it, and views from all sides of the whole object.
struct Views {
    std::string name;
    std::vector<View> views;
};
[[nodiscard]] std::vector<Views> cutAndWithin(const Scene& scene, size_t each);

}  // namespace cullscope::benchmark
