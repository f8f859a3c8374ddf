#include "core/mesh/triangle_mesh.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cassert>

#include "core/mesh/edges.h"
#include "core/mesh/inside_out.h"
#include "core/mesh/normals.h"

namespace cullscope {
namespace {

Box3 boundsOfUsed(std::span<const Vec3f> positions, std::span<const uint32_t> indices) {
    using Range = tbb::blocked_range<size_t>;
    struct Corners {
        Vec3f min{std::numeric_limits<float>::infinity()};
        Vec3f max{-std::numeric_limits<float>::infinity()};
    };
    const auto grow = [&](const Range& range, Corners corners) {
        for (size_t i = range.begin(); i < range.end(); ++i) {
            corners.min = glm::min(corners.min, positions[indices[i]]);
            corners.max = glm::max(corners.max, positions[indices[i]]);
        }
        return corners;
    };
    const auto join = [](const Corners& a, const Corners& b) { return Corners{glm::min(a.min, b.min), glm::max(a.max, b.max)}; };
    const Corners corners = tbb::parallel_reduce(Range(0, indices.size(), 1 << 16), Corners{}, grow, join);
    return {Vec3(corners.min), Vec3(corners.max)};
}

/// Six times the volume enclosed by closed triangles, positive when they face outward. Coordinates are scaled to about 1 first,
/// so that their third powers stay within the range of double.
double signedVolume(std::span<const Vec3f> positions, std::span<const uint32_t> indices, const Box3& bounds) {
    const double scale = bounds.diagonal() > 0.0 ? 1.0 / bounds.diagonal() : 1.0;
    const Vec3 centre = bounds.centre();
    const auto corner = [&](size_t i) { return (Vec3(positions[indices[i]]) - centre) * scale; };
    double volume = 0.0;
    for (size_t i = 0; i + 2 < indices.size(); i += 3) volume += glm::dot(corner(i), glm::cross(corner(i + 1), corner(i + 2)));
    return volume;
}

}  // namespace

TriangleMesh::TriangleMesh(Data data) : m_data(std::move(data)) {
    assert(m_data.indices.size() % 3 == 0);
    assert(m_data.normals.empty() || m_data.normals.size() == m_data.positions.size());
    assert(std::ranges::all_of(m_data.indices, [&](uint32_t index) { return index < m_data.positions.size(); }));
    assert(std::ranges::all_of(m_data.positions,
                               [](const Vec3f& p) { return !glm::any(glm::isnan(p)) && !glm::any(glm::isinf(p)); }));
    if (m_data.normals.empty()) m_data.normals = areaWeightedNormals(m_data.positions, m_data.indices);
    m_localBounds = boundsOfUsed(m_data.positions, m_data.indices);
}

const Sphere& TriangleMesh::localSphere() const {
    std::call_once(m_sphereOnce, [this] { m_sphere = boundingSphere(m_data.positions); });
    return m_sphere;
}

const Topology& TriangleMesh::topology() const {
    std::call_once(m_topologyOnce, [this] {
        const EdgeCounts edges = countEdges(m_data.positions, m_data.indices, {});
        m_topology.boundaryEdges = edges.boundary;
        m_topology.nonManifoldEdges = edges.nonManifold;
        m_topology.inconsistentEdges = edges.inconsistent;
        m_topology.closed = !m_data.indices.empty() && edges.boundary == 0 && edges.nonManifold == 0;
        m_topology.consistentlyOriented = edges.inconsistent == 0;
        m_topology.outward = signedVolume(m_data.positions, m_data.indices, m_localBounds) > 0.0;
    });
    return m_topology;
}

Pockets TriangleMesh::pockets(const Progress& progress) const {
    if (!topology().closed || !topology().consistentlyOriented) return Pockets::NotProven;
    std::call_once(m_pocketsOnce, [&] { m_pockets = pocketsInsideOut(*this, progress); });
    return m_pockets;
}

size_t TriangleMesh::bytes() const {
    return m_data.positions.size() * sizeof(Vec3f) + m_data.normals.size() * sizeof(Vec3f) +
           m_data.indices.size() * sizeof(uint32_t);
}

}  // namespace cullscope
