// A coarse scene has the same objects in the same places, with few triangles.
#include "core/scene/coarse_scene.h"

#include <gtest/gtest.h>

#include "core/base/error.h"
#include "core/scene/scene_source.h"

namespace cullscope::coarse_scene_test {
namespace {

TEST(CoarseScene, hasTheSameObjectsInTheSamePlacesWithFewTriangles) {
    for (const char* text : {"field:mesh=star:seed=3,triangles=20000,n=3", "torus:triangles=50000", "plant:pipelines=3",
                             "split:mesh=star:seed=7,triangles=20000,by=clusters,triangles=500"}) {
        const ScenePointer scene = openScene(text).scene;
        const ScenePointer coarse = coarseScene(*scene, scene->triangleCount() / 20);
        ASSERT_EQ(coarse->instances().size(), scene->instances().size()) << text;
        // Small meshes keep a few triangles.
        EXPECT_LT(coarse->triangleCount(), scene->triangleCount() / 4 + 50 * scene->instances().size()) << text;
        EXPECT_GT(coarse->triangleCount(), 0u) << text;
        for (size_t i = 0; i < scene->instances().size(); ++i) {
            EXPECT_EQ(coarse->meshOf(i).triangleCount() == 0, scene->meshOf(i).triangleCount() == 0) << text << ", object " << i;
            const Box3 &few = coarse->instanceBox(i), &all = scene->instanceBox(i);
            const double side = glm::length(all.max - all.min), tiny = 1e-6 * (side + glm::length(all.max));
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(few.min[axis], all.min[axis] - tiny) << text << ", object " << i;
                EXPECT_LE(few.max[axis], all.max[axis] + tiny) << text << ", object " << i;
            }
            if (scene->meshOf(i).triangleCount() > 400)
                EXPECT_GT(glm::length(few.max - few.min), 0.4 * side) << text << ", object " << i;
        }
    }
}

TEST(CoarseScene, aSceneThatIsSmallEnoughKeepsItsMeshes) {
    const ScenePointer scene = openScene("torus:triangles=500").scene;
    EXPECT_EQ(coarseScene(*scene, 1000)->meshes(), scene->meshes());
}

TEST(CoarseScene, isMergedIntoOneMeshWithTheSameTrianglesInTheSameOrder) {
    for (const char* text : {"field:mesh=star:seed=3,triangles=2000,n=3", "plant:pipelines=3"}) {
        const ScenePointer scene = openScene(text).scene, merged = mergedScene(*scene);
        ASSERT_TRUE(merged);
        ASSERT_EQ(merged->instances().size(), 1u);
        ASSERT_EQ(merged->triangleCount(), scene->triangleCount());
        const TriangleMesh& all = merged->meshOf(0);
        const double tiny = 1e-6 * glm::length(scene->bounds().max - scene->bounds().min);
        for (size_t i = 0; i < scene->instances().size(); ++i)
            for (size_t corner = 0; corner < scene->meshOf(i).indices().size(); ++corner) {
                const Vec3 is = all.position(all.indices()[3 * scene->firstTriangle(i) + corner]);
                const Vec3 was = Vec3(scene->instances()[i].worldFromMesh *
                                      Vec4(scene->meshOf(i).position(scene->meshOf(i).indices()[corner]), 1.0));
                ASSERT_LT(glm::length(is - was), tiny) << text << ", object " << i << ", corner " << corner;
            }
    }
}

TEST(CoarseScene, endsOnAStopRequest) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)coarseScene(*openScene("torus:triangles=500").scene, 100, Progress{nullptr, stop.get_token()}), Error);
}

}  // namespace
}  // namespace cullscope::coarse_scene_test
