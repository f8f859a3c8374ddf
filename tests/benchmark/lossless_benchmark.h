#pragma once

#include <chrono>
#include <filesystem>
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
/// The first mesh of the scene with this specification.
[[nodiscard]] MeshPointer meshOf(const std::string& specification);

/// `spherical-lossless` before its build. `facing`: "auto", "front".
[[nodiscard]] test::CullerPointer lossless(MapLayout layout, uint32_t level, bool horizon, const char* facing);

/// Views of a scene at 320 × 240: case-1 to case-3, close views that cut it, and views from all sides of the whole object.
struct Views {
    std::string name;
    std::vector<View> views;
};
[[nodiscard]] std::vector<Views> cutAndWithin(const Scene& scene, size_t each);

[[nodiscard]] double medianOf(const std::vector<double>& values);
[[nodiscard]] double meanOf(const std::vector<double>& values);

/// The milliseconds that a call takes.
template <typename Call>
double timeOf(const Call& call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The benchmarks; exit status 1 where a promise of the project does not hold.
int buildBesideEmbree(const std::string& specification, int rounds);
int growth(const std::filesystem::path& folder);
int cullByFaces(const std::filesystem::path& folder);
int layouts(const std::filesystem::path& folder, const std::vector<std::string>& specifications);

}  // namespace cullscope::benchmark
