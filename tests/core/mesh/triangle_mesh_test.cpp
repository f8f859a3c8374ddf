#include "core/mesh/triangle_mesh.h"

#include <gtest/gtest.h>

#include "core/mesh/normals.h"
#include "core/mesh/parametric.h"
#include "core/mesh/steps.h"

namespace cullscope::test::triangle_mesh_test {
namespace {

TriangleMesh::Data cube() {
    TriangleMesh::Data data;
    for (int i = 0; i < 8; ++i) data.positions.push_back(Vec3f(i & 1, i >> 1 & 1, i >> 2 & 1));
    data.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return data;
}

TEST(TriangleMeshTopology, outwardCubeNeedsOnlyItsFrontFaces) {
    const TriangleMesh mesh(cube());
    EXPECT_TRUE(mesh.topology().closed);
    EXPECT_TRUE(mesh.topology().frontFacesSuffice());
}

TEST(TriangleMeshTopology, inwardCubeIsClosedButNotOutward) {
    TriangleMesh::Data data = cube();
    for (size_t i = 0; i < data.indices.size(); i += 3) std::swap(data.indices[i], data.indices[i + 1]);
    const TriangleMesh mesh(std::move(data));
    EXPECT_TRUE(mesh.topology().closed);
    EXPECT_FALSE(mesh.topology().frontFacesSuffice());
}

TEST(TriangleMeshTopology, oneTurnedTriangleMakesThreeInconsistentEdges) {
    TriangleMesh::Data data = cube();
    std::swap(data.indices[0], data.indices[1]);
    const TriangleMesh mesh(std::move(data));
    EXPECT_EQ(mesh.topology().inconsistentEdges, 3U);
    EXPECT_FALSE(mesh.topology().consistentlyOriented);
}

TEST(TriangleMeshTopology, splitVerticesAtEqualPositionsCountAsOne) {
    const TriangleMesh::Data shared = cube();
    TriangleMesh::Data data;
    for (const uint32_t index : shared.indices) {
        data.indices.push_back(static_cast<uint32_t>(data.positions.size()));
        // -0 and 0 are the same position.
        data.positions.push_back(shared.positions[index] * (data.positions.size() % 2 == 0 ? 1.0F : 1.0F) + Vec3f(-0.0F));
    }
    EXPECT_TRUE(TriangleMesh(std::move(data)).topology().frontFacesSuffice());
}

TEST(TriangleMeshTopology, missingAndExtraTrianglesAreCountedByTheirEdges) {
    TriangleMesh::Data open = cube();
    open.indices.resize(33);
    EXPECT_EQ(TriangleMesh(std::move(open)).topology().boundaryEdges, 3U);
    TriangleMesh::Data extra = cube();
    extra.positions.push_back(Vec3f(5, 5, 5));
    extra.indices.insert(extra.indices.end(), {0, 1, 8});
    const TriangleMesh mesh(std::move(extra));
    EXPECT_EQ(mesh.topology().nonManifoldEdges, 1U);
    EXPECT_EQ(mesh.topology().boundaryEdges, 2U);
}

TEST(TriangleMeshBounds, onlyUsedVerticesCount) {
    TriangleMesh::Data data;
    data.positions = {Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(100)};
    data.indices = {0, 1, 2};
    const TriangleMesh mesh(std::move(data));
    EXPECT_EQ(mesh.localBounds().max, Vec3(1, 1, 0));
}

TEST(Normals, areWeightedByAreaAndFiniteEvenWithoutUse) {
    const std::array positions{Vec3f(0), Vec3f(1, 0, 0), Vec3f(0, 1, 0), Vec3f(0, 0, 10), Vec3f(7)};
    const std::array<uint32_t, 9> indices{0, 1, 2, 0, 3, 1, 1, 1, 1};
    const std::vector<Vec3f> normals = areaWeightedNormals(positions, indices);
    EXPECT_LE(glm::length(normals[0] - glm::normalize(Vec3f(0, 10, 1))), 1e-6F);
    EXPECT_EQ(normals[4], Vec3f(0, 0, 1));
}

TEST(Normals, surviveTheSmallestAndLargestScales) {
    for (const float scale : {1e-18F, 1.0F, 1e18F}) {
        const std::array positions{Vec3f(0), Vec3f(scale, 0, 0), Vec3f(0, scale, 0)};
        EXPECT_EQ(areaWeightedNormals(positions, std::array<uint32_t, 3>{0, 1, 2})[1], Vec3f(0, 0, 1));
    }
}

TEST(Normals, ofALargeSphereAreItsDirections) {
    const MeshPointer sphere = sphereMesh(500'000);  // in parallel
    const std::vector<Vec3f> normals = areaWeightedNormals(sphere->positions(), sphere->indices());
    for (size_t i = 0; i < normals.size(); i += 97)
        EXPECT_LE(glm::length(normals[i] - glm::normalize(sphere->positions()[i])), 0.01F);
}

TEST(SortInSteps, sortsMoreThanOneBlock) {
    std::vector<uint32_t> values(3'000'001);
    uint32_t state = 1;
    for (uint32_t& value : values) value = state = state * 1664525U + 1013904223U;
    // The sums tell, in linear time, whether the sorted values are the same ones.
    const auto sums = [&] {
        uint64_t sum = 0, squares = 0;
        for (const uint64_t value : values) sum += value, squares += value * value;
        return std::pair(sum, squares);
    };
    const std::pair before = sums();
    sortInSteps(std::span(values), {});
    EXPECT_TRUE(std::ranges::is_sorted(values));
    EXPECT_EQ(sums(), before);
}

}  // namespace
}  // namespace cullscope::test::triangle_mesh_test
