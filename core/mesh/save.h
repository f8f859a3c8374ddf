#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// A mesh with its transform to the world, to be written.
struct PlacedMesh {
    std::string name;
    const TriangleMesh* mesh = nullptr;
    Mat4 worldFromMesh{1.0};  ///< applied to origin + position in double
};

/// Writes OBJ (one named object for each entry, 17 significant digits), PLY (binary, in double where float would lose digits) or
/// binary STL by the extension, completely or not at all; "-" is standard output, as OBJ. Throws Error(Usage) for another
/// extension or where the file cannot be written.
void saveMeshFile(const std::filesystem::path& path, std::span<const PlacedMesh> meshes, const Progress& progress = {});

/// Throws Error(Usage) where saveMeshFile does not support the extension of this name.
void requireMeshFormat(const std::filesystem::path& path);

}  // namespace cullscope
