#include "core/mesh/half_edge_mesh.h"

#include <OpenMesh/Core/System/omstream.hh>

#include "core/mesh/steps.h"
#include "core/mesh/weld.h"

namespace cullscope {
namespace {

using VertexHandle = HalfEdgeMesh::VertexHandle;

/// Rounds in which surplus triangles may share copies of vertices; afterwards each triangle gets its own copies.
constexpr int kSharingRounds = 8;

/// Silences OpenMesh's report on standard error of every face that it refuses: refusals are expected here.
class QuietOpenMesh {
public:
    QuietOpenMesh() : m_wasEnabled(::omerr().is_enabled()) { ::omerr().disable(); }
    ~QuietOpenMesh() {
        if (m_wasEnabled) ::omerr().enable();
    }
    QuietOpenMesh(const QuietOpenMesh&) = delete;
    QuietOpenMesh& operator=(const QuietOpenMesh&) = delete;

private:
    bool m_wasEnabled;
};

bool fits(const HalfEdgeMesh& mesh, const std::array<VertexHandle, 3>& corners) {
    for (size_t i = 0; i < 3; ++i) {
        if (!mesh.is_boundary(corners[i])) return false;
        const auto edge = mesh.find_halfedge(corners[i], corners[(i + 1) % 3]);
        if (edge.is_valid() && !mesh.is_boundary(edge)) return false;
    }
    return true;
}

}  // namespace

HalfEdgeConversion::HalfEdgeConversion(const TriangleMesh& mesh, const Progress& progress)
    : m_source(mesh),
      m_halfEdges(progress),
      m_centre(mesh.localBounds().centre()),
      m_scale(mesh.localBounds().diagonal() > 0.0 ? mesh.localBounds().diagonal() : 1.0) {
    m_halfEdges.add_property(m_sources);
    addFaces(progress);
}

void HalfEdgeConversion::addFaces(const Progress& progress) {
    const QuietOpenMesh quiet;
    const std::vector<uint32_t> welded = firstOfEqualPositions(m_source.positions(), progress);
    std::vector<uint32_t> pending;  // triangles
    for (uint32_t triangle = 0; triangle < m_source.triangleCount(); ++triangle) pending.push_back(triangle);
    for (int round = 0; !pending.empty(); ++round) {
        std::vector<VertexHandle> handles(m_source.vertexCount());
        std::vector<uint32_t> surplus;
        const auto handle = [&](uint32_t vertex) {
            VertexHandle& known = handles[welded[vertex]];
            if (!known.is_valid() || round >= kSharingRounds) {
                const Vec3 position = (Vec3(m_source.positions()[vertex]) - m_centre) / m_scale;
                known = m_halfEdges.new_vertex({position.x, position.y, position.z});
                m_halfEdges.property(m_sources, known) = vertex;
            }
            return known;
        };
        const auto add = [&](uint32_t triangle) {
            const std::span<const uint32_t> corner = m_source.indices().subspan(3 * size_t{triangle}, 3);
            // OpenMesh accepts no triangles without area.
            if (welded[corner[0]] == welded[corner[1]] || welded[corner[1]] == welded[corner[2]] ||
                welded[corner[2]] == welded[corner[0]])
                return;
            const std::array<VertexHandle, 3> corners{handle(corner[0]), handle(corner[1]), handle(corner[2])};
            if (!fits(m_halfEdges, corners) || !m_halfEdges.add_face(corners[0], corners[1], corners[2]).is_valid())
                surplus.push_back(triangle);
        };
        inSteps(
            pending.size(), progress,
            [&](size_t begin, size_t end) {
                for (size_t i = begin; i < end; ++i) add(pending[i]);
            },
            size_t{1} << 13);
        pending = std::move(surplus);
    }
}

MeshPointer HalfEdgeConversion::flattened(const Progress& progress) {
    TriangleMesh::Data data;
    data.name = m_source.name();
    data.origin = m_source.origin();
    std::vector<uint32_t> number(m_halfEdges.n_vertices(), 0xffffffffU);
    const auto numbered = [&](VertexHandle vertex) {
        uint32_t& known = number[static_cast<size_t>(vertex.idx())];
        if (known == 0xffffffffU) {
            known = static_cast<uint32_t>(data.positions.size());
            const auto& point = m_halfEdges.point(vertex);
            data.positions.push_back(Vec3f(m_centre + m_scale * Vec3(point[0], point[1], point[2])));
        }
        return known;
    };
    for (const auto face : m_halfEdges.faces()) {  // skips deleted faces
        if (data.indices.size() % 65536 == 0) progress.check();
        for (const auto vertex : m_halfEdges.fv_range(face)) data.indices.push_back(numbered(vertex));
    }
    return std::make_shared<const TriangleMesh>(std::move(data));
}

}  // namespace cullscope
