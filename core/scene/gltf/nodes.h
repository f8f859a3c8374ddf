#pragma once

#include <functional>
#include <string>

#include "core/geometry/types.h"
#include "core/scene/gltf/accessors.h"

namespace cullscope::gltf {

/// A mesh where it stands.
struct PlacedMesh {
    int node = 0, mesh = 0;
    Mat4 worldFromMesh{1.0};
};

/// Calls `place` for every mesh of the scene that is to be shown: the default one, or else the first, or else all nodes without a
/// parent. A node's instances (EXT_mesh_gpu_instancing) come one after the other. Throws Error(Input) where nodes form no tree,
/// name what the file does not have, or have transforms that are none.
void placeMeshes(const tinygltf::Model& model, const Accessors& accessors, const std::string& fileName,
                 const std::function<void(const PlacedMesh&)>& place);

}  // namespace cullscope::gltf
