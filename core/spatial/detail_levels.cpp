#include "core/spatial/detail_levels.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "core/base/message.h"
#include "core/mesh/primitive/tessellate.h"
#include "core/mesh/surface_distance.h"
#include "core/mesh/vertex_cache.h"

namespace cullscope {
namespace {

/// Segments of a full circle, level by level.
constexpr std::array<uint32_t, 8> kSegments{32, 24, 16, 12, 8, 6, 4, 3};
/// A primitive with more vertices is simplified by quadrics.
constexpr size_t kMostVerticesOfAPart = 4096;

/// The vertices of a part of a mesh, each once.
std::vector<uint32_t> verticesOf(const TriangleMesh& mesh, const MeshPart& part) {
    const std::span<const uint32_t> indices =
        mesh.indices().subspan(3 * size_t(part.firstTriangle), 3 * size_t(part.triangleCount));
    std::vector<uint32_t> vertices(indices.begin(), indices.end());
    std::ranges::sort(vertices);
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
}

/// A part with its circles of so many segments, between the mesh's vertices. The part itself where that has no fewer triangles.
class PartLevels {
public:
    PartLevels(const TriangleMesh& mesh, const MeshPart& part) : m_mesh(mesh), m_part(part), m_vertices(verticesOf(mesh, part)) {}

    void append(uint32_t segments, std::vector<uint32_t>& indices) const {
        primitive::Surface surface;
        if (m_part.kind == MeshPart::Kind::Solid)
            primitive::appendSurface(surface, m_part.solid, {.segments = segments}, m_part.meshFromSolid);
        const std::span<const uint32_t> own =
            m_mesh.indices().subspan(3 * size_t(m_part.firstTriangle), 3 * size_t(m_part.triangleCount));
        if (surface.triangles.empty() || surface.triangles.size() >= own.size()) {
            indices.insert(indices.end(), own.begin(), own.end());
            return;
        }
        std::vector<uint32_t> vertex(surface.positions.size());
        for (size_t i = 0; i < vertex.size(); ++i)
            vertex[i] = nearest(surface.positions[i] - m_mesh.origin(), surface.normals[i]);
        for (size_t i = 0; i < surface.triangles.size(); i += 3) {
            const std::array<uint32_t, 3> corners{vertex[surface.triangles[i]], vertex[surface.triangles[i + 1]],
                                                  vertex[surface.triangles[i + 2]]};
            const std::span<const Vec3f> at = m_mesh.positions();
            if (at[corners[0]] != at[corners[1]] && at[corners[1]] != at[corners[2]] && at[corners[2]] != at[corners[0]])
                indices.insert(indices.end(), corners.begin(), corners.end());
        }
    }

private:
    /// The part's vertex nearest to a place, the first of several; of those at one place the one with the nearest normal. So
    /// equal places become equal ones, and a closed surface stays closed.
    [[nodiscard]] uint32_t nearest(const Vec3& place, const Vec3& normal) const {
        uint32_t best = m_vertices.front();
        double away = std::numeric_limits<double>::infinity();
        for (const uint32_t vertex : m_vertices) {
            const Vec3 way = Vec3(m_mesh.positions()[vertex]) - place;
            if (const double squared = glm::dot(way, way); squared < away) {
                away = squared;
                best = vertex;
            }
        }
        const Vec3f position = m_mesh.positions()[best];
        const auto turned = [&](uint32_t vertex) { return glm::dot(Vec3(m_mesh.normals()[vertex]), normal); };
        for (const uint32_t vertex : m_vertices)
            if (m_mesh.positions()[vertex] == position && turned(vertex) > turned(best)) best = vertex;
        return best;
    }

