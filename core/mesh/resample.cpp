#include "core/mesh/resample.h"

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/LoopT.hh>
#include <algorithm>
#include <numeric>

#include "core/base/error.h"
#include "core/base/memory_limit.h"
#include "core/mesh/half_edge_mesh.h"
#include "core/mesh/weld.h"

namespace cullscope {
namespace {

/// Points, normals, half-edges and the data of OpenMesh's algorithms, measured with the bunny.
constexpr double kBytesPerTriangle = 400.0;

/// Reports the progress of the decimation and ends it on a stop request. (HalfEdgeMesh checks for one while the decimater's heap
/// is filled.)
class DecimationProgress : public OpenMesh::Decimater::Observer {
public:
    DecimationProgress(const Progress& progress, size_t collapses)
        : Observer(512), m_progress(progress), m_collapses(collapses) {}
    void notify(size_t step) override {
        m_progress.check();
        m_progress.tell(std::min(1.0, static_cast<double>(step) / static_cast<double>(m_collapses)),
                        CULLSCOPE_TR("Simplifying the mesh"));
    }

private:
    const Progress& m_progress;
    size_t m_collapses;
};

size_t faceCount(const HalfEdgeMesh& mesh) {
    size_t count = 0;
    for ([[maybe_unused]] const auto face : mesh.faces()) ++count;
    return count;
}

enum class Folds { Refused, Allowed };

void collapseEdges(HalfEdgeMesh& mesh, size_t triangles, Folds folds, const Progress& progress) {
    OpenMesh::Decimater::DecimaterT<HalfEdgeMesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<HalfEdgeMesh>::Handle quadric;
    decimater.add(quadric);
    decimater.module(quadric).unset_max_err();
    OpenMesh::Decimater::ModNormalFlippingT<HalfEdgeMesh>::Handle flipping;
    if (folds == Folds::Refused) {
        decimater.add(flipping);
        decimater.module(flipping).set_max_normal_deviation(90.0);
    }
    decimater.initialize();
    const size_t faces = faceCount(mesh);
    DecimationProgress observer(progress, std::max<size_t>(1, (faces - std::min(faces, triangles)) / 2));
    decimater.set_observer(&observer);
    decimater.decimate_to_faces(0, triangles);
}

void prepareForDecimation(HalfEdgeMesh& mesh) {
    mesh.request_vertex_status();
    mesh.request_edge_status();
    mesh.request_halfedge_status();
    mesh.request_face_status();
    mesh.request_face_normals();
    mesh.update_face_normals();
}

/// Decimates to a count. Collapses that flip a face are allowed only where the count cannot be reached without them.
void decimate(HalfEdgeMesh& mesh, size_t triangles, const Progress& progress) {
    prepareForDecimation(mesh);
    collapseEdges(mesh, triangles, Folds::Refused, progress);
    mesh.garbage_collection();
    if (mesh.n_faces() > triangles + 1) collapseEdges(mesh, triangles, Folds::Allowed, progress);
}

/// Collapsing an inner edge removes two triangles, so the count may end one too low. Splitting the longest boundary edge adds one
/// and does not change the surface; a closed mesh always has an even count.
void addOneTriangle(HalfEdgeMesh& mesh) {
    HalfEdgeMesh::EdgeHandle longest;
    for (const auto edge : mesh.edges())
        if (mesh.is_boundary(edge) &&
            (!longest.is_valid() || mesh.calc_edge_sqr_length(edge) > mesh.calc_edge_sqr_length(longest)))
            longest = edge;
    if (longest.is_valid()) mesh.split(longest, mesh.calc_edge_midpoint(longest));
}

void refuseTooLarge(double triangles) {
    if (triangles * kBytesPerTriangle > static_cast<double>(memoryToPlanWith()))
        throwUsage(
            CULLSCOPE_TR(
                "Changing the mesh to so many triangles needs about %1 MB of memory, more than three quarters of this machine's. "
                "Ask for fewer triangles."),
            {std::to_string(static_cast<uint64_t>(triangles * kBytesPerTriangle / (1 << 20)))});
}

/// Every level of Loop's scheme divides a triangle into four.
int levelsNeeded(size_t from, size_t triangles) {
    int levels = 0;
    double count = static_cast<double>(from);
    for (; count < static_cast<double>(triangles); count *= 4.0) ++levels;
    refuseTooLarge(count);
    return levels;
}

void subdivide(HalfEdgeMesh& mesh, int levels, const Progress& progress) {
    OpenMesh::Subdivider::Uniform::LoopT<HalfEdgeMesh> loop;
    for (int level = 0; level < levels; ++level) {
        progress.tell(static_cast<double>(level) / levels, CULLSCOPE_TR("Subdividing the mesh"));
        progress.check();
        loop(mesh, 1);
    }
}

MeshPointer copied(const TriangleMesh& mesh) {
    TriangleMesh::Data data;
    data.name = mesh.name();
    data.origin = mesh.origin();
    data.positions.assign(mesh.positions().begin(), mesh.positions().end());
    data.normals.assign(mesh.normals().begin(), mesh.normals().end());
    data.indices.assign(mesh.indices().begin(), mesh.indices().end());
    return std::make_shared<const TriangleMesh>(std::move(data));
}

}  // namespace

MeshPointer resampled(const TriangleMesh& mesh, size_t triangles, const Progress& progress) {
    if (triangles == 0 || mesh.triangleCount() == 0)
        throwUsage(CULLSCOPE_TR("A mesh cannot be changed to or from %1 triangles. Ask for at least one triangle."), {"0"});
    if (triangles == mesh.triangleCount()) return copied(mesh);
    refuseTooLarge(static_cast<double>(mesh.triangleCount()));
    HalfEdgeConversion conversion(mesh, progress);
    HalfEdgeMesh& halfEdges = conversion.mesh();
    if (halfEdges.n_faces() == 0)
        throwUsage(CULLSCOPE_TR("The mesh \"%1\" has no surface that could be simplified or subdivided."), {mesh.name()});
    subdivide(halfEdges, levelsNeeded(halfEdges.n_faces(), triangles), progress.part(0.1, 0.4));
    if (halfEdges.n_faces() > triangles) decimate(halfEdges, triangles, progress.part(0.4, 0.95));

    if (faceCount(halfEdges) + 1 == triangles) addOneTriangle(halfEdges);
    const size_t reached = faceCount(halfEdges);
    const double difference = std::abs(static_cast<double>(reached) - static_cast<double>(triangles));
    if (difference > 0.001 * static_cast<double>(triangles) + 2.0)
        throwUsage(CULLSCOPE_TR("The mesh \"%1\" cannot be changed to %2 triangles: its pieces hold together only down to %3. "
                                "Ask for at least that "
                                "many."),
                   {mesh.name(), std::to_string(triangles), std::to_string(reached)});
    return conversion.flattened(progress);
}

namespace {

/// The triangles of a half-edge mesh between the vertices of its source.
class BetweenSourceVertices {
public:
    BetweenSourceVertices(const TriangleMesh& mesh, const Progress& progress)
        : m_mesh(mesh), m_welded(firstOfEqualPositions(mesh.positions(), progress)), m_sorted(m_welded.size()) {
        std::iota(m_sorted.begin(), m_sorted.end(), 0U);
        std::ranges::stable_sort(m_sorted, {}, [&](uint32_t vertex) { return m_welded[vertex]; });
    }

