#include "core/scene/split_scene.h"

#include "core/mesh/parametric.h"
#include "core/scene/camera_path.h"
#include "core/scene/scene_source.h"
#include "tests/support/refusal.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::split_scene_test {
namespace {

/// Two boxes that do not touch, as one mesh.
MeshPointer twoBoxes() {
    TriangleMesh::Data data;
    data.name = "boxes";
    for (const float x : {0.0F, 5.0F}) {
        const MeshPointer box = boxMesh(Vec3f(x, 0, 0), Vec3f(x + 1, 1, 1));
        const auto first = static_cast<uint32_t>(data.positions.size());
        data.positions.insert(data.positions.end(), box->positions().begin(), box->positions().end());
        for (const uint32_t index : box->indices()) data.indices.push_back(first + index);
    }
    return std::make_shared<TriangleMesh>(std::move(data));
}

TEST(SplitScene, copiesShareTheirPartsAndStayInPlace) {
    const MeshPointer boxes = twoBoxes();
    const MeshPointer square = squareMesh(1, 0);
    const Scene scene("s", {boxes, square},
                      {{0, Mat4(1.0), "a"}, {1, translation({0, 9, 0}), "flat"}, {0, translation({100, 0, 0}), "b"}});
    const ScenePointer split = splitScene(scene, "parts", {});
    EXPECT_EQ(split->name(), "parts");
    EXPECT_EQ(split->triangleCount(), scene.triangleCount());
    EXPECT_EQ(split->meshes().size(), 3u);
    std::vector<std::string> names;
    for (const Instance& instance : split->instances()) names.push_back(instance.name);
    EXPECT_THAT(names, testing::ElementsAre("a 1", "a 2", "flat", "b 1", "b 2"));
    EXPECT_EQ(split->instances()[0].mesh, split->instances()[3].mesh);
    EXPECT_EQ(&split->meshOf(2), square.get()) << "what is whole stays what it is";
    EXPECT_NEAR(split->instanceBox(4).min.x, 105.0, 1e-4);
    EXPECT_EQ(split->instances()[2].worldFromMesh, scene.instances()[1].worldFromMesh);
}

TEST(SplitScene, camerasStandAsBeforeTheWhole) {
    const ScenePointer whole = openScene("knot:triangles=5000").scene;
    const ScenePointer split = openScene("split:mesh=knot:triangles=5000,by=clusters,triangles=300").scene;
    ASSERT_GT(split->instances().size(), 10u);
    EXPECT_EQ(overviewCamera(*split, 1.5), overviewCamera(*whole, 1.5));
    for (const char* path : {"fibonacci:3", "walk:3"})
        for (size_t pose = 0; pose < 3; ++pose)
            EXPECT_EQ(cameraPath(path, *split).camera(pose), cameraPath(path, *whole).camera(pose)) << path;
    for (size_t i = 0; i < split->instances().size(); ++i)
        for (size_t v = 0; v < split->meshOf(i).vertexCount(); ++v) {
            const Vec3 world(split->instances()[i].worldFromMesh * Vec4(split->meshOf(i).position(v), 1.0));
            ASSERT_TRUE(glm::all(glm::lessThanEqual(split->bounds().min, world)));
            ASSERT_TRUE(glm::all(glm::lessThanEqual(world, split->bounds().max)));
        }
}

TEST(SplitScene, moreObjectsThanASceneMayHaveAreRefused) {
    const MeshPointer sphere = sphereMesh(80'000);
    const ScenePointer scene = copiesOf(sphere, std::vector<Mat4>(60, Mat4(1.0)));
    EXPECT_THROW((void)splitScene(*scene, "s", {SplitRule::By::Clusters, 1}), Error);
    EXPECT_EQ(splitScene(*scene, "s", {SplitRule::By::Clusters, sphere->triangleCount() / 2})->instances().size(), 120u);
}

std::string refusal(std::string_view specification) {
    return refusalOf([&] { (void)openScene(specification); }, ErrorKind::Usage);
}

TEST(SplitScene, badSpecificationIsRefused) {
    using testing::HasSubstr;
    EXPECT_THAT(refusal("split:mesh=sphere,by=lumps"), HasSubstr("by=lumps is unknown. Write by=components or by=clusters"));
    EXPECT_THAT(refusal("split:mesh=sphere,triangles=50"), HasSubstr("Write by=clusters"));
    EXPECT_THAT(refusal("split:mesh=sphere,by=components,triangles=50"), HasSubstr("Write by=clusters"));
    for (const char* number : {"0", "-1", "1.5", "many"})
        EXPECT_THAT(refusal(std::string("split:mesh=sphere,by=clusters,triangles=") + number), HasSubstr("triangles")) << number;
    EXPECT_THAT(refusal("split:mesh=sphere,n=5"), HasSubstr("no parameter \"n\". It has: mesh, by, triangles"));
    EXPECT_THAT(refusal("split:mesh=sphere:triangels=5"), HasSubstr("sphere has no parameter \"triangels\""));
    EXPECT_THAT(refusal("split:by=clusters,by=clusters"), HasSubstr("split: by is given twice"));
    EXPECT_THAT(refusal("split:mesh=speere"), HasSubstr("\"speere\" is neither a file nor a generator"));
}

TEST(SplitScene, nestedParametersGoToTheirGenerator) {
    const auto objects = [](const char* specification) { return openScene(specification).scene->instances().size(); };
    const auto triangles = [](const char* specification) { return openScene(specification).scene->triangleCount(); };
    const size_t hundreds = (triangles("torus:triangles=2000") + 99) / 100;
    EXPECT_EQ(objects("split:mesh=torus:triangles=2000,by=clusters,triangles=100"), hundreds);
    EXPECT_EQ(objects("split:by=clusters,triangles=100,mesh=torus:triangles=2000"), hundreds);
    EXPECT_EQ(objects("split:mesh=star:seed=3,triangles=2000,by=clusters"), 1u) << "triangles is the star's";
    EXPECT_EQ(objects("split:mesh=field:mesh=torus:triangles=2000,n=3,spacing=4,by=clusters,triangles=1000"), 27u);
    EXPECT_EQ(objects("field:mesh=split:mesh=torus:triangles=2000,by=clusters,n=3"), 9u) << "a field is of one mesh";
    EXPECT_EQ(objects("split:mesh=split:mesh=torus:triangles=2000,by=components,by=clusters,triangles=100"), hundreds);
    EXPECT_EQ(triangles("mesh:sphere:triangles=2000,triangles=600"), 600u);
    EXPECT_EQ(triangles("field:mesh=mesh:sphere:triangles=2000,triangles=600,n=2"), 2400u);
    EXPECT_EQ(openScene("split:mesh=torus:triangles=2000,by=clusters").specification,
              "split:mesh=torus:triangles=2000,by=clusters");
}

TEST(SceneFiles, areChangedWhereverTheyStand) {
    const auto changed = [](const char* specification) {
        return withFiles(specification, [](const std::string& file) { return "<" + file + ">"; });
    };
    EXPECT_EQ(changed("a.obj"), "<a.obj>");
    EXPECT_EQ(changed("sphere"), "sphere");
    EXPECT_EQ(changed("sphere:triangles=5"), "sphere:triangles=5");
    EXPECT_EQ(changed("field:mesh=a,b.obj,n=3"), "field:mesh=<a,b.obj>,n=3");
    EXPECT_EQ(changed("field:n=3,mesh=bunny"), "field:n=3,mesh=bunny");
    EXPECT_EQ(changed("mesh:/x=1/a.obj,triangles=5"), "mesh:</x=1/a.obj>,triangles=5");
    EXPECT_EQ(changed("split:mesh=mesh:a.obj,triangles=5,by=clusters,triangles=3"),
              "split:mesh=mesh:<a.obj>,triangles=5,by=clusters,triangles=3");
    EXPECT_EQ(changed("split:mesh=field:mesh=c:d.obj,n=2,by=components"), "split:mesh=field:mesh=<c:d.obj>,n=2,by=components");
}

}  // namespace
}  // namespace cullscope::test::split_scene_test
