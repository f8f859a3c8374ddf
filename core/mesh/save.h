#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// A mesh to be written, placed in the world.
struct PlacedMesh {
    std::string name;
    const TriangleMesh* mesh = nullptr;
    Mat4 worldFromMesh{1.0};  ///< applied to origin + position in double
};

/// Writes OBJ (one named object an entry, 17 significant digits), PLY (binary, double where float would lose) or binary STL
/// by the extension, whole or not at all; "-" is standard output, as OBJ. Throws Error(Usage) for another extension or an
/// unwritable place.
void saveMeshFile(const std::filesystem::path& path, std::span<const PlacedMesh> meshes, const Progress& progress = {});

}  // namespace cullscope
