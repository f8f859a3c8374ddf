#include "core/mesh/vertex_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "tests/support/long_mode.h"

namespace cullscope::test::vertex_cache_test {
namespace {

using Corners = std::array<uint32_t, 3>;

/// Sorted triangles; the corners of each begin with the smallest and keep their orientation.
std::vector<Corners> trianglesOf(std::span<const uint32_t> indices) {
    std::vector<Corners> triangles;
    for (size_t i = 0; i < indices.size(); i += 3) {
        Corners corners{indices[i], indices[i + 1], indices[i + 2]};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

/// The triangles in a random order.
std::vector<uint32_t> shuffled(std::span<const uint32_t> indices) {
    std::vector<uint32_t> result(indices.begin(), indices.end());
    Random random(5);
    for (size_t last = result.size() / 3 - 1; last > 0; --last)
        std::swap_ranges(result.begin() + long(3 * last), result.begin() + long(3 * last + 3),
                         result.begin() + long(3 * (random.bits() % (last + 1))));
    return result;
}

TEST(VertexCache, orderKeepsEveryTriangleAndIsBetter) {
    const MeshPointer mesh = sphereMesh(20'000);
    const std::vector<uint32_t> bad = shuffled(mesh->indices());
    const std::vector<uint32_t> good = inVertexCacheOrder(bad, mesh->vertexCount());
    EXPECT_EQ(trianglesOf(good), trianglesOf(bad));
    EXPECT_GT(verticesPerTriangle(bad, mesh->vertexCount()), 2.5);
    EXPECT_LT(verticesPerTriangle(good, mesh->vertexCount()), 0.9);
}

TEST(VertexCache, goodOrderIsNotMadeWorse) {
    const MeshPointer mesh = sphereMesh(20'000);
    const std::vector<uint32_t> good = inVertexCacheOrder(mesh->indices(), mesh->vertexCount());
    EXPECT_LE(verticesPerTriangle(good, mesh->vertexCount()), verticesPerTriangle(mesh->indices(), mesh->vertexCount()));
    EXPECT_LE(verticesPerTriangle(inVertexCacheOrder(good, mesh->vertexCount()), mesh->vertexCount()),
              verticesPerTriangle(good, mesh->vertexCount()));
}

TEST(VertexCache, fanOfAMillionTrianglesIsOrderedInTime) {
    // Forsyth's algorithm recomputes the scores of all triangles at a vertex for each of them.
    const uint32_t triangles = fewSamples() ? 100'000 : 1'000'000;
    std::vector<uint32_t> fan;
    for (uint32_t i = 1; i <= triangles; ++i) fan.insert(fan.end(), {0, i, i + 1});
    const std::vector<uint32_t> bad = shuffled(fan);
    const std::vector<uint32_t> good = inVertexCacheOrder(bad, triangles + 2);
    EXPECT_EQ(trianglesOf(good), trianglesOf(bad));
    EXPECT_LE(verticesPerTriangle(good, triangles + 2), verticesPerTriangle(bad, triangles + 2));
    EXPECT_EQ(inVertexCacheOrder(fan, triangles + 2), fan);
}

TEST(VertexCache, emptyOrderStaysEmpty) {
    EXPECT_TRUE(inVertexCacheOrder({}, 0).empty());
    EXPECT_EQ(verticesPerTriangle({}, 0), 0.0);
}

}  // namespace
}  // namespace cullscope::test::vertex_cache_test
