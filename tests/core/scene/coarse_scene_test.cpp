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

TEST(CoarseScene, endsOnAStopRequest) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW((void)coarseScene(*openScene("torus:triangles=500").scene, 100, Progress{nullptr, stop.get_token()}), Error);
}

}  // namespace
}  // namespace cullscope::coarse_scene_test
