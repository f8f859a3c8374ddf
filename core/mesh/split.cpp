#include "core/mesh/split.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "core/base/error.h"
#include "core/mesh/steps.h"
#include "core/mesh/weld.h"

namespace cullscope {
namespace {

/// Triangle numbers, part after part; part i is [ends[i − 1], ends[i]).
struct Parts {
    std::vector<uint32_t> triangles;
    std::vector<size_t> ends;
};

/// A disjoint-set forest of connected vertices; every vertex points towards its tree's root.
class Forest {
public:
    explicit Forest(size_t vertices) : m_parent(vertices) { std::iota(m_parent.begin(), m_parent.end(), 0U); }

    uint32_t root(uint32_t vertex) {
        while (m_parent[vertex] != vertex) {
            m_parent[vertex] = m_parent[m_parent[vertex]];
            vertex = m_parent[vertex];
        }
        return vertex;
    }
    /// Joins two trees; the lower number becomes the root.
    void join(uint32_t a, uint32_t b) {
        a = root(a);
        b = root(b);
        m_parent[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<uint32_t> m_parent;
};

void refuseTooMany(const TriangleMesh& mesh, size_t parts) {
    if (parts > kMostParts)
        throwUsage(
            CULLSCOPE_TR("The mesh \"%1\" would fall into %2 parts; at most %3 can be objects. Split it by=clusters with more "
                         "triangles each."),
            {mesh.name(), std::to_string(parts), std::to_string(kMostParts)});
}

/// The component number of each triangle, counted in the order of their first triangles, and the number of triangles of each
/// component.
struct Labels {
    std::vector<uint32_t> ofTriangle;
    std::vector<size_t> triangles;
};

Labels componentLabels(const TriangleMesh& mesh, const Progress& progress) {
    const std::vector<uint32_t> welded = firstOfEqualPositions(mesh.positions(), progress);
    const std::span indices = mesh.indices();
    Forest forest(welded.size());
    inSteps(mesh.triangleCount(), progress, [&](size_t begin, size_t end) {
        for (size_t t = begin; t < end; ++t) {
            forest.join(welded[indices[3 * t]], welded[indices[3 * t + 1]]);
            forest.join(welded[indices[3 * t]], welded[indices[3 * t + 2]]);
        }
    });
    constexpr uint32_t kNone = UINT32_MAX;
    std::vector<uint32_t> labelOfRoot(welded.size(), kNone);
    Labels labels;
    labels.ofTriangle.resize(mesh.triangleCount());
    inSteps(mesh.triangleCount(), progress, [&](size_t begin, size_t end) {
        for (size_t t = begin; t < end; ++t) {
            uint32_t& label = labelOfRoot[forest.root(welded[indices[3 * t]])];
            if (label == kNone) {
                label = static_cast<uint32_t>(labels.triangles.size());
                labels.triangles.push_back(0);
            }
            labels.ofTriangle[t] = label;
            ++labels.triangles[label];
        }
    });
    return labels;
}

Parts componentParts(const TriangleMesh& mesh, const Progress& progress) {
    const Labels labels = componentLabels(mesh, progress);
    refuseTooMany(mesh, labels.triangles.size());
    std::vector<uint32_t> order(labels.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return labels.triangles[a] > labels.triangles[b]; });
    Parts parts;
    std::vector<size_t> next(order.size());
    size_t end = 0;
    for (const uint32_t label : order) {
        next[label] = end;
        end += labels.triangles[label];
        parts.ends.push_back(end);
    }
    parts.triangles.resize(mesh.triangleCount());
    inSteps(mesh.triangleCount(), progress, [&](size_t begin, size_t stop) {
        for (size_t t = begin; t < stop; ++t) parts.triangles[next[labels.ofTriangle[t]]++] = static_cast<uint32_t>(t);
    });
    return parts;
}

/// Halves the triangles by their centroids until no cluster has too many.
class Clustering {
public:
    Clustering(const TriangleMesh& mesh, const Progress& progress)
        : m_progress(progress), m_centroids(mesh.triangleCount(), Vec3f(0.0F)) {
        m_parts.triangles.resize(mesh.triangleCount());
        std::iota(m_parts.triangles.begin(), m_parts.triangles.end(), 0U);
        inSteps(mesh.triangleCount(), progress, [&](size_t begin, size_t end) {
            for (size_t t = begin; t < end; ++t)
                for (size_t corner = 0; corner < 3; ++corner)
                    m_centroids[t] += mesh.positions()[mesh.indices()[3 * t + corner]] / 3.0F;
        });
    }

    Parts run(size_t clusters) {
        m_clusters = clusters;
        if (clusters > 0) halve(0, m_parts.triangles.size(), clusters);
        return std::move(m_parts);
    }

private:
    [[nodiscard]] int longestAxis(size_t begin, size_t end) const {
        Vec3f least(std::numeric_limits<float>::infinity());
        Vec3f most(-std::numeric_limits<float>::infinity());
        inSteps(end - begin, m_progress, [&](size_t from, size_t to) {
            for (size_t i = begin + from; i < begin + to; ++i) {
                least = glm::min(least, m_centroids[m_parts.triangles[i]]);
                most = glm::max(most, m_centroids[m_parts.triangles[i]]);
            }
        });
        const Vec3 extent = Vec3(most) - Vec3(least);
        return extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    }

