#pragma once

#include <array>
#include <set>
#include <string>
#include <vector>

namespace cullbench_random_lines {

/// Valid pieces. Files lie in ../../in, see writeInputs.
inline const std::vector<std::string> kScenes{"sphere:triangles=80",
                                              "torus:triangles=200",
                                              "star:seed=3,triangles=120",
                                              "field:mesh=sphere:triangles=20,n=2",
                                              "layers:count=2,triangles=8",
                                              "split:mesh=sphere:triangles=80,by=clusters,triangles=20",
                                              "mesh:sphere:triangles=320,triangles=80",
                                              "teapot:triangles=200",
                                              "quiz",
                                              "../../in/good.obj",
                                              "../../in/good.ply",
                                              "../../in/good.stl",
                                              "../../in/a=b,c=d.obj",
                                              "../../in/\xEA\xB8\xB0.obj",
                                              "../../in/esc\x1b]0;t\x07.obj",
                                              "field:mesh=../../in/good.obj,n=2"};
inline const std::vector<std::string> kStrategies{"all",
                                                  "backface",
                                                  "frustum",
                                                  "frustum:box=length",
                                                  "frustum-octree",
                                                  "spherical",
                                                  "spherical:rows=45",
                                                  "spherical-lossless",
                                                  "occlusion-depth",
                                                  "occlusion-masked",
                                                  "octree-query",
                                                  "occlusion-chc",
                                                  "occlusion-hiz",
                                                  "painter",
                                                  "scan-line",
                                                  "depth-buffer",
                                                  "draw-distance",
                                                  "bsp"};
inline const std::vector<std::string> kPaths{"orbit:1", "fibonacci:2", "walk:1", "front:1", "../../in/path.json"};
inline const std::vector<std::string> kSizes{"16x16", "32x24", "1x1", "64X48"};

/// A value that some option should refuse, or take, and the statuses that may come of it.
struct HostileValue {
    std::string value;
    std::set<int> statuses;
};

/// What is tried as the value of a command's option; `option` is empty for a positional word, whose number is `place`.
[[nodiscard]] const std::vector<HostileValue>& hostileValues(const std::string& command, const std::string& option, size_t place);

[[nodiscard]] bool commandTakes(const std::string& command, const std::string& option);

}  // namespace cullbench_random_lines
