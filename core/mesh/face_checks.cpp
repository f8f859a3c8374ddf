#include "core/mesh/face_checks.h"

#include <algorithm>
#include <array>

#include "core/mesh/polygon.h"
#include "core/mesh/steps.h"

namespace cullscope {
namespace {

enum class Fault : uint8_t { None, OutOfRange, NotFinite, Degenerate };

template <typename Position>
bool noArea(const Position& a, const Position& b, const Position& c) {
    // Differences and products of floats of similar size are exact in double, so the result is zero only for a triangle without
    // area.
    return glm::cross(Vec3(b) - Vec3(a), Vec3(c) - Vec3(a)) == Vec3(0.0);
}

/// One byte of flags for each vertex.
struct VertexMarks {
    std::vector<uint8_t> usable;
    std::vector<uint8_t> named;
};

template <typename Position>
VertexMarks markedVertices(std::span<const Position> positions, const Progress& progress) {
    VertexMarks marks{std::vector<uint8_t>(positions.size()), std::vector<uint8_t>(positions.size())};
    inSteps(positions.size(), progress, [&](size_t begin, size_t end) {
        for (size_t vertex = begin; vertex < end; ++vertex)
            marks.usable[vertex] = usableCoordinates(Vec3(positions[vertex])) ? 1 : 0;
    });
    return marks;
}

template <typename Position>
Fault triangleFault(std::span<const Position> positions, VertexMarks& marks, const uint32_t* corner) {
    const size_t count = positions.size();
    const bool inRange = corner[0] < count && corner[1] < count && corner[2] < count;
    for (int i = 0; i < 3; ++i)
        if (inRange || corner[i] < count) marks.named[corner[i]] = 1;
    if (!inRange) return Fault::OutOfRange;
    if (!(marks.usable[corner[0]] & marks.usable[corner[1]] & marks.usable[corner[2]])) return Fault::NotFinite;
    if (corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0]) return Fault::Degenerate;
    return noArea(positions[corner[0]], positions[corner[1]], positions[corner[2]]) ? Fault::Degenerate : Fault::None;
}

/// The corners of a polygon without those equal to their predecessor.
std::vector<uint32_t> withoutRepeats(std::span<const uint32_t> corners) {
    std::vector<uint32_t> kept;
    for (const uint32_t corner : corners)
        if (kept.empty() || kept.back() != corner) kept.push_back(corner);
    while (kept.size() > 1 && kept.back() == kept.front()) kept.pop_back();
    return kept;
}

Fault polygonFault(const RawMesh& raw, VertexMarks& marks, std::vector<uint32_t>& corners) {
    Fault fault = Fault::None;
    for (const uint32_t corner : corners) {
        if (corner >= marks.named.size())
            fault = Fault::OutOfRange;
        else
            marks.named[corner] = 1;
    }
    if (fault != Fault::None) return fault;
    if (std::ranges::any_of(corners, [&](uint32_t corner) { return !marks.usable[corner]; })) return Fault::NotFinite;
    corners = withoutRepeats(corners);
    if (corners.size() < 3) return Fault::Degenerate;
    std::vector<Vec3> points;
    for (const uint32_t corner : corners) points.push_back(raw.position(corner));
    return doubledArea(points) == Vec3(0.0) ? Fault::Degenerate : Fault::None;
}

void count(Fault fault, LoadReport& report) {
    if (fault == Fault::OutOfRange) ++report.outOfRangeFaces;
    if (fault == Fault::Degenerate) ++report.degenerateFaces;
}

template <typename Position>
void filterTriangles(std::span<const Position> positions, VertexMarks& marks, std::vector<uint32_t>& triangles,
                     LoadReport& report, const Progress& progress) {
    size_t kept = 0;
    inSteps(triangles.size() / 3, progress, [&](size_t begin, size_t end) {
        for (size_t triangle = begin; triangle < end; ++triangle) {
            const uint32_t* corner = triangles.data() + 3 * triangle;
            const Fault fault = triangleFault(positions, marks, corner);
            if (fault != Fault::None)
                count(fault, report);
            else if (kept++ != triangle)
                std::copy_n(corner, 3, triangles.data() + 3 * (kept - 1));
        }
    });
    triangles.resize(3 * kept);
}

/// Keeps the polygons for which `keep(corners)` returns true; `keep` may remove corners.
template <typename Keep>
void filterPolygons(RawMesh& raw, const Progress& progress, Keep&& keep) {
    std::vector<uint32_t> corners;
    size_t begin = 0;
    size_t written = 0;
    size_t kept = 0;
    const auto filter = [&](size_t polygon) {
        const size_t end = raw.polygonEnds[polygon];
        corners.assign(raw.polygonCorners.begin() + begin, raw.polygonCorners.begin() + end);
        begin = end;
        if (!keep(corners)) return;
        std::ranges::copy(corners, raw.polygonCorners.begin() + written);
        written += corners.size();
        raw.polygonEnds[kept++] = written;
    };
    inSteps(
        raw.polygonEnds.size(), progress,
        [&](size_t from, size_t to) {
            for (size_t polygon = from; polygon < to; ++polygon) filter(polygon);
        },
        size_t{1} << 14);
    raw.polygonEnds.resize(kept);
    raw.polygonCorners.resize(written);
}

/// The hash of a face's vertices, beginning with the smallest, and the face's number.
struct FaceKey {
    uint64_t hash = 0;
    uint64_t face = 0;
    auto operator<=>(const FaceKey&) const = default;
};

uint64_t hashOf(std::span<const uint32_t> corners) {
    uint64_t hash = corners.size();
    for (const uint32_t corner : corners) {
        hash = (hash ^ corner) * 0x9e3779b97f4a7c15ULL;
        hash ^= hash >> 31;
    }
    return hash;
}

/// Marks the faces in `keys` that are equal to an earlier one. `corners(face)` begins with the face's smallest vertex.
template <typename Corners>
std::vector<bool> repeatedFaces(std::vector<FaceKey>& keys, const Progress& progress, Corners&& corners) {
    std::vector<bool> repeated(keys.size());
    sortInSteps(std::span(keys), progress);
    const auto equalsEarlier = [&](size_t first, size_t key) {
        for (size_t other = first; other < key; ++other)
            if (std::ranges::equal(corners(keys[other].face), corners(keys[key].face))) return true;
        return false;
    };
    size_t first = 0;
    inSteps(keys.size(), progress, [&](size_t begin, size_t end) {
        for (size_t key = begin; key < end; ++key) {
            if (keys[key].hash != keys[first].hash) first = key;
            if (key > first && equalsEarlier(first, key)) repeated[keys[key].face] = true;
        }
    });
    return repeated;
}

std::array<uint32_t, 3> fromSmallest(const uint32_t* corner) {
    const int first = corner[0] <= corner[1] && corner[0] <= corner[2] ? 0 : (corner[1] <= corner[2] ? 1 : 2);
    return {corner[first], corner[(first + 1) % 3], corner[(first + 2) % 3]};
}

/// Marks the triangles that are equal to an earlier one. They are bucketed by their smallest vertex: equal ones share a bucket,
/// and most buckets hold two or three.
std::vector<bool> repeatedTriangles(std::span<const uint32_t> triangles, size_t vertices, const Progress& progress) {
    const size_t count = triangles.size() / 3;
    // While the buckets are filled, starts[v + 1] is the next free place of bucket v; afterwards it is its end.
    std::vector<uint32_t> starts(vertices + 2), faces(count);
    const auto smallest = [&](size_t face) {
        return std::min({triangles[3 * face], triangles[3 * face + 1], triangles[3 * face + 2]});
    };
    inSteps(count, progress, [&](size_t begin, size_t end) {
        for (size_t face = begin; face < end; ++face) ++starts[smallest(face) + size_t{2}];
    });
    for (size_t vertex = 2; vertex < starts.size(); ++vertex) starts[vertex] += starts[vertex - 1];
    inSteps(count, progress, [&](size_t begin, size_t end) {
        for (size_t face = begin; face < end; ++face) faces[starts[smallest(face) + size_t{1}]++] = uint32_t(face);
    });
    std::vector<bool> repeated(count);
    std::vector<std::array<uint32_t, 3>> bucket;  // the other two vertices, in the triangle's order, and the triangle's number
    inSteps(vertices, progress, [&](size_t begin, size_t end) {
        for (size_t vertex = begin; vertex < end; ++vertex) {
            if (starts[vertex + 1] - starts[vertex] < 2) continue;
            bucket.clear();
            for (uint32_t place = starts[vertex]; place < starts[vertex + 1]; ++place) {
                const std::array<uint32_t, 3> corners = fromSmallest(triangles.data() + size_t{3} * faces[place]);
                bucket.push_back({corners[1], corners[2], faces[place]});
            }
            sortInSteps(std::span(bucket), progress);
            for (size_t i = 1; i < bucket.size(); ++i)
                if (bucket[i][0] == bucket[i - 1][0] && bucket[i][1] == bucket[i - 1][1]) repeated[bucket[i][2]] = true;
        }
    });
    return repeated;
}

void dropDuplicateTriangles(RawMesh& raw, LoadReport& report, const Progress& progress) {
    const std::vector<bool> repeated = repeatedTriangles(raw.triangles, raw.vertexCount(), progress);
    size_t kept = 0;
    inSteps(repeated.size(), progress, [&](size_t begin, size_t end) {
        for (size_t face = begin; face < end; ++face) {
            if (repeated[face])
                ++report.duplicateFaces;
            else if (kept++ != face)
                std::copy_n(raw.triangles.data() + 3 * face, 3, raw.triangles.data() + 3 * (kept - 1));
        }
    });
    raw.triangles.resize(3 * kept);
}

/// Rotates every polygon to begin with its smallest vertex (its surface stays the same), then compares.
void dropDuplicatePolygons(RawMesh& raw, LoadReport& report, const Progress& progress) {
    filterPolygons(raw, progress, [](std::vector<uint32_t>& corners) {
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        return true;
    });
    const auto corners = [&](size_t face) {
        const size_t begin = face > 0 ? raw.polygonEnds[face - 1] : 0;
        return std::span<const uint32_t>(raw.polygonCorners).subspan(begin, raw.polygonEnds[face] - begin);
    };
    std::vector<FaceKey> keys(raw.polygonEnds.size());
    for (size_t face = 0; face < keys.size(); ++face) keys[face] = {hashOf(corners(face)), face};
    const std::vector<bool> repeated = repeatedFaces(keys, progress, corners);
    size_t face = 0;
    filterPolygons(raw, progress, [&](const std::vector<uint32_t>&) {
        const bool drop = repeated[face++];
        report.duplicateFaces += drop ? 1 : 0;
        return !drop;
    });
}

template <typename Position>
void dropUnusable(RawMesh& raw, std::span<const Position> positions, LoadReport& report, const Progress& progress) {
    VertexMarks marks = markedVertices(positions, progress);
    filterTriangles(positions, marks, raw.triangles, report, progress);
    filterPolygons(raw, progress, [&](std::vector<uint32_t>& corners) {
        const Fault fault = polygonFault(raw, marks, corners);
        count(fault, report);
        return fault == Fault::None;
    });
    if (raw.verticesCounted) return;
    report.nonFiniteVertices += static_cast<size_t>(std::ranges::count(marks.usable, uint8_t{0}));
    report.unreferencedVertices += static_cast<size_t>(std::ranges::count(marks.named, uint8_t{0}));
}

}  // namespace