    [[nodiscard]] std::vector<uint32_t> indices(const HalfEdgeConversion& conversion, HalfEdgeMesh& halfEdges) const {
        std::vector<uint32_t> indices;
        for (const auto face : halfEdges.faces()) {
            std::array<uint32_t, 3> corners{};
            size_t corner = 0;
            for (const auto vertex : halfEdges.fv_range(face)) corners[corner++] = conversion.sourceOf(vertex);
            const auto [a, b, c] = std::array{Vec3(m_mesh.positions()[corners[0]]), Vec3(m_mesh.positions()[corners[1]]),
                                              Vec3(m_mesh.positions()[corners[2]])};
            for (const uint32_t vertex : corners) indices.push_back(nearestNormal(vertex, glm::cross(b - a, c - a)));
        }
        return indices;
    }

private:
    /// Of the vertices at a vertex's place, the one whose normal points most in a direction.
    [[nodiscard]] uint32_t nearestNormal(uint32_t vertex, const Vec3& direction) const {
        const auto [first, last] = std::equal_range(m_sorted.begin(), m_sorted.end(), vertex,
                                                    [&](uint32_t a, uint32_t b) { return m_welded[a] < m_welded[b]; });
        const auto along = [&](uint32_t i) { return glm::dot(Vec3(m_mesh.normals()[i]), direction); };
        return *std::max_element(first, last, [&](uint32_t a, uint32_t b) { return along(a) < along(b); });
    }

    const TriangleMesh& m_mesh;
    std::vector<uint32_t> m_welded, m_sorted;
};

}  // namespace

std::vector<MeshLevel> quadricLevels(const TriangleMesh& mesh, size_t fewest, const Progress& progress) {
    std::vector<MeshLevel> levels;
    HalfEdgeConversion conversion(mesh, progress);
    HalfEdgeMesh& halfEdges = conversion.mesh();
    const BetweenSourceVertices between(mesh, progress);
    prepareForDecimation(halfEdges);
    for (size_t before = halfEdges.n_faces(); before > fewest;) {
        progress.check();
        collapseEdges(halfEdges, std::max(fewest, before / 2), Folds::Refused, {nullptr, progress.stop});
        halfEdges.garbage_collection();
        const size_t reached = halfEdges.n_faces();
        if (reached == 0 || 3 * reached > 2 * before) break;
        levels.push_back({between.indices(conversion, halfEdges), 0.0});
        before = reached;
    }
    return levels;
}

}  // namespace cullscope
