#include "core/spatial/part_boxes.h"

#include <algorithm>
#include <numeric>

namespace cullscope {
namespace {

/// The triangles of a mesh in the order of its parts.
struct MeshParts {
    std::vector<uint32_t> triangles;
    std::vector<size_t> ends;  ///< by part
};

/// Thrice the centre of a triangle.
Vec3f centreOf(const TriangleMesh& mesh, uint32_t triangle) {
    const uint32_t* corners = &mesh.indices()[3 * size_t(triangle)];
    return mesh.positions()[corners[0]] + mesh.positions()[corners[1]] + mesh.positions()[corners[2]];
}

void halve(const TriangleMesh& mesh, MeshParts& parts, size_t first, size_t end, size_t most) {
    const size_t count = end - first;
    if (most == 1 || count < 2 * PartBoxes::kLeastTriangles) return parts.ends.push_back(end);
    const auto begin = parts.triangles.begin();
    Box3 centres;
    for (size_t i = first; i < end; ++i) centres.add(Vec3(centreOf(mesh, parts.triangles[i])));
    const Vec3 size = centres.max - centres.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const size_t middle = first + count / 2;
    std::nth_element(begin + std::ptrdiff_t(first), begin + std::ptrdiff_t(middle), begin + std::ptrdiff_t(end),
                     [&](uint32_t a, uint32_t b) {
                         const float ofA = centreOf(mesh, a)[axis], ofB = centreOf(mesh, b)[axis];
                         return ofA != ofB ? ofA < ofB : a < b;
                     });
    halve(mesh, parts, first, middle, most / 2);
    halve(mesh, parts, middle, end, most / 2);
}

MeshParts partsOf(const TriangleMesh& mesh) {
    MeshParts parts;
    if (mesh.triangleCount() < 2 * PartBoxes::kLeastTriangles) return parts;
    parts.triangles.resize(mesh.triangleCount());
    std::iota(parts.triangles.begin(), parts.triangles.end(), 0u);
    halve(mesh, parts, 0, mesh.triangleCount(), PartBoxes::kMost);
    return parts;
}

}  // namespace

PartBoxes::PartBoxes(const Scene& scene, const Progress& progress) {
    const std::vector<bool> shown = scene.shownMeshes();
    std::vector<MeshParts> ofMeshes(scene.meshes().size());
    for (size_t mesh = 0; mesh < ofMeshes.size(); ++mesh) {
        progress.check();
        if (shown[mesh]) ofMeshes[mesh] = partsOf(*scene.meshes()[mesh]);
    }
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        progress.check();
        m_first.push_back(uint32_t(m_boxes.size()));
        const Instance& instance = scene.instances()[i];
        const TriangleMesh& mesh = scene.meshOf(i);
        const MeshParts& parts = ofMeshes[instance.mesh];
        const double displaced = scene.pictureRounding(instance);
        size_t next = 0;
        for (const size_t end : parts.ends) {
            Box3 box;
            for (; next < end; ++next)
                for (size_t corner = 0; corner < 3; ++corner)
                    box.add(Vec3(instance.worldFromMesh *
                                 Vec4(mesh.position(mesh.indices()[3 * size_t(parts.triangles[next]) + corner]), 1.0)));
            m_boxes.push_back({box.min - Vec3(displaced), box.max + Vec3(displaced)});
        }
    }
    m_first.push_back(uint32_t(m_boxes.size()));
}

}  // namespace cullscope
