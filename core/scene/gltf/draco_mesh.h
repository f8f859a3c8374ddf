#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/scene/gltf/container.h"

namespace cullscope::gltf {

/// A mesh of KHR_draco_mesh_compression.
struct DracoMesh {
    std::vector<Vec3f> positions;
    std::vector<Vec3f> normals;  ///< empty where none were asked for
    std::vector<uint32_t> triangles;
};

/// Decodes `bytes`. The attributes are those with these numbers within it; `normals` below 0: none. Counts that the bytes state
/// are asked of `requireMemory` before the decoder makes anything of them. Throws Error(Input) where they cannot be decoded.
[[nodiscard]] DracoMesh decodeDraco(std::span<const unsigned char> bytes, int positions, int normals, const std::string& fileName,
                                    const RequireMemory& requireMemory);

}  // namespace cullscope::gltf
