#include "core/scene/hidden.h"

#include "core/base/error.h"
#include "core/scene/camera_path.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::hidden_test {
namespace {

using Marks = std::vector<bool>;

ScenePointer threeSquares() { return sceneOf({squareMesh(1, 0), boxMesh(Vec3f(0), Vec3f(1)), squareMesh(1, 5)}); }

TEST(Hidden, instanceIsLeftOutAndItsMeshStays) {
    const ScenePointer scene = threeSquares();
    const ScenePointer rest = withoutInstances(scene, {false, true});
    EXPECT_EQ(rest->meshes(), scene->meshes()) << "the meshes keep their numbers";
    ASSERT_EQ(rest->instances().size(), 2u);
    EXPECT_EQ(rest->instances()[0].name, "object 0");
    EXPECT_EQ(rest->instances()[1].name, "object 2");
    EXPECT_EQ(rest->instances()[1].mesh, 2u);
    EXPECT_EQ(rest->triangleCount(), 4u);
    EXPECT_EQ(rest->firstTriangle(1), 2u);
    EXPECT_EQ(rest->name(), scene->name());
    EXPECT_NE(rest->sha256(), scene->sha256());
}

TEST(Hidden, nothingHiddenGivesTheSameScene) {
    const ScenePointer scene = threeSquares();
    EXPECT_EQ(withoutInstances(scene, {}), scene);
    EXPECT_EQ(withoutInstances(scene, {false, false, false}), scene);
}

TEST(Hidden, openMeshThatIsNotDrawnDoesNotCount) {
    const ScenePointer scene = threeSquares();
    EXPECT_FALSE(scene->frontFacesSuffice());
    EXPECT_TRUE(withoutInstances(scene, {true, false, true})->frontFacesSuffice());
}

TEST(Hidden, camerasOfAnEmptySceneAreValid) {
    const ScenePointer empty = withoutInstances(threeSquares(), {true, true, true});
    EXPECT_EQ(empty->instances().size(), 0u);
    EXPECT_EQ(empty->triangleCount(), 0u);
    EXPECT_TRUE(empty->bounds().empty());
    EXPECT_EQ(empty->boundingSphere().radius, 0.0);
    EXPECT_EQ(empty->boundingSphere().centre, Vec3(0.0));
    EXPECT_EQ(empty->sha256().size(), 64u);
    EXPECT_NO_THROW((void)View(overviewCamera(*empty, 1.5), {300, 200}));
    for (const char* name : {"orbit:3", "fibonacci:3", "walk:3", "case-1", "case-2", "case-3"}) {
        const CameraPath path = cameraPath(name, *empty);
        for (size_t pose = 0; pose < path.poses.size(); ++pose) {
            Camera camera = path.camera(pose);
            EXPECT_NO_THROW((void)View(camera, {300, 200})) << name << " " << pose;
            fitDepthRange(camera, *empty);
            EXPECT_NO_THROW((void)View(camera, {300, 200})) << name << " " << pose << ", depth range fitted";
        }
    }
    EXPECT_NO_THROW((void)cameraPath(defaultPathName(*empty), *empty));
}

TEST(Hidden, listIsReadAndWritten) {
    EXPECT_EQ(hiddenFromText("", 3), (Marks{false, false, false}));
    EXPECT_EQ(hiddenFromText("", 0), Marks{});
    EXPECT_EQ(hiddenFromText("1", 3), (Marks{false, true, false}));
    EXPECT_EQ(hiddenFromText("3,0-1,1", 5), (Marks{true, true, false, true, false}));
    EXPECT_EQ(hiddenFromText("4-4", 5), (Marks{false, false, false, false, true}));
    EXPECT_EQ(hiddenToText({}), "");
    EXPECT_EQ(hiddenToText({false, false}), "");
    EXPECT_EQ(hiddenToText({true, true, true, false, true, false, true, true}), "0-2,4,6-7");
    for (const char* text : {"0", "9", "0-9", "3,7-9", "0,2,4,6,8"}) EXPECT_EQ(hiddenToText(hiddenFromText(text, 10)), text);
}

TEST(Hidden, wrongListIsRefused) {
    using testing::HasSubstr;
    const auto refusal = [](std::string_view text, size_t objects) -> std::string {
        try {
            (void)hiddenFromText(text, objects);
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), ErrorKind::Usage);
            return error.what();
        }
        return {};
    };
    EXPECT_THAT(refusal("9", 9), HasSubstr("no object 9 to hide: the scene has 9 objects"));
    EXPECT_THAT(refusal("0", 0), HasSubstr("has 0 objects"));
    EXPECT_THAT(refusal("1,3-12", 9), HasSubstr("no object 12"));
    EXPECT_THAT(refusal("99999999999999999999999", 9), HasSubstr("no object 99999999999999999999999"));
    for (const char* text : {",", "1,", ",1", "1,,2", "a", "-1", "1-", "5-3", "1-2-3", " 1", "1.5", "0x1"})
        EXPECT_THAT(refusal(text, 9), HasSubstr("neither an object's number nor a range")) << text;
}

}  // namespace
}  // namespace cullscope::test::hidden_test