    /// Divides [begin, end) into `clusters / 2` clusters on the left and the rest on the right, in proportion. Both sides have
    /// enough clusters for their triangles: count ≤ clusters · most gives ⌊count · left / clusters⌋ ≤ left · most, and likewise
    /// on the right.
    void halve(size_t begin, size_t end, size_t clusters) {
        if (clusters == 1) {
            std::sort(m_parts.triangles.begin() + std::ptrdiff_t(begin), m_parts.triangles.begin() + std::ptrdiff_t(end));
            m_parts.ends.push_back(end);
            m_progress.tell(double(m_parts.ends.size()) / double(m_clusters), CULLSCOPE_TR("Splitting the mesh"));
            return;
        }
        const size_t left = clusters / 2;
        const size_t middle = begin + (end - begin) * left / clusters;
        const int axis = longestAxis(begin, end);
        // Ties are broken by the triangle's number, so that the result is the same on every machine. A selection among millions
        // checks for a stop request.
        uint32_t asked = 0;
        const auto before = [&](uint32_t a, uint32_t b) {
            if (++asked % 65536 == 0) m_progress.check();
            const float x = m_centroids[a][axis];
            const float y = m_centroids[b][axis];
            return x < y || (x == y && a < b);
        };
        const auto first = m_parts.triangles.begin();
        std::nth_element(first + std::ptrdiff_t(begin), first + std::ptrdiff_t(middle), first + std::ptrdiff_t(end), before);
        halve(begin, middle, left);
        halve(middle, end, clusters - left);
    }

    const Progress& m_progress;
    std::vector<Vec3f> m_centroids;
    Parts m_parts;
    size_t m_clusters = 0;
};

/// Makes a mesh of each part; vertices are renumbered in the order in which the part's triangles use them.
class Extraction {
public:
    explicit Extraction(const TriangleMesh& mesh)
        : m_mesh(mesh), m_newNumber(mesh.vertexCount()), m_lastPart(mesh.vertexCount(), UINT32_MAX) {}

    MeshPointer part(std::span<const uint32_t> triangles, const Progress& progress) {
        TriangleMesh::Data data;
        data.name = m_mesh.name() + " " + std::to_string(++m_part);
        data.origin = m_mesh.origin();
        data.indices.reserve(3 * triangles.size());
        inSteps(triangles.size(), progress, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i)
                for (size_t corner = 0; corner < 3; ++corner)
                    data.indices.push_back(numberOf(m_mesh.indices()[3 * size_t{triangles[i]} + corner], data));
        });
        return std::make_shared<const TriangleMesh>(std::move(data));
    }

private:
    uint32_t numberOf(uint32_t vertex, TriangleMesh::Data& data) {
        if (m_lastPart[vertex] != m_part) {
            m_lastPart[vertex] = m_part;
            m_newNumber[vertex] = static_cast<uint32_t>(data.positions.size());
            data.positions.push_back(m_mesh.positions()[vertex]);
            data.normals.push_back(m_mesh.normals()[vertex]);
        }
        return m_newNumber[vertex];
    }

    const TriangleMesh& m_mesh;
    std::vector<uint32_t> m_newNumber, m_lastPart;
    uint32_t m_part = 0;
};

std::vector<MeshPointer> extracted(const MeshPointer& mesh, const Parts& parts, const Progress& progress) {
    if (parts.ends.size() <= 1) return {mesh};
    Extraction extraction(*mesh);
    std::vector<MeshPointer> meshes;
    size_t begin = 0;
    for (const size_t end : parts.ends) {
        progress.tell(double(begin) / double(parts.triangles.size()), CULLSCOPE_TR("Splitting the mesh"));
        meshes.push_back(extraction.part(std::span(parts.triangles).subspan(begin, end - begin), progress));
        begin = end;
    }
    return meshes;
}

}  // namespace

std::vector<MeshPointer> components(const MeshPointer& mesh, const Progress& progress) {
    progress.tell(0.0, CULLSCOPE_TR("Splitting the mesh"));
    const Parts parts = componentParts(*mesh, progress);
    return extracted(mesh, parts, progress.part(0.5, 1.0));
}

std::vector<MeshPointer> clusters(const MeshPointer& mesh, size_t most, const Progress& progress) {
    assert(most > 0);
    const size_t count = (mesh->triangleCount() + most - 1) / most;
    refuseTooMany(*mesh, count);
    const Progress halving = progress.part(0.0, 0.6);
    const Parts parts = Clustering(*mesh, halving).run(count);
    return extracted(mesh, parts, progress.part(0.6, 1.0));
}

}  // namespace cullscope
