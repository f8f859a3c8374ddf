#include "core/mesh/meshlets.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "core/mesh/vertex_cache.h"
#include "tests/support/lossless_scenes.h"

namespace cullscope::test::meshlets_test {
namespace {

/// Each triangle in one group, none empty and none too large.
void expectParts(const TriangleMesh& mesh, const Meshlets& meshlets, uint32_t most) {
    ASSERT_EQ(meshlets.triangles.size(), mesh.triangleCount());
    EXPECT_EQ(std::set(meshlets.triangles.begin(), meshlets.triangles.end()).size(), mesh.triangleCount());
    EXPECT_LT(*std::ranges::max_element(meshlets.triangles), mesh.triangleCount());
    for (size_t group = 0; group < meshlets.size(); ++group) {
        EXPECT_GE(meshlets.of(group).size(), 1u);
        EXPECT_LE(meshlets.of(group).size(), most);
    }
    EXPECT_EQ(meshlets.starts.front(), 0u);
    EXPECT_EQ(meshlets.starts.back(), mesh.triangleCount());
}

TEST(Meshlets, haveEachTriangleOnce) {
    for (const NamedMesh& each : losslessMeshes(false))
        for (const uint32_t most : {4u, 30u, 128u, 512u}) {
            SCOPED_TRACE(std::string(each.name) + ", " + std::to_string(most));
            expectParts(*each.mesh, cutIntoMeshlets(*each.mesh, most), most);
        }
}

TEST(Meshlets, areAlmostFull) {
    const MeshPointer mesh = sphereMesh(20'000);
    for (const uint32_t most : {32u, 128u}) EXPECT_LT(cutIntoMeshlets(*mesh, most).size(), 1.3 * 20'000 / most);
}

TEST(Meshlets, equalTrianglesAndThoseWithoutAreaAreKept) {
    // The same triangle three times, once named from another corner; one turned over; three that are points or lines.
    std::vector<Vec3f> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const MeshPointer mesh = meshOf(corners, {0, 1, 2, 0, 1, 2, 1, 2, 0, 0, 2, 1, 1, 1, 1, 0, 3, 3, 0, 3, 0, 1, 3, 2, 1, 3, 2});
    expectParts(*mesh, cutIntoMeshlets(*mesh, 4), 4);
}

TEST(Meshlets, cornersAtEqualPositionsHoldAGroupTogether) {
    // A mesh without shared vertices is cut as the same mesh with them, or nearly so.
    const MeshPointer sphere = sphereMesh(8'000);
    std::vector<Vec3f> corners;
    std::vector<uint32_t> indices;
    for (const uint32_t index : sphere->indices()) {
        indices.push_back(uint32_t(corners.size()));
        corners.push_back(sphere->positions()[index]);
    }
    const MeshPointer soup = meshOf(std::move(corners), std::move(indices));
    const Meshlets cut = cutIntoMeshlets(*soup, 128);
    expectParts(*soup, cut, 128);
    EXPECT_LT(cut.size(), 1.1 * double(cutIntoMeshlets(*sphere, 128).size()));
}

TEST(Meshlets, sizeOfTheMeshDoesNotMatter) {
    const MeshPointer star = starMesh(3, 6'000);
    const size_t groups = cutIntoMeshlets(*star, 128).size();
    for (const double scale : {1e-18, 1e-6, 1e6, 1e18}) {
        const MeshPointer scaled = changed(
            *star, [scale](const Vec3& p) { return scale * p; }, kNone);
        const Meshlets cut = cutIntoMeshlets(*scaled, 128);
        expectParts(*scaled, cut, 128);
        EXPECT_NEAR(double(cut.size()), double(groups), 0.1 * double(groups)) << scale;
    }
}

TEST(Meshlets, trianglesOfAGroupAreInVertexCacheOrder) {
    const MeshPointer mesh = starMesh(8, 20'000);
    const Meshlets cut = cutIntoMeshlets(*mesh, 128);
    std::vector<uint32_t> indices;
    for (const uint32_t triangle : cut.triangles)
        for (size_t c = 0; c < 3; ++c) indices.push_back(mesh->indices()[3 * size_t(triangle) + c]);
    EXPECT_LT(verticesPerTriangle(indices, mesh->vertexCount()), 0.85);
}

TEST(Meshlets, stopWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)cutIntoMeshlets(*sphereMesh(2'000), 128, Progress{{}, stop.get_token()}), Error);
}

}  // namespace
}  // namespace cullscope::test::meshlets_test
