#pragma once

#include <memory>

#include "core/geometry/spherical_grid.h"
#include "core/mesh/triangle_mesh.h"
#include "core/spatial/cell_lists.h"

namespace cullscope {

class WorkCheck;

/// Where the spherical coordinates of a mesh's maps begin, and which way their pole points.
struct MapFrame {
    Sphere sphere;          ///< around the mesh, relative to its origin: R is the distance from its centre
    Mat3 meshFromMap{1.0};  ///< a rotation: its third column is the polar axis, θ = 0, its first one φ = 0
};

/// What the maps keep of the distances R. A ray's hit is at the same distance with both.
enum class MapStorage {
    /// Of a triangle R of its centroid, of a cell the nearest and the farthest R of the surface in it; of an entry of the index
    /// map a triangle's number alone.
    Cells,
    /// As Table 1 of the paper: of a triangle R, θ, φ and its number (4 × 4 bytes), of an entry of the index map its number and R
    /// of its centroid (2 × 4 bytes, in the cells that it touches; the paper's formula has them in all), of a cell its start, its
    /// count and the occupied cells before and after it (4 × 4 bytes).
    Entries
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

    /// The same in other coordinates and with other storage.
    SphericalMaps(MeshPointer mesh, SphericalGrid grid, const MapFrame& frame, MapStorage storage, const Progress& progress = {},
                  uint64_t mostEntries = kMostEntries);

    [[nodiscard]] const TriangleMesh& mesh() const { return *m_mesh; }
    [[nodiscard]] const SphericalGrid& grid() const { return m_grid; }
    /// The bounding sphere, relative to the mesh's origin.
    [[nodiscard]] const Sphere& sphere() const { return m_frame.sphere; }
    [[nodiscard]] const Mat3& meshFromMap() const { return m_frame.meshFromMap; }
    [[nodiscard]] const MapFrame& frame() const { return m_frame; }
    [[nodiscard]] MapStorage storage() const { return m_storage; }
    /// The corners of a triangle relative to the centre, in the maps' coordinates.
    [[nodiscard]] std::array<Vec3, 3> corners(uint32_t triangle) const;

    /// The centroid map: each triangle is in one cell, that of its centroid (the centroid as a vector, never the mean of angles);
    /// inside a cell by ascending R.
    [[nodiscard]] std::span<const uint32_t> centroids(uint32_t cell) const { return m_centroids.of(cell); }
    [[nodiscard]] float centroidRadius(uint32_t triangle) const {
        return m_storage == MapStorage::Cells ? m_centroidRadii[triangle] : m_centroidPlaces[triangle][0];
    }
    /// The triangle index map: each triangle is in every cell that it touches, by ascending R of the centroid.
    [[nodiscard]] std::span<const uint32_t> triangles(uint32_t cell) const { return m_index.of(cell); }
    /// Those of them that can have a point at one of the distances; more may be among them.
    [[nodiscard]] std::span<const uint32_t> trianglesBetween(uint32_t cell, double nearest, double farthest) const;
    /// Bounds on the distances of the index map's triangles of a cell. With MapStorage::Entries they are found anew, from the
    /// triangles' corners.
    [[nodiscard]] Extent extent(uint32_t cell) const {
        return m_storage == MapStorage::Cells ? m_extents[cell] : extentOfTriangles(cell);
    }
    [[nodiscard]] uint64_t indexEntries() const { return m_index.size(); }

    /// The memory access map: the triangles' corners in the centroid map's order, so that consecutive cells are one range.
    [[nodiscard]] std::span<const uint32_t> indices() const { return m_indices; }
    /// The range of the cells [first, last): its start and length in triangles.
    [[nodiscard]] std::pair<uint64_t, uint64_t> run(uint32_t first, uint32_t last) const {
        const uint64_t start = startOf(first);
        return {start, startOf(last) - start};
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
    void keepRadii(const Progress& progress);
    [[nodiscard]] Extent extentOfTriangles(uint32_t cell, WorkCheck* work = nullptr) const;
    /// The place of the first triangle of a cell and of those after it.
    [[nodiscard]] uint64_t startOf(uint32_t cell) const {
        if (m_storage == MapStorage::Cells || cell == m_grid.cellCount()) return m_centroids.start(cell);
        const CellAccess& access = m_access[cell];
        if (access.count > 0) return access.start;
        return access.next < m_grid.cellCount() ? m_access[access.next].start : m_centroids.size();
    }
    void sortByRadius(CellLists& lists, const Progress& progress) const;

    MeshPointer m_mesh;
    SphericalGrid m_grid;
    MapFrame m_frame;
    MapStorage m_storage;
    CellLists m_centroids;
    CellLists m_index;
    std::vector<uint32_t> m_indices;  ///< three for each triangle

    // Of MapStorage::Cells.
    std::vector<float> m_centroidRadii;  ///< by triangle
    std::vector<Extent> m_extents;       ///< by cell

    // Of MapStorage::Entries.
    /// What the paper's memory access map has of a cell: 0 and the number of cells stand for none before and after it.
    struct CellAccess {
        uint32_t start, count, previous, next;
    };
    std::vector<std::array<float, 3>> m_centroidPlaces;  ///< by triangle: R, θ, φ; the method's steps read R alone
    std::vector<float> m_entryRadii;                     ///< by entry of the index map: R of the triangle's centroid
    double m_spread = 0.0;                               ///< the most by which a triangle's R differ from its centroid's
    std::vector<CellAccess> m_access;                    ///< by cell

    BuildTimes m_times;
};

using SphericalMapsPointer = std::shared_ptr<const SphericalMaps>;

}  // namespace cullscope
