#include "core/mesh/meshlets.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "core/mesh/vertex_cache.h"

namespace cullscope {
namespace {

constexpr size_t kMostVertices = 255;  // of one meshlet, by the library
constexpr uint32_t kMultiple = 4;      // by the library, of the most triangles
// How much groups that face alike are preferred to round ones: of the library's examples.
constexpr float kConeWeight = 0.25f;

using Triple = std::array<uint32_t, 3>;

Triple tripleAt(std::span<const uint32_t> indices, size_t triangle) {
    return {indices[3 * triangle], indices[3 * triangle + 1], indices[3 * triangle + 2]};
}

/// Of the three orders in which a triangle's corners can be named the smallest one: whichever one the library gives back.
Triple named(const Triple& t) { return std::min({t, Triple{t[1], t[2], t[0]}, Triple{t[2], t[0], t[1]}}); }

/// The positions moved and scaled into a unit cube: the library squares distances, which float does not hold for every size.
std::vector<Vec3f> unitPositions(const TriangleMesh& mesh) {
    const Box3& box = mesh.localBounds();
    const Vec3 size = box.max - box.min;
    const double longest = std::max({size.x, size.y, size.z});
    const double scale = longest > 0.0 ? 1.0 / longest : 1.0;
    std::vector<Vec3f> result;
    result.reserve(mesh.vertexCount());
    for (const Vec3f& position : mesh.positions()) result.emplace_back((Vec3(position) - box.min) * scale);
    return result;
}

/// The indices with the first of all vertices at the same position in place of each.
std::vector<uint32_t> weldedIndices(const TriangleMesh& mesh) {
    std::vector<uint32_t> welded(mesh.indices().size());
    meshopt_generateShadowIndexBuffer(welded.data(), mesh.indices().data(), mesh.indices().size(), mesh.positions().data(),
                                      mesh.vertexCount(), sizeof(Vec3f), sizeof(Vec3f));
    return welded;
}

/// Triangles by their corners: finds each of them once.
class ByCorners {
public:
    explicit ByCorners(std::span<const uint32_t> indices) : m_order(indices.size() / 3) {
        for (size_t triangle = 0; triangle < m_order.size(); ++triangle) m_names.push_back(named(tripleAt(indices, triangle)));
        std::iota(m_order.begin(), m_order.end(), 0U);
        std::ranges::sort(m_order, [&](uint32_t a, uint32_t b) {
            const Triple &first = m_names[a], &second = m_names[b];
            return first != second ? first < second : a < b;
        });
        m_taken.resize(m_order.size(), 0);
    }

    /// The next triangle with these corners that was not taken yet; the number of all where there is none.
    [[nodiscard]] uint32_t take(const Triple& triple) {
        const Triple corners = named(triple);
        const auto found = std::ranges::lower_bound(m_order, corners, {}, [&](uint32_t triangle) { return m_names[triangle]; });
        // The first of several equal ones counts how many of them were taken.
        if (found == m_order.end() || m_names[*found] != corners) return uint32_t(m_order.size());
        uint32_t& taken = m_taken[size_t(found - m_order.begin())];
        const size_t place = size_t(found - m_order.begin()) + taken;
        if (place >= m_order.size() || m_names[m_order[place]] != corners) return uint32_t(m_order.size());
        ++taken;
        return m_order[place];
    }

private:
    std::vector<Triple> m_names;  ///< by triangle
    std::vector<uint32_t> m_order, m_taken;
};

/// A group's triangles in vertex-cache order.
void sortForVertexCache(std::span<uint32_t> triangles, const TriangleMesh& mesh) {
    std::vector<uint32_t> vertices, local;
    for (const uint32_t triangle : triangles)
        for (const uint32_t vertex : tripleAt(mesh.indices(), triangle)) vertices.push_back(vertex);
    local = vertices;
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    for (uint32_t& vertex : local) vertex = uint32_t(std::ranges::lower_bound(vertices, vertex) - vertices.begin());
    const std::vector<uint32_t> ordered = inVertexCacheOrder(local, vertices.size());
    ByCorners found(local);
    std::vector<uint32_t> result;
    for (size_t i = 0; i < triangles.size(); ++i) result.push_back(triangles[found.take(tripleAt(ordered, i))]);
    std::ranges::copy(result, triangles.begin());
}

}  // namespace

Meshlets cutIntoMeshlets(const TriangleMesh& mesh, uint32_t most, const Progress& progress) {
    assert(most >= kMultiple && most <= kMostInMeshlet);
    const size_t triangles = mesh.triangleCount(), mostByFour = most / kMultiple * kMultiple;
    const std::vector<uint32_t> welded = weldedIndices(mesh);
    const std::vector<Vec3f> positions = unitPositions(mesh);
    progress.check();
    std::vector<meshopt_Meshlet> found(meshopt_buildMeshletsBound(welded.size(), kMostVertices, mostByFour));
    std::vector<unsigned> vertices(found.size() * kMostVertices);
    std::vector<unsigned char> corners(found.size() * mostByFour * 3);
    found.resize(meshopt_buildMeshlets(found.data(), vertices.data(), corners.data(), welded.data(), welded.size(),
                                       &positions.data()->x, positions.size(), sizeof(Vec3f), kMostVertices, mostByFour,
                                       kConeWeight));
    progress.check();
    Meshlets result;
    result.triangles.reserve(triangles);
    ByCorners byCorners(welded);
    std::vector<bool> placed(triangles, false);
    const auto endGroup = [&](size_t start) {
        if (result.triangles.size() == start) return;
        result.starts.push_back(uint32_t(start));
        sortForVertexCache(std::span(result.triangles).subspan(start), mesh);
    };
    for (const meshopt_Meshlet& meshlet : found) {
        const size_t start = result.triangles.size();
        for (size_t i = 0; i < meshlet.triangle_count; ++i) {
            Triple triple;
            for (size_t c = 0; c < 3; ++c)
                triple[c] = vertices[meshlet.vertex_offset + corners[meshlet.triangle_offset + 3 * i + c]];
            const uint32_t triangle = byCorners.take(triple);
            if (triangle == triangles) continue;
            placed[triangle] = true;
            result.triangles.push_back(triangle);
        }
        endGroup(start);
    }
    for (uint32_t triangle = 0; triangle < triangles;) {
        const size_t start = result.triangles.size();
        for (; triangle < triangles && result.triangles.size() < start + most; ++triangle)
            if (!placed[triangle]) result.triangles.push_back(triangle);
        endGroup(start);
    }
    result.starts.push_back(uint32_t(triangles));
    progress.check();
    return result;
}

}  // namespace cullscope
