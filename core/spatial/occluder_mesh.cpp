#include "core/spatial/occluder_mesh.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace cullscope {
namespace {

struct Sized {
    float area = 0.0f;
    uint32_t triangle = 0;

    // The largest first; of equal ones the mesh's first.
    bool operator<(const Sized& other) const { return area != other.area ? area > other.area : triangle < other.triangle; }
};

float areaOf(const TriangleMesh& mesh, uint32_t triangle) {
    const uint32_t* corners = &mesh.indices()[3 * size_t(triangle)];
    const Vec3 a(mesh.positions()[corners[0]]), b(mesh.positions()[corners[1]]), c(mesh.positions()[corners[2]]);
    return float(0.5 * glm::length(glm::cross(b - a, c - a)));
}

}  // namespace

size_t OccluderMesh::countFrom(double area) const {
    return size_t(std::ranges::partition_point(means, [area](float mean) { return double(mean) >= area; }) - means.begin());
}

uint64_t OccluderMesh::bytes() const {
    return positions.size() * sizeof(Vec3f) + means.size() * sizeof(float) +
           (indices.size() + triangles.size() + vertices.size()) * sizeof(uint32_t);
}

OccluderMesh occluderMesh(const TriangleMesh& mesh, size_t most) {
    std::vector<uint32_t> all(mesh.triangleCount());
    std::iota(all.begin(), all.end(), 0u);
    return occluderMesh(mesh, all, most);
}

OccluderMesh occluderMesh(const TriangleMesh& mesh, std::span<const uint32_t> triangles, size_t most) {
    std::vector<Sized> sized;
    sized.reserve(triangles.size());
    for (const uint32_t triangle : triangles)
        if (const float area = areaOf(mesh, triangle); area > 0.0f) sized.push_back({area, triangle});
    if (sized.size() > most) {
        std::ranges::nth_element(sized, sized.begin() + std::ptrdiff_t(most), std::less<>());
        sized.resize(most);
    }
    std::sort(sized.begin(), sized.end());
    OccluderMesh result;
    std::unordered_map<uint32_t, uint32_t> places;
    double sum = 0.0;
    for (const Sized& one : sized) {
        for (size_t corner = 0; corner < 3; ++corner) {
            const uint32_t vertex = mesh.indices()[3 * size_t(one.triangle) + corner];
            const auto [place, isNew] = places.try_emplace(vertex, uint32_t(result.positions.size()));
            if (isNew) result.positions.push_back(mesh.positions()[vertex]);
            result.indices.push_back(place->second);
        }
        result.triangles.push_back(one.triangle);
        sum += one.area;
        result.means.push_back(float(sum / double(result.triangles.size())));
        result.vertices.push_back(uint32_t(result.positions.size()));
    }
    return result;
}

std::vector<OccluderMesh> occluderMeshes(const Scene& scene, const Progress& progress) {
    const std::vector<bool> shown = scene.shownMeshes();
    std::vector<OccluderMesh> result(scene.meshes().size());
    for (size_t mesh = 0; mesh < result.size(); ++mesh) {
        progress.check();
        if (shown[mesh]) result[mesh] = occluderMesh(*scene.meshes()[mesh]);
    }
    return result;
}

}  // namespace cullscope
