#pragma once

#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// OpenMesh's half-edges in double, for simplification and subdivision only. Its algorithms take minutes on large meshes and have
/// no way to be stopped. As templates they call the functions below, which check for a stop request now and then and throw an
/// exception.
class HalfEdgeMesh : public OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble> {
public:
    using Base = OpenMesh::TriMesh_ArrayKernelT<OpenMesh::DefaultTraitsDouble>;

    explicit HalfEdgeMesh(const Progress& progress) : m_progress(progress) {}

    [[nodiscard]] const Point& point(VertexHandle vertex) const {
        poll();
        return Base::point(vertex);
    }
    [[nodiscard]] Point& point(VertexHandle vertex) {
        poll();
        return Base::point(vertex);
    }
    OpenMesh::SmartVertexHandle new_vertex(const Point& point) {
        poll();
        return Base::new_vertex(point);
    }
    FaceHandle new_face() {
        poll();
        return Base::new_face();
    }

private:
    void poll() const {
        if (++m_calls % 8192 == 0) m_progress.check();
    }

    const Progress& m_progress;
    mutable unsigned m_calls = 0;
};

/// The triangles of a mesh as half-edges, in centred coordinates of a size of about 1. Corners at equal positions become one
/// vertex; where that leaves an edge with more than two triangles or a vertex with several fans, the surplus triangles use copies
/// of vertices, so that no triangle is lost.
class HalfEdgeConversion {
public:
    HalfEdgeConversion(const TriangleMesh& mesh, const Progress& progress);

    [[nodiscard]] HalfEdgeMesh& mesh() { return m_halfEdges; }
    /// A vertex of the source mesh at the position of a half-edge vertex: one of those that became it.
    [[nodiscard]] uint32_t sourceOf(HalfEdgeMesh::VertexHandle vertex) const { return m_halfEdges.property(m_sources, vertex); }
    /// The half-edges as a mesh of flat arrays, about the origin of the source mesh. Removes deleted elements from the half-edge
    /// mesh.
    [[nodiscard]] MeshPointer flattened(const Progress& progress);

private:
    void addFaces(const Progress& progress);

    const TriangleMesh& m_source;
    HalfEdgeMesh m_halfEdges;
    OpenMesh::VPropHandleT<uint32_t> m_sources;
    Vec3 m_centre;
    double m_scale;
};

}  // namespace cullscope
