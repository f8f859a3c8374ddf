#include "core/mesh/coarse_mesh.h"

#include <meshoptimizer.h>

#include <limits>

namespace cullscope {

MeshPointer coarseMesh(const MeshPointer& mesh, size_t triangles) {
    if (mesh->triangleCount() <= triangles) return mesh;
    std::vector<uint32_t> indices(mesh->indices().size());
    indices.resize(meshopt_simplifySloppy(indices.data(), mesh->indices().data(), mesh->indices().size(),
                                          &mesh->positions().front().x, mesh->vertexCount(), sizeof(Vec3f), 3 * triangles,
                                          std::numeric_limits<float>::max(), nullptr));
    if (indices.empty()) return mesh;
    TriangleMesh::Data data;
    data.name = mesh->name();
    data.origin = mesh->origin();
    constexpr uint32_t kUnused = UINT32_MAX;
    std::vector<uint32_t> place(mesh->vertexCount(), kUnused);
    for (uint32_t& index : indices) {
        if (place[index] == kUnused) {
            place[index] = uint32_t(data.positions.size());
            data.positions.push_back(mesh->positions()[index]);
            data.normals.push_back(mesh->normals()[index]);
        }
        index = place[index];
    }
    data.indices = std::move(indices);
    return std::make_shared<const TriangleMesh>(std::move(data));
}

}  // namespace cullscope
