#include "core/mesh/edges.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "core/mesh/steps.h"
#include "core/mesh/weld.h"

namespace cullscope {
namespace {

/// The edges, bucketed by their lower vertex.
template <typename Entry>
struct EdgeBuckets {
    std::vector<size_t> starts;
    std::vector<Entry> entries;

    [[nodiscard]] std::span<Entry> of(size_t vertex) {
        return {entries.data() + starts[vertex], starts[vertex + 1] - starts[vertex]};
    }
};

/// An edge of a triangle by its upper vertex.
struct EdgeOfTriangle {
    uint32_t upper, triangle;
    auto operator<=>(const EdgeOfTriangle&) const = default;
};

template <typename Visit>
void forEachEdge(std::span<const uint32_t> indices, const std::vector<uint32_t>& welded, const Progress& progress,
                 Visit&& visit) {
    inSteps(indices.size() / 3, progress, [&](size_t begin, size_t end) {
        for (size_t triangle = begin; triangle < end; ++triangle) {
            const uint32_t a = welded[indices[3 * triangle]];
            const uint32_t b = welded[indices[3 * triangle + 1]];
            const uint32_t c = welded[indices[3 * triangle + 2]];
            if (a == b || b == c || c == a) continue;
            visit(a, b, triangle);
            visit(b, c, triangle);
            visit(c, a, triangle);
        }
    });
}

/// `make(from, to, triangle)`: the entry of an edge as a triangle traverses it.
template <typename Entry, typename Make>
EdgeBuckets<Entry> bucketed(std::span<const uint32_t> indices, const std::vector<uint32_t>& welded, const Progress& progress,
                            Make&& make) {
    EdgeBuckets<Entry> buckets;
    buckets.starts.assign(welded.size() + 2, 0);
    forEachEdge(indices, welded, progress,
                [&](uint32_t from, uint32_t to, size_t /*triangle*/) { ++buckets.starts[std::min(from, to) + 2]; });
    for (size_t vertex = 2; vertex < buckets.starts.size(); ++vertex) buckets.starts[vertex] += buckets.starts[vertex - 1];
    // While the buckets are filled, starts[v + 1] is the next free place of bucket v; afterwards it is its end.
    buckets.entries.resize(buckets.starts.back());
    forEachEdge(indices, welded, progress, [&](uint32_t from, uint32_t to, size_t triangle) {
        buckets.entries[buckets.starts[std::min(from, to) + 1]++] = make(from, to, triangle);
    });
    return buckets;
}

void countBucket(std::span<const uint32_t> sorted, EdgeCounts& counts) {
    for (size_t begin = 0; begin < sorted.size();) {
        size_t end = begin;
        size_t backward = 0;
        for (; end < sorted.size() && sorted[end] / 2 == sorted[begin] / 2; ++end) backward += sorted[end] & 1;
        const size_t triangles = end - begin;
        if (triangles == 1) ++counts.boundary;
        if (triangles > 2) ++counts.nonManifold;
        if (triangles == 2 && backward != 1) ++counts.inconsistent;
        begin = end;
    }
}

}  // namespace

EdgeCounts countEdges(std::span<const Vec3f> positions, std::span<const uint32_t> indices, const Progress& progress) {
    const std::vector<uint32_t> welded = firstOfEqualPositions(positions, progress);
    // An entry: the upper vertex · 2, and 1 where a triangle traverses the edge from it to the lower one.
    auto buckets = bucketed<uint32_t>(indices, welded, progress, [](uint32_t from, uint32_t to, size_t /*triangle*/) {
        return 2 * std::max(from, to) + (from > to ? 1 : 0);
    });
    EdgeCounts counts;
    inSteps(positions.size(), progress, [&](size_t begin, size_t end) {
        for (size_t vertex = begin; vertex < end; ++vertex) {
            sortInSteps(buckets.of(vertex), progress);
            countBucket(buckets.of(vertex), counts);
        }
    });
    return counts;
}

std::vector<uint32_t> edgeComponents(std::span<const Vec3f> positions, std::span<const uint32_t> indices,
                                     const Progress& progress) {
    const std::vector<uint32_t> welded = firstOfEqualPositions(positions, progress);
    auto buckets = bucketed<EdgeOfTriangle>(indices, welded, progress, [](uint32_t from, uint32_t to, size_t triangle) {
        return EdgeOfTriangle{std::max(from, to), static_cast<uint32_t>(triangle)};
    });
    std::vector<uint32_t> component(indices.size() / 3);
    std::iota(component.begin(), component.end(), 0U);
    const auto first = [&](uint32_t triangle) {
        while (component[triangle] != triangle) triangle = component[triangle] = component[component[triangle]];
        return triangle;
    };
    inSteps(positions.size(), progress, [&](size_t begin, size_t end) {
        for (size_t vertex = begin; vertex < end; ++vertex) {
            const std::span<EdgeOfTriangle> bucket = buckets.of(vertex);
            sortInSteps(bucket, progress);
            for (size_t i = 1; i < bucket.size(); ++i) {
                if (bucket[i].upper != bucket[i - 1].upper) continue;
                const auto [lower, higher] = std::minmax({first(bucket[i - 1].triangle), first(bucket[i].triangle)});
                component[higher] = lower;
            }
        }
    });
    for (uint32_t triangle = 0; triangle < component.size(); ++triangle) component[triangle] = first(triangle);
    return component;
}

}  // namespace cullscope
