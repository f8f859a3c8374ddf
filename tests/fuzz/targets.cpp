#include "tests/fuzz/targets.h"

namespace cullscope::fuzz {

const std::vector<Target>& targets() {
    static const std::vector<Target> kTargets{{"bsp_tree", bsp_tree},
                                              {"camera_path", camera_path},
                                              {"certificate", certificate},
                                              {"drawn_sets", drawn_sets},
                                              {"generator", generator},
                                              {"gltf", gltf},
                                              {"hidden_objects", hidden_objects},
                                              {"inner_kernel", inner_kernel},
                                              {"lesson", lesson},
                                              {"mesh_split", mesh_split},
                                              {"obj", obj},
                                              {"octree", octree},
                                              {"off", off},
                                              {"om", om},
                                              {"packed", packed},
                                              {"picture_metadata", picture_metadata},
                                              {"ply", ply},
                                              {"polygons", polygons},
                                              {"quake_level", quake_level},
                                              {"resampling", resampling},
                                              {"result_store", result_store},
                                              {"rvm", rvm},
                                              {"session", session},
                                              {"specification", specification},
                                              {"spherical_maps", spherical_maps},
                                              {"stl", stl},
                                              {"strategy_frame", strategy_frame},
                                              {"strategy_text", strategy_text}};
    return kTargets;
}

}  // namespace cullscope::fuzz
