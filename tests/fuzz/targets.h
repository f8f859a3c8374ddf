#pragma once

#include <string_view>
#include <vector>

namespace cullscope::fuzz {

/// A target does with an input what the programs do with a file or an argument of that content. It returns where the input is
/// taken, and where it is refused as it should be; everything else is a finding.
struct Target {
    const char* name;  ///< of its function, its source in tests/fuzz/targets, and its folders of seeds and findings
    void (*run)(std::string_view input);
};

/// Every target.
[[nodiscard]] const std::vector<Target>& targets();

// Files.
void camera_path(std::string_view input);
void certificate(std::string_view input);
void drawn_sets(std::string_view input);
void gltf(std::string_view input);  ///< text and binary
void lesson(std::string_view input);
void obj(std::string_view input);
void off(std::string_view input);
void om(std::string_view input);
void packed(std::string_view input);            ///< gzip and xz
void picture_metadata(std::string_view input);  ///< the first byte says which format
void ply(std::string_view input);
void polygons(std::string_view input);
void quake_level(std::string_view input);
void result_store(std::string_view input);
void rvm(std::string_view input);
void session(std::string_view input);
void stl(std::string_view input);

// Arguments.
void generator(std::string_view input);  ///< opens the scene
void hidden_objects(std::string_view input);
void specification(std::string_view input);  ///< only reads the text
void strategy_text(std::string_view input);

// What is built from a mesh; the input is decoded by small_scene.h.
void bsp_tree(std::string_view input);
void inner_kernel(std::string_view input);
void mesh_split(std::string_view input);
void octree(std::string_view input);
void resampling(std::string_view input);
void spherical_maps(std::string_view input);
void strategy_frame(std::string_view input);  ///< any strategy, built and culling

}  // namespace cullscope::fuzz
