#include "core/spatial/welded_triangles.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>

#include "core/geometry/predicates.h"

namespace cullscope {
namespace {

/// What OpenGL's matrix of an instance is made of.
struct Placing {
    Mat4 worldFromMesh{1.0};
    Vec3 origin{0.0};

    bool operator<(const Placing& other) const { return std::memcmp(this, &other, sizeof(Placing)) < 0; }
};

/// A corner that is to be joined: where it is for OpenGL, and which one it is.
struct Corner {
    uint32_t placing = 0;
    std::array<uint32_t, 3> bits{};
    uint32_t number = 0;

    [[nodiscard]] auto key() const { return std::tie(placing, bits); }
};

constexpr size_t kStep = 1 << 16;  // between looks for a stop request

}  // namespace

WeldedTriangles::WeldedTriangles(const Scene& scene, const Progress& progress) {
    std::vector<uint32_t> vertexOf;
    addVertices(scene, progress, vertexOf);
    addTriangles(scene, progress, vertexOf);
    addEdges(progress);
}

void WeldedTriangles::addVertices(const Scene& scene, const Progress& progress, std::vector<uint32_t>& vertexOf) {
    std::map<Placing, uint32_t> placings;
    std::vector<Corner> corners;
    std::vector<Vec3> places;
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        progress.check();
        const TriangleMesh& mesh = scene.meshOf(i);
        const Mat4& placed = scene.instances()[i].worldFromMesh;
        const auto placing = placings.try_emplace({placed, mesh.origin()}, uint32_t(placings.size())).first->second;
        for (size_t vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
            // 0 and −0 are one place.
            const Vec3f position = mesh.positions()[vertex] + Vec3f(0.0f);
            corners.push_back(
                {placing,
                 {std::bit_cast<uint32_t>(position.x), std::bit_cast<uint32_t>(position.y), std::bit_cast<uint32_t>(position.z)},
                 uint32_t(corners.size())});
            places.push_back(Vec3(placed * Vec4(mesh.position(vertex), 1.0)));
        }
    }
    std::ranges::sort(corners, [](const Corner& a, const Corner& b) { return a.key() < b.key(); });
    progress.check();
    vertexOf.resize(corners.size());
    for (size_t i = 0; i < corners.size(); ++i) {
        if (i == 0 || corners[i].key() != corners[i - 1].key()) m_vertices.push_back(places[corners[i].number]);
        vertexOf[corners[i].number] = uint32_t(m_vertices.size() - 1);
    }
}

void WeldedTriangles::addTriangles(const Scene& scene, const Progress& progress, const std::vector<uint32_t>& vertexOf) {
    m_numbers.assign(scene.triangleCount(), kNone);
    std::map<std::array<uint32_t, 3>, uint32_t> known;  // by sorted vertices
    size_t firstVertex = 0;
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        const TriangleMesh& mesh = scene.meshOf(i);
        const bool mirrored = glm::determinant(Mat3(scene.instances()[i].worldFromMesh)) < 0.0;
        for (size_t t = 0; t < mesh.triangleCount(); ++t) {
            if (t % kStep == 0) progress.check();
            Triangle triangle;
            triangle.instance = i;
            for (size_t c = 0; c < 3; ++c) triangle.vertices[c] = vertexOf[firstVertex + mesh.indices()[3 * t + c]];
            if (mirrored) std::swap(triangle.vertices[1], triangle.vertices[2]);
            const std::array<Vec3, 3> at = corners(triangle);
            if (onOneLine(at[0], at[1], at[2])) continue;
            std::array<uint32_t, 3> sorted = triangle.vertices;
            std::ranges::sort(sorted);
            const auto [place, added] = known.try_emplace(sorted, uint32_t(m_triangles.size()));
            if (added) m_triangles.push_back(triangle);
            m_numbers[scene.firstTriangle(i) + t] = place->second;
        }
        firstVertex += mesh.vertexCount();
    }
}

void WeldedTriangles::addEdges(const Progress& progress) {
    struct Side {
        std::array<uint32_t, 2> ends;
        uint32_t triangle, side;
    };
    std::vector<Side> sides;
    sides.reserve(3 * m_triangles.size());
    for (uint32_t t = 0; t < m_triangles.size(); ++t)
        for (uint32_t s = 0; s < 3; ++s) {
            const uint32_t a = m_triangles[t].vertices[s], b = m_triangles[t].vertices[(s + 1) % 3];
            sides.push_back({{std::min(a, b), std::max(a, b)}, t, s});
        }
    progress.check();
    std::ranges::stable_sort(sides, {}, &Side::ends);
    progress.check();
    for (size_t i = 0; i < sides.size(); ++i) {
        if (i == 0 || sides[i].ends != sides[i - 1].ends) {
            m_edges.push_back(sides[i].ends);
            m_firstAt.push_back(uint32_t(i));
        }
        m_triangles[sides[i].triangle].edges[sides[i].side] = uint32_t(m_edges.size() - 1);
        m_atEdges.push_back(sides[i].triangle);
    }
    m_firstAt.push_back(uint32_t(sides.size()));
}

}  // namespace cullscope
