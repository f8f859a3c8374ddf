#pragma once

#include <memory>

#include "core/geometry/spherical_grid.h"
#include "core/mesh/triangle_mesh.h"
#include "core/spatial/cell_lists.h"

namespace cullscope {

/// Where the spherical coordinates of a mesh's maps begin, and which way their pole points.
struct MapFrame {
    Sphere sphere;          ///< around the mesh, relative to its origin: R is the distance from its centre
    Mat3 meshFromMap{1.0};  ///< a rotation: its third column is the polar axis, θ = 0, its first one φ = 0
};

/// The three structures of Han & Hong 2008, section 2.2 and Table 1, for one mesh. Directions and radii are relative to the
/// centre of a sphere around the mesh, by default its bounding sphere, in the mesh's coordinates or, with another polar axis, in
/// these turned.
class SphericalMaps {
public:
    /// The range of distances from the centre of the surface in a cell; empty: nearest > farthest.
    struct Extent {
        float nearest = 1.0f;
        float farthest = 0.0f;

        [[nodiscard]] bool empty() const { return nearest > farthest; }
    };

    struct Bytes {
        uint64_t centroidMap = 0, indexMap = 0, accessMap = 0;

        [[nodiscard]] uint64_t all() const { return centroidMap + indexMap + accessMap; }
    };

    struct BuildTimes {
        double centroidMap = 0.0, indexMap = 0.0, accessMap = 0.0;  ///< milliseconds
    };

    static constexpr uint64_t kMostEntries = 400'000'000;  ///< of the index map: 5 GB during the build, 1.6 GB afterwards
    /// Built in parallel; the result does not depend on the number of threads. Throws Error(Usage) where the index map would have
    /// more than `mostEntries` entries, Error(Interrupted) on a stop request.
    SphericalMaps(MeshPointer mesh, SphericalGrid grid, const Progress& progress = {}, uint64_t mostEntries = kMostEntries);

    /// The same in other coordinates.
    SphericalMaps(MeshPointer mesh, SphericalGrid grid, const MapFrame& frame, const Progress& progress = {},
                  uint64_t mostEntries = kMostEntries);

    [[nodiscard]] const TriangleMesh& mesh() const { return *m_mesh; }
    [[nodiscard]] const SphericalGrid& grid() const { return m_grid; }
    /// The bounding sphere, relative to the mesh's origin.
    [[nodiscard]] const Sphere& sphere() const { return m_frame.sphere; }
    [[nodiscard]] const Mat3& meshFromMap() const { return m_frame.meshFromMap; }
    [[nodiscard]] const MapFrame& frame() const { return m_frame; }
    /// The corners of a triangle relative to the centre, in the maps' coordinates.
    [[nodiscard]] std::array<Vec3, 3> corners(uint32_t triangle) const;

    /// The centroid map: each triangle is in one cell, that of its centroid (the centroid as a vector, never the mean of angles);
    /// inside a cell by ascending R.
    [[nodiscard]] std::span<const uint32_t> centroids(uint32_t cell) const { return m_centroids.of(cell); }
    [[nodiscard]] float centroidRadius(uint32_t triangle) const { return m_centroidRadii[triangle]; }
    /// The triangle index map: each triangle is in every cell that it touches, by ascending R of the centroid.
    [[nodiscard]] std::span<const uint32_t> triangles(uint32_t cell) const { return m_index.of(cell); }
    /// Bounds on the distances of the index map's triangles of a cell, within this cell.
    [[nodiscard]] const Extent& extent(uint32_t cell) const { return m_extents[cell]; }
    [[nodiscard]] uint64_t indexEntries() const { return m_index.size(); }

    /// The memory access map: the triangles' corners in the centroid map's order, so that consecutive cells are one range.
    [[nodiscard]] std::span<const uint32_t> indices() const { return m_indices; }
    /// The range of the cells [first, last): its start and length in triangles.
    [[nodiscard]] std::pair<uint64_t, uint64_t> run(uint32_t first, uint32_t last) const {
        return {m_centroids.start(first), m_centroids.start(last) - m_centroids.start(first)};
    }
    /// The number in the mesh of the triangle at each place of that order.
    [[nodiscard]] std::span<const uint32_t> triangleOrder() const { return m_centroids.values(); }
    [[nodiscard]] uint32_t triangleAt(uint64_t place) const { return triangleOrder()[place]; }

    [[nodiscard]] Bytes bytes() const;
    [[nodiscard]] const BuildTimes& buildTimes() const { return m_times; }

private:
    void buildCentroidMap(const Progress& progress);
    void buildIndexMap(const Progress& progress, uint64_t mostEntries);
    void buildAccessMap();
    void measureExtents(const Progress& progress);
    void sortByRadius(CellLists& lists, const Progress& progress) const;

    MeshPointer m_mesh;
    SphericalGrid m_grid;
    MapFrame m_frame;
    std::vector<float> m_centroidRadii;  ///< by triangle
    CellLists m_centroids;
    CellLists m_index;
    std::vector<Extent> m_extents;    ///< by cell
    std::vector<uint32_t> m_indices;  ///< three for each triangle
    BuildTimes m_times;
};

using SphericalMapsPointer = std::shared_ptr<const SphericalMaps>;

}  // namespace cullscope
