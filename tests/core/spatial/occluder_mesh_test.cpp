// What stands for a mesh in occlusion culling: occluders are triangles of the mesh, the largest first; the boxes of its parts
// hold all of it.

#include "core/spatial/occluder_mesh.h"

#include <cmath>
#include <set>

#include "core/geometry/random.h"
#include "core/mesh/parametric.h"
#include "core/spatial/part_boxes.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::occluder_mesh_test {
namespace {

TEST(OccluderMesh, hasTheLargestTrianglesOfTheMeshAndNoOthers) {
    const MeshPointer mesh = starMesh(3, 500);
    for (const size_t most : {size_t{1}, size_t{37}, size_t{5000}}) {
        const OccluderMesh occluder = occluderMesh(*mesh, most);
        ASSERT_EQ(occluder.count(), std::min(most, mesh->triangleCount()));
        std::set<uint32_t> triangles;
        double before = INFINITY, sum = 0.0;
        for (size_t i = 0; i < occluder.count(); ++i) {
            Vec3 corners[3];
            for (size_t c = 0; c < 3; ++c) {
                const uint32_t own = occluder.indices[3 * i + c];
                EXPECT_LT(own, occluder.vertices[i]) << "the first triangles use the first positions";
                EXPECT_EQ(occluder.positions[own], mesh->positions()[mesh->indices()[3 * size_t(occluder.triangles[i]) + c]]);
                corners[c] = Vec3(occluder.positions[own]);
            }
            const double area = 0.5 * glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
            EXPECT_LE(area, before * (1 + 1e-6));
            before = area;
            sum += area;
            EXPECT_NEAR(occluder.means[i], sum / double(i + 1), 1e-6 * sum);
            triangles.insert(occluder.triangles[i]);
        }
        EXPECT_EQ(triangles.size(), occluder.count()) << "each once";
    }
}

TEST(OccluderMesh, countsTrianglesByTheirMeanArea) {
    // Areas 8, 2 and 0.5, and one without an area.
    const MeshPointer mesh = meshOf({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {0, 1, 0}},
                                    {0, 5, 6, 0, 1, 2, 0, 5, 1, 0, 3, 4});
    const OccluderMesh occluder = occluderMesh(*mesh);
    EXPECT_EQ(occluder.triangles, (std::vector<uint32_t>{1, 3, 0}));
    EXPECT_EQ(occluder.countFrom(8.1), 0u);
    EXPECT_EQ(occluder.countFrom(8.0), 1u);
    EXPECT_EQ(occluder.countFrom(5.0), 2u);
    EXPECT_EQ(occluder.countFrom(3.5), 3u);
    EXPECT_EQ(occluderMesh(*mesh, std::vector<uint32_t>{0, 2}).triangles, std::vector<uint32_t>{0});
}

TEST(PartBoxes, holdEveryVertexAndLessThanTheWholeBox) {
    Random random(5);
    std::vector<MeshPointer> meshes{sphereMesh(320), starMesh(2, 2000), boxMesh(Vec3f(-1), Vec3f(1)), squareMesh(1, 0)};
    std::vector<Mat4> places;
    for (size_t i = 0; i < meshes.size(); ++i) {
        Mat4 place = translation(10.0 * random.direction());
        for (int axis = 0; axis < 3; ++axis) place[axis] = Vec4(random.direction() * random.between(0.2, 3.0), 0.0);
        places.push_back(place);
    }
    const ScenePointer scene = sceneOf(meshes, places);
    const PartBoxes boxes(*scene);
    EXPECT_TRUE(boxes.of(2).empty()) << "too few triangles";
    EXPECT_TRUE(boxes.of(3).empty());
    for (const uint32_t i : {0u, 1u}) {
        ASSERT_EQ(boxes.of(i).size(), PartBoxes::kMost);
        const TriangleMesh& mesh = scene->meshOf(i);
        double volume = 0.0;
        for (const Box3& box : boxes.of(i)) volume += 8 * box.halfExtent().x * box.halfExtent().y * box.halfExtent().z;
        const Vec3 whole = scene->instanceBox(i).halfExtent();
        EXPECT_LT(volume, 8 * whole.x * whole.y * whole.z);
        for (size_t triangle = 0; triangle < mesh.triangleCount(); ++triangle) {
            const bool within = std::ranges::any_of(boxes.of(i), [&](const Box3& box) {
                for (size_t c = 0; c < 3; ++c) {
                    const Vec3 corner(places[i] * Vec4(mesh.position(mesh.indices()[3 * triangle + c]), 1.0));
                    for (int axis = 0; axis < 3; ++axis)
                        if (corner[axis] < box.min[axis] || corner[axis] > box.max[axis]) return false;
                }
                return true;
            });
            ASSERT_TRUE(within) << "triangle " << triangle << " of instance " << i;
        }
    }
}

}  // namespace
}  // namespace cullscope::test::occluder_mesh_test
