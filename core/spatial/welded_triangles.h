#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The triangles of a scene in world coordinates, joined where their corners are the same for OpenGL: with the same float
/// coordinates, relative to the same origin and placed by the same matrix. Between triangles that share an edge so, no pixel
/// shows what lies behind them. Of several triangles with the same corners there is one, and of one without an area none.
class WeldedTriangles {
public:
    static constexpr uint32_t kNone = 0xFFFFFFFF;
    struct Triangle {
        std::array<uint32_t, 3> vertices{};  ///< counter-clockwise from where it shows its front
        std::array<uint32_t, 3> edges{};     ///< from vertex i to vertex (i + 1) % 3
        uint32_t instance = 0;
    };

    /// O(triangles · log triangles), about 150 bytes for each. Throws Error(Interrupted) soon after a stop is requested.
    explicit WeldedTriangles(const Scene& scene, const Progress& progress = {});

    [[nodiscard]] std::span<const Triangle> triangles() const { return m_triangles; }
    [[nodiscard]] const Vec3& vertex(uint32_t number) const { return m_vertices[number]; }
    [[nodiscard]] std::array<Vec3, 3> corners(const Triangle& triangle) const {
        return {m_vertices[triangle.vertices[0]], m_vertices[triangle.vertices[1]], m_vertices[triangle.vertices[2]]};
    }
    [[nodiscard]] size_t edgeCount() const { return m_edges.size(); }
    [[nodiscard]] const std::array<uint32_t, 2>& edge(uint32_t number) const { return m_edges[number]; }
    /// The triangles at an edge.
    [[nodiscard]] std::span<const uint32_t> at(uint32_t edge) const {
        return std::span(m_atEdges).subspan(m_firstAt[edge], m_firstAt[edge + 1] - m_firstAt[edge]);
    }
    /// The number here of a triangle of the scene; kNone: it has no area.
    [[nodiscard]] uint32_t numberOf(uint64_t sceneTriangle) const { return m_numbers[sceneTriangle]; }

private:
    void addVertices(const Scene& scene, const Progress& progress, std::vector<uint32_t>& vertexOf);
    void addTriangles(const Scene& scene, const Progress& progress, const std::vector<uint32_t>& vertexOf);
    void addEdges(const Progress& progress);

    std::vector<Vec3> m_vertices;
    std::vector<Triangle> m_triangles;
    std::vector<std::array<uint32_t, 2>> m_edges;
    std::vector<uint32_t> m_firstAt;  ///< by edge, and the end
    std::vector<uint32_t> m_atEdges;
    std::vector<uint32_t> m_numbers;  ///< by triangle of the scene
};

}  // namespace cullscope
