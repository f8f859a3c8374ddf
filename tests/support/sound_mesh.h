#pragma once

#include <cmath>

#include "core/mesh/load.h"

namespace cullscope::test {

/// Whether a mesh keeps its promises to what is built from it: indices name vertices, positions are finite, normals have unit
/// length.
[[nodiscard]] inline bool isSound(const TriangleMesh& mesh) {
    if (mesh.triangleCount() == 0 || mesh.normals().size() != mesh.vertexCount()) return false;
    for (const uint32_t index : mesh.indices())
        if (index >= mesh.vertexCount()) return false;
    for (size_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        const double length = glm::length(Vec3(mesh.normals()[vertex]));
        if (!std::isfinite(glm::dot(mesh.position(vertex), Vec3(1.0))) || std::abs(length - 1.0) > 1e-3) return false;
    }
    return std::isfinite(mesh.localSphere().radius) && mesh.topology().boundaryEdges < 3 * mesh.triangleCount() + 1;
}

/// The same of all objects of a file, which have names, and the sums of its report.
[[nodiscard]] inline bool isSound(const LoadedFile& file) {
    size_t triangles = 0;
    for (const LoadedObject& object : file.objects) {
        if (object.name.empty() || !isSound(*object.mesh)) return false;
        triangles += object.mesh->triangleCount();
    }
    return triangles > 0 && triangles == file.report.trianglesMade && file.sha256.size() == 64;
}

}  // namespace cullscope::test