size_t RawMesh::bytes() const {
    return wide.capacity() * sizeof(Vec3) + (narrow.capacity() + normals.capacity()) * sizeof(Vec3f) +
           (triangles.capacity() + polygonCorners.capacity()) * sizeof(uint32_t) + polygonEnds.capacity() * sizeof(size_t);
}

void RawMesh::addFace(std::span<const uint32_t> corners) {
    if (corners.size() == 3) {
        triangles.insert(triangles.end(), corners.begin(), corners.end());
    } else {
        polygonCorners.insert(polygonCorners.end(), corners.begin(), corners.end());
        polygonEnds.push_back(polygonCorners.size());
    }
}

void dropUnusableFaces(RawMesh& raw, LoadReport& report, const Progress& progress) {
    if (raw.wide.empty())
        dropUnusable(raw, std::span<const Vec3f>(raw.narrow), report, progress);
    else
        dropUnusable(raw, std::span<const Vec3>(raw.wide), report, progress);
}

void dropDuplicateFaces(RawMesh& raw, LoadReport& report, const Progress& progress) {
    if (raw.triangles.size() > 3) dropDuplicateTriangles(raw, report, progress);
    if (raw.polygonEnds.size() > 1) dropDuplicatePolygons(raw, report, progress);
}

size_t triangulatePolygons(RawMesh& raw, const Progress& progress) {
    size_t fans = 0;
    std::vector<Vec3> points;
    std::vector<uint32_t> cut;
    filterPolygons(raw, progress, [&](const std::vector<uint32_t>& corners) {
        points.clear();
        cut.clear();
        for (const uint32_t corner : corners) points.push_back(raw.position(corner));
        if (!triangulatePolygon(points, cut, progress)) ++fans;
        for (const uint32_t corner : cut) raw.triangles.push_back(corners[corner]);
        return false;
    });
    return fans;
}

}  // namespace cullscope
