#pragma once

#include <OpenMesh/Core/Mesh/DefaultTriMesh.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// OpenMesh's half-edges in double, for simplifying and subdividing only. Its algorithms take minutes on large meshes and ask
/// nobody; but as templates they call the functions below, which ask for a stop now and then and leave by an exception.
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

/// The triangles of a mesh as half-edges, in coordinates that are centred and of about 1. Corners at equal positions become one
/// vertex; where that leaves an edge with more than two triangles or a vertex with several fans, copies of vertices take
/// the surplus triangles, so that nothing is lost.
class HalfEdgeConversion {
public:
    HalfEdgeConversion(const TriangleMesh& mesh, const Progress& progress);

    [[nodiscard]] HalfEdgeMesh& mesh() { return m_halfEdges; }
    /// The half-edges as flat arrays again, about the origin of the mesh they came from. Leaves no deleted elements behind.
    [[nodiscard]] MeshPointer flattened(const Progress& progress);

private:
    void addFaces(const Progress& progress);

    const TriangleMesh& m_source;
    HalfEdgeMesh m_halfEdges;
    Vec3 m_centre;
    double m_scale;
};

}  // namespace cullscope
