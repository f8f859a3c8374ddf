#include "core/mesh/edges.h"

#include <algorithm>
#include <vector>

#include "core/mesh/steps.h"
#include "core/mesh/weld.h"

namespace cullscope {
namespace {

/// The edges, bucketed by their lower vertex: entry = upper vertex · 2 + (1 when a triangle traverses it from upper to lower).
struct EdgeBuckets {
    std::vector<size_t> starts;
    std::vector<uint32_t> entries;
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
            visit(a, b);
            visit(b, c);
            visit(c, a);
        }
    });
}

EdgeBuckets bucketed(std::span<const uint32_t> indices, const std::vector<uint32_t>& welded, const Progress& progress) {
    EdgeBuckets buckets;
    buckets.starts.assign(welded.size() + 2, 0);
    forEachEdge(indices, welded, progress, [&](uint32_t from, uint32_t to) { ++buckets.starts[std::min(from, to) + 2]; });
    for (size_t vertex = 2; vertex < buckets.starts.size(); ++vertex) buckets.starts[vertex] += buckets.starts[vertex - 1];
    // While the buckets are filled, starts[v + 1] is the next free place of bucket v; afterwards it is its end.
    buckets.entries.resize(buckets.starts.back());
    forEachEdge(indices, welded, progress, [&](uint32_t from, uint32_t to) {
        buckets.entries[buckets.starts[std::min(from, to) + 1]++] = 2 * std::max(from, to) + (from > to ? 1 : 0);
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
    EdgeBuckets buckets = bucketed(indices, welded, progress);
    EdgeCounts counts;
    inSteps(positions.size(), progress, [&](size_t begin, size_t end) {
        for (size_t vertex = begin; vertex < end; ++vertex) {
            const std::span<uint32_t> bucket(buckets.entries.data() + buckets.starts[vertex],
                                             buckets.starts[vertex + 1] - buckets.starts[vertex]);
            sortInSteps(bucket, progress);
            countBucket(bucket, counts);
        }
    });
    return counts;
}

}  // namespace cullscope
