#include "core/scene/components.h"

#include <gmock/gmock.h>

#include "core/mesh/primitive/tessellate.h"
#include "core/scene/camera_moves.h"
#include "core/scene/camera_path.h"
#include "core/scene/hidden.h"
#include "core/scene/split_scene.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::components_test {
namespace {

/// Two meshes, the first of two solids and with two instances, and a line that belongs to none.
ScenePointer twoKinds() {
    auto components = std::make_shared<Components>();
    std::vector<MeshPointer> meshes;
    primitive::Surface surface;
    const auto add = [&](const primitive::Primitive& solid, const Mat4& place) {
        const auto first = uint32_t(surface.triangles.size() / 3);
        primitive::appendSurface(surface, solid, {1.0, 8}, place);
        components->parts.push_back({MeshPart::Kind::Solid, solid, place, first, uint32_t(surface.triangles.size() / 3) - first});
    };
    const auto end = [&] {
        meshes.push_back(primitive::meshOf(surface, "m"));
        components->endMesh();
        surface = {};
    };
    Mat4 above(1.0);
    above[3].z = 2.0;
    add(primitive::Box{{1, 1, 2}}, Mat4(1.0));
    add(primitive::Sphere{0.5}, above);
    end();
    add(primitive::Box{{3, 1, 1}}, Mat4(1.0));
    end();
    components->parts.push_back({MeshPart::Kind::Line, {}, Mat4(1.0), 0, 0});
    components->groups = {{"plant"}, {"pump", 0}};
    SceneRemarks remarks;
    remarks.components = components;
    remarks.up = UpAxis::Z;
    Mat4 aside(1.0);
    aside[3].x = 5.0;
    std::vector<Instance> instances{{0, Mat4(1.0), "a", 1}, {0, aside, "b", 1}, {1, Mat4(1.0), "c", 0}};
    return std::make_shared<const Scene>("two kinds", meshes, instances, nullptr, remarks);
}

TEST(Components, anObjectCarriesThePrimitivesOfItsMesh) {
    const ScenePointer scene = twoKinds();
    ASSERT_EQ(scene->partsOf(0).size(), 2u);
    EXPECT_STREQ(kindName(scene->partsOf(0)[0]), "box");
    EXPECT_STREQ(kindName(scene->partsOf(0)[1]), "sphere");
    EXPECT_EQ(scene->partsOf(0).data(), scene->partsOf(1).data()) << "equal objects share them";
    ASSERT_EQ(scene->partsOf(2).size(), 1u);
    EXPECT_EQ(std::get<primitive::Box>(scene->partsOf(2)[0].solid).size, Vec3(3, 1, 1));
    // The triangles of a part lie in the part's own box.
    const MeshPart& sphere = scene->partsOf(0)[1];
    const TriangleMesh& mesh = scene->meshOf(0);
    EXPECT_EQ(sphere.firstTriangle + sphere.triangleCount, mesh.triangleCount());
    for (size_t i = 3 * sphere.firstTriangle; i < mesh.indices().size(); ++i) EXPECT_GT(mesh.position(mesh.indices()[i]).z, 1.49);
    using testing::Pair;
    EXPECT_THAT(scene->partCounts(), testing::UnorderedElementsAre(Pair("box", 3u), Pair("sphere", 2u), Pair("line", 1u)));
    EXPECT_EQ(scene->remarks().components->groups[scene->instances()[1].group].name, "pump");
}

TEST(Components, aSceneWithoutThemHasNone) {
    const ScenePointer scene = sceneOf({squareMesh(1, 0)});
    EXPECT_TRUE(scene->partsOf(0).empty());
    EXPECT_TRUE(scene->partCounts().empty());
    EXPECT_EQ(scene->instances()[0].group, kNoGroup);
}

TEST(Components, stayWithTheirObjectsWhenOthersAreHidden) {
    const ScenePointer scene = withoutInstances(twoKinds(), {true, false, true});
    ASSERT_EQ(scene->instances().size(), 1u);
    EXPECT_EQ(scene->partsOf(0).size(), 2u);
    EXPECT_EQ(scene->instances()[0].group, 1u);
    EXPECT_EQ(scene->remarks().up, UpAxis::Z);
}

TEST(Components, memoryIsCounted) {
    const ScenePointer scene = twoKinds();
    EXPECT_GE(scene->bytes(), scene->meshes()[0]->bytes() + scene->meshes()[1]->bytes() + scene->remarks().components->bytes());
    EXPECT_GE(scene->remarks().components->bytes(), 4 * sizeof(MeshPart));
}

TEST(UpAxisOfAScene, stands) {
    const ScenePointer scene = twoKinds();
    const Camera camera = overviewCamera(*scene, 1.5);
    EXPECT_EQ(camera.up, Vec3(0, 0, 1));
    EXPECT_GT(camera.eye.z, camera.target.z) << "from above";
    EXPECT_EQ(homeCamera(*scene, UpAxis::Z, 1.5), camera);
    const Camera turned = homeCamera(*scene, UpAxis::Y, 1.5);
    EXPECT_EQ(turned.up, Vec3(0, 1, 0));
    EXPECT_GT(turned.eye.y, turned.target.y);
    for (const char* name : {"orbit:5", "walk:5"})
        for (const CameraPath::Pose& pose : cameraPath(name, *scene).poses) EXPECT_EQ(pose.up, Vec3(0, 0, 1)) << name;
    for (const CameraPath::Pose& pose : cameraPath("orbit:5", *scene).poses)
        EXPECT_NEAR(pose.eye.z - pose.target.z, 3.0 * std::sin(15.0 * 0.017453292519943295) * scene->boundingSphere().radius,
                    1e-9);
    EXPECT_EQ(splitScene(*scene, "split", {})->remarks().up, UpAxis::Z);
    // Without a remark y is up, as ever.
    EXPECT_EQ(overviewCamera(*sceneOf({squareMesh(1, 0)}), 1.5).up, Vec3(0, 1, 0));
}

}  // namespace
}  // namespace cullscope::test::components_test
