// The promises of `spherical-horizon`, and its independence of the number of threads.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "tests/support/culler.h"
#include "tests/support/spherical_scenes.h"
#include "tests/support/spherical_views.h"

namespace cullscope::test::spherical_horizon_test {
namespace {

TEST(SphericalHorizon, resultDoesNotDependOnTheThreads) {
    const ScenePointer scene = sceneOf({bumpyMesh(3, 20'000, 0.4)});
    const View view = lookingAt({2, 3, 1.5}, Vec3(0.0), 50.0);
    const CullerPointer strategy = makeCuller("spherical-horizon");
    strategy->build(*scene);
    const Culled parallel = strategy->cull(view);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    strategy->build(*scene);
    const Culled serial = strategy->cull(view);
    EXPECT_EQ(serial.drawList.ranges, parallel.drawList.ranges);
    EXPECT_LT(serial.consideredTriangles, scene->triangleCount() * 3 / 4);
}

TEST(SphericalHorizon, promiseIsConservativeForStarShapedMeshesOnly) {
    const auto promiseOver = [](const MeshPointer& mesh) {
        const ScenePointer scene = sceneOf({mesh});
        const CullerPointer strategy = makeCuller("spherical-horizon");
        strategy->build(*scene);
        return strategy->promise();
    };
    EXPECT_EQ(promiseOver(sphereMesh(2'000)), Promise::Conservative);
    EXPECT_EQ(promiseOver(boxMesh({-1, -2, -3}, {1, 2, 3})), Promise::Conservative);
    EXPECT_EQ(promiseOver(bumpyMesh(5, 5'000, 0.2)), Promise::Conservative);
    EXPECT_EQ(promiseOver(torusMesh(2'000)), Promise::Approximate);
    EXPECT_EQ(promiseOver(bowlMesh(6'000)), Promise::Approximate);
    EXPECT_EQ(promiseOver(squareMesh(1, 0)), Promise::Approximate);
    // Two nested spheres: each direction intersects the surface twice.
    std::vector<Vec3f> positions;
    std::vector<uint32_t> indices;
    for (const float scale : {1.0f, 0.5f}) {
        const MeshPointer sphere = sphereMesh(500);
        const auto base = uint32_t(positions.size());
        for (const Vec3f& position : sphere->positions()) positions.push_back(scale * position);
        for (const uint32_t index : sphere->indices()) indices.push_back(base + index);
    }
    EXPECT_EQ(promiseOver(meshOf(positions, indices)), Promise::Approximate);
}

TEST(SphericalHorizon, promiseForInwardFrontsAloneIsApproximate) {
    // Its inner sides are the front faces: OpenGL culls the surface that the horizon would assume.
    const MeshPointer star = bumpyMesh(5, 5'000, 0.2);
    std::vector<uint32_t> turned(star->indices().begin(), star->indices().end());
    for (size_t i = 0; i < turned.size(); i += 3) std::swap(turned[i], turned[i + 1]);
    const ScenePointer scene = sceneOf({meshOf({star->positions().begin(), star->positions().end()}, turned)});
    for (const char* facing : {"front", "two-sided", "auto"}) {
        const CullerPointer strategy = strategyWith("spherical-horizon", {{"facing", facing}});
        strategy->build(*scene);
        EXPECT_EQ(strategy->promise(), std::string_view(facing) == "front" ? Promise::Approximate : Promise::Conservative)
            << facing;
    }
}

}  // namespace
}  // namespace cullscope::test::spherical_horizon_test
