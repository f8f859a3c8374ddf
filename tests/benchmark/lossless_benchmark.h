#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

#include "core/scene/scene.h"
#include "core/spatial/direction_map.h"
#include "core/visibility/strategy.h"

namespace cullscope::benchmark {

/// A triangle mesh of the same arrays of which nothing is known yet: no bounding sphere, no topology.
[[nodiscard]] MeshPointer freshCopy(const TriangleMesh& mesh);
/// One instance where the mesh is.
[[nodiscard]] ScenePointer sceneOf(MeshPointer mesh);
/// The first mesh of a scene by its specification.
[[nodiscard]] MeshPointer meshOf(const std::string& specification);

/// `spherical-lossless`, not built yet. `facing`: "auto", "front".
[[nodiscard]] StrategyPointer lossless(MapLayout layout, uint32_t level, bool horizon, const char* facing);

/// A scene's views of 320 × 240: case-1 to case-3, close by and cut, and all around from where the whole object is in view.
struct Views {
    std::string name;
    std::vector<View> views;
};
[[nodiscard]] std::vector<Views> cutAndWithin(const Scene& scene, size_t each);

[[nodiscard]] double medianOf(const std::vector<double>& values);
[[nodiscard]] double meanOf(const std::vector<double>& values);

/// Milliseconds of a call.
template <typename Call>
double timeOf(const Call& call) {
    const auto start = std::chrono::steady_clock::now();
    call();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// The benchmarks; exit status 1: what the project promises does not hold.
int buildBesideEmbree(const std::string& specification, int rounds);
int growth(const std::filesystem::path& folder);
int cullByFaces(const std::filesystem::path& folder);
int layouts(const std::filesystem::path& folder, const std::vector<std::string>& specifications);

}  // namespace cullscope::benchmark
