#include "core/mesh/vertex_cache.h"

#include <meshoptimizer.h>

namespace cullscope {
namespace {

constexpr unsigned kCacheEntries = 16;
/// Above this number of visited triangles for each one placed, Forsyth's algorithm is too slow; a closed regular mesh has 18.
constexpr double kMostLooks = 100.0;

/// How many triangles Forsyth's algorithm visits for each one that it places: whenever a vertex is used, the scores of all
/// triangles at it are recomputed.
double looksPerTriangle(std::span<const uint32_t> indices, size_t vertices) {
    std::vector<double> trianglesAt(vertices, 0.0);
    for (const uint32_t vertex : indices) ++trianglesAt[vertex];
    double looks = 0.0;
    for (const double count : trianglesAt) looks += count * count;
    return looks / (double(indices.size()) / 3.0);
}

}  // namespace

double verticesPerTriangle(std::span<const uint32_t> indices, size_t vertices) {
    return double(meshopt_analyzeVertexCache(indices.data(), indices.size(), vertices, kCacheEntries, 0, 0).acmr);
}

std::vector<uint32_t> inVertexCacheOrder(std::span<const uint32_t> indices, size_t vertices) {
    std::vector<uint32_t> ordered(indices.size());
    if (looksPerTriangle(indices, vertices) <= kMostLooks)
        meshopt_optimizeVertexCache(ordered.data(), indices.data(), indices.size(), vertices);
    else
        meshopt_optimizeVertexCacheFifo(ordered.data(), indices.data(), indices.size(), vertices, kCacheEntries);
    if (verticesPerTriangle(ordered, vertices) >= verticesPerTriangle(indices, vertices))
        ordered.assign(indices.begin(), indices.end());
    return ordered;
}

}  // namespace cullscope
