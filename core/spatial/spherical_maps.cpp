#include "core/spatial/spherical_maps.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/work_check.h"
#include "core/geometry/rounding.h"
#include "core/geometry/triangle.h"
#include "core/spatial/spherical_triangle.h"

namespace cullscope {

namespace {

using Clock = std::chrono::steady_clock;
using Range = tbb::blocked_range<uint32_t>;

// A fixed size, so that entries have the same order on every machine.
constexpr uint32_t kTrianglesPerPart = 8192;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double farthestRadius(const std::array<Vec3, 3>& corners) {
    return std::max({glm::length(corners[0]), glm::length(corners[1]), glm::length(corners[2])});
}

}  // namespace

SphericalMaps::SphericalMaps(MeshPointer mesh, SphericalGrid grid, const Progress& progress, uint64_t mostEntries)
    : SphericalMaps(mesh, std::move(grid), {mesh->localSphere()}, MapStorage::Cells, progress, mostEntries) {}

SphericalMaps::SphericalMaps(MeshPointer mesh, SphericalGrid grid, const MapFrame& frame, MapStorage storage,
                             const Progress& progress, uint64_t mostEntries)
    : m_mesh(std::move(mesh)), m_grid(std::move(grid)), m_frame(frame), m_storage(storage) {
    auto start = Clock::now();
    buildCentroidMap(progress.part(0.0, 0.3));
    m_times.centroidMap = millisecondsSince(start);
    start = Clock::now();
    buildIndexMap(progress.part(0.3, 0.9), mostEntries);
    m_times.indexMap = millisecondsSince(start);
    start = Clock::now();
    buildAccessMap();
    m_times.accessMap = millisecondsSince(start);
}

std::array<Vec3, 3> SphericalMaps::corners(uint32_t triangle) const {
    std::array<Vec3, 3> result;
    // A vector times a rotation is the inverse rotation of the vector.
    for (size_t i = 0; i < 3; ++i)
        result[i] = (Vec3(m_mesh->positions()[m_mesh->indices()[3 * size_t(triangle) + i]]) - m_frame.sphere.centre) *
                    m_frame.meshFromMap;
    return result;
}

void SphericalMaps::buildCentroidMap(const Progress& progress) {
    progress.tell(0.0, CULLSCOPE_TR("centroid map"));
    const auto count = uint32_t(m_mesh->triangleCount());
    const bool cells = m_storage == MapStorage::Cells;
    m_centroidRadii.resize(cells ? count : 0);
    m_centroidPlaces.resize(cells ? 0 : count);
    std::vector<std::vector<CellLists::Entry>> entries(1);
    entries[0].resize(count);
    tbb::parallel_for(Range(0, count, kTrianglesPerPart), [&](const Range& part) {
        if (progress.stopRequested()) return;
        for (uint32_t triangle = part.begin(); triangle < part.end(); ++triangle) {
            const std::array<Vec3, 3> points = corners(triangle);
            const Vec3 centroid = (points[0] + points[1] + points[2]) / 3.0;
            const auto radius = float(glm::length(centroid));
            if (cells) {
                m_centroidRadii[triangle] = radius;
            } else {
                const Vec2 angles = mapAngles(centroid);
                m_centroidPlaces[triangle] = {radius, float(angles.x), float(angles.y)};
            }
            entries[0][triangle] = {m_grid.number(m_grid.cellOf(centroid)), triangle};
        }
    });
    progress.check();
    m_centroids = CellLists(m_grid.cellCount(), entries, progress);
    sortByRadius(m_centroids, progress);
}

void SphericalMaps::buildIndexMap(const Progress& progress, uint64_t mostEntries) {
    progress.tell(0.0, CULLSCOPE_TR("triangle index map"));
    const auto count = uint32_t(m_mesh->triangleCount());
    std::vector<std::vector<CellLists::Entry>> parts((count + kTrianglesPerPart - 1) / kTrianglesPerPart);
    std::atomic<uint64_t> total = 0;
    tbb::parallel_for(Range(0, uint32_t(parts.size()), 1), [&](const Range& range) {
        for (uint32_t part = range.begin(); part < range.end(); ++part) {
            const uint32_t end = std::min(count, (part + 1) * kTrianglesPerPart);
            for (uint32_t triangle = part * kTrianglesPerPart; triangle < end; ++triangle) {
                if (progress.stopRequested() || total > mostEntries) return;
                const std::array<Vec3, 3> points = corners(triangle);
                const size_t before = parts[part].size();
                SphericalTriangle(points[0], points[1], points[2]).forEachCell(m_grid, [&](const SphericalGrid::Cell& cell) {
                    parts[part].emplace_back(m_grid.number(cell), triangle);
                });
                total += parts[part].size() - before;
            }
        }
    });
    progress.check();
    if (total > mostEntries)
        throwUsage(CULLSCOPE_TR("The triangle index map of %1 would have more than %2 entries: choose a lower resolution."),
                   {m_mesh->name(), std::to_string(mostEntries)});
    m_index = CellLists(m_grid.cellCount(), parts, progress);
    parts = {};
    progress.tell(0.8, CULLSCOPE_TR("triangle index map"));
    sortByRadius(m_index, progress);
    if (m_storage == MapStorage::Cells)
        measureExtents(progress);
    else
        keepRadii(progress);
}

void SphericalMaps::measureExtents(const Progress& progress) {
    m_extents.resize(m_grid.cellCount());
    tbb::parallel_for(Range(0, m_grid.cellCount()), [&](const Range& cells) {
        WorkCheck work(progress);
        for (uint32_t cell = cells.begin(); cell < cells.end(); ++cell) m_extents[cell] = extentOfTriangles(cell, &work);
    });
}

SphericalMaps::Extent SphericalMaps::extentOfTriangles(uint32_t cell, WorkCheck* work) const {
    Extent extent{std::numeric_limits<float>::infinity(), 0.0f};
    for (const uint32_t triangle : m_index.of(cell)) {
        if (work != nullptr) work->step();
        const std::array<Vec3, 3> points = corners(triangle);
        extent.nearest = std::min(extent.nearest, floatBelow(nearestDistance(points)));
        extent.farthest = std::max(extent.farthest, floatAbove(farthestRadius(points)));
    }
    return extent;
}

void SphericalMaps::keepRadii(const Progress& progress) {
    m_entryRadii.resize(m_index.size());
    std::ranges::transform(m_index.values(), m_entryRadii.begin(),
                           [this](uint32_t triangle) { return centroidRadius(triangle); });
    m_spread = tbb::parallel_reduce(
        Range(0, uint32_t(m_mesh->triangleCount())), 0.0,
        [&](const Range& triangles, double most) {
            WorkCheck work(progress);
            for (uint32_t triangle = triangles.begin(); triangle < triangles.end(); ++triangle) {
                work.step();
                const std::array<Vec3, 3> points = corners(triangle);
                const double radius = centroidRadius(triangle);
                most = std::max({most, radius - nearestDistance(points), farthestRadius(points) - radius});
            }
            return most;
        },
        [](double a, double b) { return std::max(a, b); });
    // As far beyond as a distance rounded to a float, which bounds of cells are.
    m_spread += 1.2e-7 * m_frame.sphere.radius;
}

std::span<const uint32_t> SphericalMaps::trianglesBetween(uint32_t cell, double nearest, double farthest) const {
    const std::span<const uint32_t> all = m_index.of(cell);
    if (m_storage == MapStorage::Cells) {
        const Extent& extent = m_extents[cell];
        return !extent.empty() && nearest <= extent.farthest && farthest >= extent.nearest ? all : all.first(0);
    }
    const std::span<const float> radii(m_entryRadii.data() + m_index.start(cell), all.size());
    const auto first = std::ranges::lower_bound(radii, nearest - m_spread);
    const auto last = std::upper_bound(first, radii.end(), farthest + m_spread);
    return all.subspan(size_t(first - radii.begin()), size_t(last - first));
}

void SphericalMaps::buildAccessMap() {
    const std::span<const uint32_t> order = m_centroids.values();
    m_indices.resize(3 * order.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, order.size(), kTrianglesPerPart), [&](const auto& places) {
        for (size_t place = places.begin(); place < places.end(); ++place)
            for (size_t i = 0; i < 3; ++i) m_indices[3 * place + i] = m_mesh->indices()[3 * size_t(order[place]) + i];
    });
    if (m_storage == MapStorage::Cells) return;
    m_access.resize(m_grid.cellCount());
    uint32_t previous = 0;
    for (uint32_t cell = 0; cell < m_grid.cellCount(); ++cell) {
        m_access[cell] = {uint32_t(m_centroids.start(cell)), uint32_t(m_centroids.of(cell).size()), previous, 0};
        if (m_access[cell].count > 0) previous = cell;
    }
    uint32_t next = m_grid.cellCount();
    for (uint32_t cell = m_grid.cellCount(); cell-- > 0;) {
        m_access[cell].next = next;
        if (m_access[cell].count > 0) next = cell;
    }
}

void SphericalMaps::sortByRadius(CellLists& lists, const Progress& progress) const {
    const auto nearer = [this](uint32_t a, uint32_t b) {
        const float of = centroidRadius(a), other = centroidRadius(b);
        return of != other ? of < other : a < b;
    };
    tbb::parallel_for(Range(0, lists.cellCount()), [&](const Range& cells) {
        WorkCheck work(progress);
        for (uint32_t cell = cells.begin(); cell < cells.end(); ++cell) {
            const std::span<uint32_t> triangles = lists.of(cell);
            std::sort(triangles.begin(), triangles.end(), work.counting(nearer));
        }
    });
}

SphericalMaps::Bytes SphericalMaps::bytes() const {
    const auto of = [](const auto& values) { return values.size() * sizeof(values.front()); };
    return {m_centroids.bytes() + of(m_centroidRadii) + of(m_centroidPlaces), m_index.bytes() + of(m_extents) + of(m_entryRadii),
            of(m_indices) + of(m_access)};
}

}  // namespace cullscope