    const TriangleMesh& m_mesh;
    const MeshPart& m_part;
    std::vector<uint32_t> m_vertices;
};

/// Computes the errors, and leaves out levels that have no smaller error than a coarser one.
std::vector<MeshLevel> judged(const TriangleMesh& mesh, std::vector<MeshLevel> levels, const Progress& progress) {
    const SurfaceDistance distance(mesh.positions(), mesh.indices());
    std::vector<MeshLevel> kept;
    for (MeshLevel& level : levels) {
        level.error = distance.to(level.indices, progress);
        while (!kept.empty() && kept.back().error >= level.error) kept.pop_back();
        kept.push_back(std::move(level));
    }
    return kept;
}

bool bySegments(const TriangleMesh& mesh, std::span<const MeshPart> parts) {
    uint64_t triangles = 0;
    for (const MeshPart& part : parts) {
        if (part.triangleCount == 0) continue;
        if (part.kind != MeshPart::Kind::Solid || verticesOf(mesh, part).size() > kMostVerticesOfAPart) return false;
        triangles += part.triangleCount;
    }
    return triangles > 0 && triangles == mesh.triangleCount();
}

std::span<const MeshPart> partsOfMesh(const Scene& scene, size_t mesh) {
    if (!scene.remarks().components) return {};
    const Components& components = *scene.remarks().components;
    const size_t first = components.firstPart[mesh];
    return std::span(components.parts).subspan(first, components.firstPart[mesh + 1] - first);
}

/// The indices of an order, which its spans view.
struct LevelIndices {
    struct OfMesh {
        std::vector<uint32_t> indices, triangles;
    };
    std::vector<OfMesh> meshes;
};

/// A mesh's own triangles in the order that is fastest to draw, with their numbers.
LevelIndices::OfMesh ownTrianglesOf(const TriangleMesh& mesh) {
    using Corners = std::array<uint32_t, 3>;
    const auto cornersAt = [](std::span<const uint32_t> indices, size_t triangle) {
        return Corners{indices[3 * triangle], indices[3 * triangle + 1], indices[3 * triangle + 2]};
    };
    std::vector<std::pair<Corners, uint32_t>> numbers;
    for (uint32_t i = 0; i < mesh.triangleCount(); ++i) numbers.emplace_back(cornersAt(mesh.indices(), i), i);
    std::ranges::sort(numbers);
    std::vector<bool> used(numbers.size(), false);  // a triangle may be there twice
    LevelIndices::OfMesh own{inVertexCacheOrder(mesh.indices(), mesh.vertexCount()), {}};
    for (size_t i = 0; i < numbers.size(); ++i) {
        auto found = std::ranges::lower_bound(numbers, cornersAt(own.indices, i), {}, &std::pair<Corners, uint32_t>::first);
        while (used[size_t(found - numbers.begin())]) ++found;
        used[size_t(found - numbers.begin())] = true;
        own.triangles.push_back(found->second);
    }
    return own;
}

void append(LevelIndices::OfMesh& mesh, std::span<const uint32_t> indices) {
    mesh.indices.insert(mesh.indices.end(), indices.begin(), indices.end());
    for (uint32_t triangle = 0; triangle < indices.size() / 3; ++triangle) mesh.triangles.push_back(triangle);
}

}  // namespace

std::vector<MeshLevel> segmentLevels(const TriangleMesh& mesh, std::span<const MeshPart> parts, const Progress& progress) {
    if (!bySegments(mesh, parts)) return {};
    std::vector<PartLevels> makers;
    for (const MeshPart& part : parts)
        if (part.triangleCount > 0) makers.emplace_back(mesh, part);
    std::vector<MeshLevel> levels;
    size_t before = mesh.indices().size();
    for (const uint32_t segments : kSegments) {
        progress.check();
        MeshLevel level;
        for (const PartLevels& maker : makers) maker.append(segments, level.indices);
        if (level.indices.empty() || 3 * level.indices.size() > 2 * before) continue;
        before = level.indices.size();
        levels.push_back(std::move(level));
    }
    return judged(mesh, std::move(levels), progress);
}

std::vector<MeshLevel> decimatedLevels(const TriangleMesh& mesh, const Progress& progress) {
    return judged(mesh, quadricLevels(mesh, DetailLevels::kFewest / 2, progress), progress);
}

DetailLevels::DetailLevels(const Scene& scene, const Progress& progress) {
    const std::vector<bool> shown = scene.shownMeshes();
    auto made = std::make_shared<LevelIndices>();
    made->meshes.resize(scene.meshes().size());
    auto order = std::make_shared<TriangleOrder>();
    order->meshes.resize(scene.meshes().size());
    for (uint32_t number = 0; number < scene.meshes().size(); ++number) {
        if (number % 64 == 0)
            progress.tell(double(number) / double(scene.meshes().size()), CULLSCOPE_TR("Making levels of detail"));
        progress.check();
        const TriangleMesh& mesh = *scene.meshes()[number];
        m_levels.push_back({0, uint32_t(mesh.indices().size()), 0.0});
        if (shown[number] && mesh.triangleCount() >= kFewest) {
            const std::span<const MeshPart> parts = partsOfMesh(scene, number);
            const bool segments = bySegments(mesh, parts);
            const std::vector<MeshLevel> levels =
                segments ? segmentLevels(mesh, parts, progress) : decimatedLevels(mesh, progress);
            if (!levels.empty()) {
                ++(segments ? m_bySegments : m_byQuadrics);
                LevelIndices::OfMesh& own = made->meshes[number];
                own = ownTrianglesOf(mesh);
                for (const MeshLevel& level : levels) {
                    m_levels.push_back({uint32_t(own.indices.size()), uint32_t(level.indices.size()), level.error});
                    append(own, inVertexCacheOrder(level.indices, mesh.vertexCount()));
                }
                own.indices.shrink_to_fit();
                own.triangles.shrink_to_fit();
                order->meshes[number] = {own.indices, own.triangles, mesh.triangleCount()};
                m_bytes += (own.indices.size() + own.triangles.size()) * sizeof(uint32_t);
            }
        }
        m_firstLevel.push_back(m_levels.size());
    }
    m_bytes += m_levels.size() * sizeof(Level) + m_firstLevel.size() * sizeof(size_t);
    order->owner = std::move(made);
    m_order = std::move(order);
}

}  // namespace cullscope
