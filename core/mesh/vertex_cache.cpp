#include "core/mesh/vertex_cache.h"

#include <meshoptimizer.h>

namespace cullscope {
namespace {

constexpr unsigned kCacheEntries = 16;

}  // namespace

double verticesPerTriangle(std::span<const uint32_t> indices, size_t vertices) {
    return double(meshopt_analyzeVertexCache(indices.data(), indices.size(), vertices, kCacheEntries, 0, 0).acmr);
}

std::vector<uint32_t> inVertexCacheOrder(std::span<const uint32_t> indices, size_t vertices) {
    std::vector<uint32_t> ordered(indices.size());
    meshopt_optimizeVertexCache(ordered.data(), indices.data(), indices.size(), vertices);
    if (verticesPerTriangle(ordered, vertices) >= verticesPerTriangle(indices, vertices))
        ordered.assign(indices.begin(), indices.end());
    return ordered;
}

}  // namespace cullscope
