#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope::benchmark {

/// The numbers of faces of the experiments about growth.
inline constexpr std::array kGrowingFaces{10'000u, 30'000u, 100'000u, 300'000u, 1'000'000u, 3'000'000u, 10'000'000u};

/// Boxes and spheres a second by the frustum tests: the naive loop, the batch on every level, the hierarchy, and merely reading;
/// up to so many objects.
[[nodiscard]] Experiment frustumTests(size_t largest);

/// Bytes and build times of the three spherical maps (Han & Hong 2008, Table 1) over the number of faces, resolution on auto: of
/// spheres and, where a file is named, of its mesh resampled to the same counts.
[[nodiscard]] Experiment sphericalMapsGrowth(const std::filesystem::path& meshFile = {});

/// `spherical-lossless`: its build time beside that of Embree's tree of the same mesh, and its bytes.
[[nodiscard]] Experiment losslessBuild(const std::vector<std::string>& scenes, int rounds);
/// Its bytes and build time over the number of faces.
[[nodiscard]] Experiment losslessGrowth();
/// How its culls are measured.
struct LosslessCullSize {
    size_t views = 6;  ///< of each path
    int repetitions = 5;
    Viewport picture{320, 240}, large{1920, 1080};
    size_t camerasBy = 100'000;  ///< faces of the tessellation that the cameras are chosen for
};
/// Nodes and time of one of its culls over the number of faces, with equal pictures: one star in ever finer tessellations, the
/// same cameras.
[[nodiscard]] Experiment losslessCull(const LosslessCullSize& size = {});
/// Both layouts of its map, over scenes and resolutions; so many views of each path.
[[nodiscard]] Experiment losslessLayouts(const std::vector<std::string>& scenes, size_t views = 6);

/// `depth-buffer` and `scan-line` beside `all` and `backface`, over a camera path: frames, and the pictures alone. The limits are
/// those of the last scene.
[[nodiscard]] Experiment softwareRaster(const std::vector<std::string>& scenes, const std::string& path);
/// `octree-query` beside `backface` on layers that fill the picture (a scene of the generator `layers`, seen from its front), and
/// on walks through other scenes.
[[nodiscard]] Experiment octreeQueryBesideBackface(const std::string& layers, const std::vector<std::string>& others,
                                                   const Viewport& size = {});
/// Both forms of occlusion buffers on one processor: a picture of all occluders, and a question about each object, from poses of
/// a tour of the objects.
[[nodiscard]] Experiment occlusionBuffers(const std::string& occluders, const std::string& objects, size_t poses,
                                          const Viewport& size);

}  // namespace cullscope::benchmark
