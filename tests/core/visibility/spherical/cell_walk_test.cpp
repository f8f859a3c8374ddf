#include "core/mesh/parametric.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "tests/support/culler.h"
#include "tests/support/test_scenes.h"

// The walk through the 20 × 20 field at 650 × 650: the frustum culls 79 % of the objects on average, as in Cho et al.

namespace cullscope::test::cell_walk_test {
namespace {

double culledShare(const Scene& scene) {
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(scene);
    const CameraPath path = cameraPath("walk:40", scene);
    double culled = 0.0;
    for (size_t pose = 0; pose < path.poses.size(); ++pose) {
        const Culled frame = frustum->cull(View(path.camera(pose), {650, 650}));
        culled += 1.0 - double(frame.consideredTriangles) / double(scene.triangleCount());
    }
    return culled / double(path.poses.size());
}

/// The generator `field`, of a mesh around the origin whose farthest vertex is at distance 1.
ScenePointer fieldOf(const MeshPointer& mesh) {
    std::vector<Mat4> places;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) places.push_back(translation({(i - 9.5) * 2.5, 0, (j - 9.5) * 2.5}));
    return copiesOf(mesh, places);
}

TEST(Walk, frustumCullsThePapersShareOfSpheres) { EXPECT_NEAR(culledShare(*fieldOf(sphereMesh(320))), 0.79, 0.03); }

TEST(Walk, frustumCullsThePapersShareOfBunnies) {
    ASSERT_TRUE(findBunny({}).has_value()) << "glmark2-data is in packaging/packages.txt and not installed";
    EXPECT_NEAR(culledShare(*openScene("field:mesh=bunny,n=20,spacing=2.5").scene), 0.79, 0.03);
}

TEST(Walk, walkStaysInTheField) {
    const ScenePointer scene = fieldOf(sphereMesh(80));
    const CameraPath path = cameraPath("walk:40", *scene);
    for (const CameraPath::Pose& pose : path.poses) {
        EXPECT_NEAR(pose.eye.y, 0.0, 1e-9);
        EXPECT_TRUE(glm::all(glm::lessThan(glm::abs(pose.eye), scene->bounds().halfExtent() + 1e-9)));
    }
}

}  // namespace
}  // namespace cullscope::test::cell_walk_test
