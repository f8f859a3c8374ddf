#pragma once

#include <string>

#include "core/mesh/raw_mesh.h"
#include "core/scene/gltf/accessors.h"

namespace tinygltf {
struct Mesh;
struct Primitive;
}  // namespace tinygltf

namespace cullscope::gltf {

/// What is left out of meshes, by its kind.
struct LeftOut {
    size_t pointsAndLines = 0;     ///< primitives
    size_t withoutPositions = 0;   ///< primitives
    size_t nonFiniteVertices = 0;  ///< whose faces the assembler drops
};

/// The triangles of all primitives of a mesh as one mesh: lists, strips and fans, with indices or without, compressed or not.
/// Primitives that share their positions and normals share the vertices. A corner that names no vertex is kNoVertex. Throws
/// Error(Input) as Accessors do.
[[nodiscard]] RawMesh trianglesOf(const tinygltf::Mesh& mesh, const Accessors& accessors, const std::string& fileName,
                                  const RequireMemory& requireMemory, const Progress& progress, LeftOut& leftOut);

}  // namespace cullscope::gltf
