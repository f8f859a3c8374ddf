#include "core/scene/layers_scene.h"

#include <gmock/gmock.h>

#include "core/base/error.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"

namespace cullscope::test::layers_scene_test {
namespace {

ScenePointer layers(const std::string& specification) { return openScene(specification).scene; }

TEST(Layers, areSoManyObjectsOfSoManyTrianglesFromFrontToBack) {
    const ScenePointer scene = layers("layers:count=32,triangles=1e4");
    ASSERT_EQ(scene->instances().size(), 32u);
    EXPECT_EQ(layers("layers")->triangleCount(), scene->triangleCount()) << "the defaults";
    for (size_t i = 0; i < 32; ++i) {
        EXPECT_NEAR(double(scene->meshOf(i).triangleCount()), 1e4, 50);
        EXPECT_NEAR(scene->instanceBox(i).halfExtent().z, 0.0, 1e-5);
        if (i > 0) {
            EXPECT_LT(scene->instanceBox(i).centre().z, scene->instanceBox(i - 1).centre().z);
        }
    }
}

TEST(Layers, mayBeOneAndHaveTwoTriangles) {
    EXPECT_EQ(layers("layers:count=1,triangles=1")->triangleCount(), 2u);
    EXPECT_EQ(layers("layers:count=3,triangles=2")->triangleCount(), 6u);
    EXPECT_NEAR(layers("layers:count=1,triangles=2")->bounds().centre().z, 0.0, 1e-6);
    EXPECT_THROW((void)layers("layers:count=0"), Error);
    EXPECT_THROW((void)layers("layers:depth=3"), Error);
}

TEST(Layers, faceTheEyeBeforeTheirFront) {
    const ScenePointer scene = layers("layers:count=2,triangles=20");
    const TriangleMesh& mesh = scene->meshOf(0);
    for (size_t i = 0; i < mesh.indices().size(); i += 3) {
        const Vec3 a = mesh.position(mesh.indices()[i]), b = mesh.position(mesh.indices()[i + 1]),
                   c = mesh.position(mesh.indices()[i + 2]);
        EXPECT_GT(glm::cross(b - a, c - a).z, 0.0);
    }
}

TEST(Layers, everyOneFillsThePictureOfAnyViewFromTheFront) {
    for (const char* specification :
         {"layers:count=1", "layers:count=2", "layers:count=32,triangles=100", "layers:count=3,triangles=50,waves=0.1"}) {
        const ScenePointer scene = layers(specification);
        const CameraPath path = cameraPath("front:7", *scene);
        ASSERT_EQ(path.poses.size(), 7u);
        for (size_t pose = 0; pose < path.poses.size(); ++pose)
            for (const Viewport size : {Viewport{640, 480}, Viewport{160, 90}, Viewport{100, 100}, Viewport{1, 1}}) {
                const View view(path.camera(pose), size);
                for (size_t i = 0; i < scene->instances().size(); ++i) {
                    const Box3& box = scene->instanceBox(i);
                    for (const Vec2 corner :
                         {Vec2(0, 0), Vec2(size.width, 0), Vec2(0, size.height), Vec2(size.width, size.height)}) {
                        const Vec3 ray = view.direction(corner.x, corner.y);
                        const Vec3 at = view.eye() + ray * ((box.centre().z - view.eye().z) / ray.z);
                        EXPECT_TRUE(std::abs(at.x) < box.max.x && std::abs(at.y) < box.max.y)
                            << specification << ", layer " << i << ", pose " << pose;
                    }
                    const double ahead = view.eye().z - box.centre().z;
                    EXPECT_TRUE(ahead > path.nearDistance && ahead < path.farDistance);
                }
            }
    }
}

TEST(Layers, wavyOnesHavePlanesOfTheirOwnAndNeverMeet) {
    const ScenePointer scene = layers("layers:count=32,triangles=500,waves=0.1");
    EXPECT_GT(scene->instanceBox(0).halfExtent().z, 0.08);
    const TriangleMesh& mesh = scene->meshOf(0);
    const auto place = [&](size_t instance, size_t vertex) {
        return Vec3(scene->instances()[instance].worldFromMesh * Vec4(mesh.position(vertex), 1.0));
    };
    for (size_t v = 0; v < mesh.vertexCount(); ++v) EXPECT_GT(place(0, v).z, place(1, v).z);
    EXPECT_THROW((void)layers("layers:waves=-1"), Error);
}

TEST(Layers, walkLeadsAlongZ) {
    const CameraPath path = cameraPath("walk:4", *layers("layers"));
    EXPECT_LT(path.poses.back().eye.z, path.poses.front().eye.z - 1.0);
}

}  // namespace
}  // namespace cullscope::test::layers_scene_test
