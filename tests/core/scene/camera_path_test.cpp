#include "core/scene/camera_path.h"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <numeric>

#include "core/base/error.h"
#include "core/mesh/parametric.h"
#include "core/scene/camera_path_pose.h"
#include "core/scene/scene_source.h"
#include "tests/support/peak_memory.h"
#include "tests/support/refusal.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::camera_path_test {
namespace {

/// A temporary file of the test, removed at its end.
class TemporaryFile {
public:
    explicit TemporaryFile(const std::string& content = {}) : m_path(std::filesystem::path(testing::TempDir()) / name()) {
        if (!content.empty()) std::ofstream(m_path, std::ios::binary) << content;
    }
    ~TemporaryFile() { std::filesystem::remove(m_path); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return m_path; }

private:
    static std::string name() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        return std::string("cullscope-") + test->test_suite_name() + "-" + test->name() + ".json";
    }
    std::filesystem::path m_path;
};

/// The error sentence for a path file, without the file's name at its start.
std::string refusal(const std::string& content) {
    const TemporaryFile file(content);
    const std::string sentence = refusalOf([&] { (void)readCameraPath(file.path()); }, ErrorKind::Input);
    if (sentence.empty()) return {};
    EXPECT_TRUE(sentence.starts_with(file.path().string())) << sentence;
    return sentence.substr(file.path().string().size());
}

TEST(CameraPathFile, roundTripLosesNothing) {
    CameraPath path;
    path.fovy = Angle::fromDegrees(37.123456789012345);
    path.nearDistance = 1e-6;
    path.farDistance = 1e9;
    path.poses = {{{1.0 / 3, 1e7 + 0.1, -1e-300}, {0, 0, 0}, {0, 1, 0}}, {{0, 0, 5}, {0.1, 0.2, 0.3}, {0, 0, 1}}};
    const TemporaryFile file;
    writeCameraPath(file.path(), path);
    const CameraPath back = readCameraPath(file.path());
    EXPECT_NEAR(back.fovy.radians(), path.fovy.radians(), 1e-15);
    EXPECT_EQ(back.nearDistance, path.nearDistance);
    EXPECT_EQ(back.farDistance, path.farDistance);
    ASSERT_EQ(back.poses.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(back.poses[i].eye, path.poses[i].eye);
        EXPECT_EQ(back.poses[i].target, path.poses[i].target);
        EXPECT_EQ(back.poses[i].up, path.poses[i].up);
    }
}

TEST(CameraPathFile, parallelViewsKeepTheirHeight) {
    CameraPath path;
    path.projection = ProjectionKind::Parallel;
    path.height = 1.0 / 3;
    path.poses = {{{0, 0, 5}, {0, 0, 0}, {0, 1, 0}}};
    const TemporaryFile file;
    writeCameraPath(file.path(), path);
    const CameraPath back = readCameraPath(file.path());
    EXPECT_EQ(back.projection, ProjectionKind::Parallel);
    EXPECT_EQ(back.height, path.height);
    EXPECT_EQ(back.camera(0).projection, ProjectionKind::Parallel);
    EXPECT_EQ(back.camera(0).height, path.height);
    const std::string poses = R"("poses": [{"eye": [0,0,3], "target": [0,0,0], "up": [0,1,0]}]})";
    using testing::HasSubstr;
    EXPECT_THAT(refusal(R"({"projection": "parallel", )" + poses), HasSubstr("\"height\""));
    EXPECT_THAT(refusal(R"({"projection": "parallel", "height": 0, )" + poses), HasSubstr("height"));
    EXPECT_THAT(refusal(R"({"projection": "parallel", "height": "2", )" + poses), HasSubstr("\"height\" must be a number"));
    EXPECT_THAT(refusal(R"({"projection": "fisheye", )" + poses), HasSubstr("\"projection\""));
    EXPECT_THAT(refusal(R"({"projection": 3, )" + poses), HasSubstr("\"projection\""));
    EXPECT_EQ(refusal(R"({"projection": "perspective", )" + poses), "");
}

TEST(CameraPathFile, refusalNamesTheField) {
    const std::string pose = R"({"eye": [0,0,3], "target": [0,0,0], "up": [0,1,0]})";
    EXPECT_EQ(refusal(R"({"poses": [)" + pose + "]}"), "");
    EXPECT_THAT(refusal(R"({"poses": [)" + pose), testing::HasSubstr("not JSON"));
    EXPECT_THAT(refusal("{}"), testing::HasSubstr("\"poses\""));
    EXPECT_THAT(refusal("[1, 2]"), testing::HasSubstr("\"poses\""));
    EXPECT_THAT(refusal(R"({"poses": []})"), testing::HasSubstr("\"poses\""));
    EXPECT_THAT(refusal(R"({"poses": {}})"), testing::HasSubstr("\"poses\""));
    EXPECT_EQ(refusal(R"({"fovy_deg": "wide", "poses": [)" + pose + "]}"), ": \"fovy_deg\" must be a number.");
    EXPECT_EQ(refusal(R"({"near": null, "poses": [)" + pose + "]}"), ": \"near\" must be a number.");
    EXPECT_EQ(refusal(R"({"poses": [)" + pose + R"(, {"eye": [0,0], "target": [0,0,0], "up": [0,1,0]}]})"),
              ": pose 1: \"eye\" must be three numbers.");
    EXPECT_EQ(refusal(R"({"poses": [{"eye": [0,0,3], "target": "there", "up": [0,1,0]}]})"),
              ": pose 0: \"target\" must be three numbers.");
    EXPECT_EQ(refusal(R"({"poses": [{"eye": [0,0,3], "target": [0,0,0]}]})"), ": pose 0: \"up\" must be three numbers.");
    EXPECT_EQ(refusal(R"({"poses": [{"eye": [0,0,null], "target": [0,0,0], "up": [0,1,0]}]})"),
              ": pose 0: \"eye\" must be three numbers.");
    EXPECT_THAT(refusal(R"({"poses": [7]})"), testing::HasSubstr("pose 0"));
    EXPECT_THAT(refusal(R"({"poses": [{"eye": [0,0,0], "target": [0,0,0], "up": [0,1,0]}]})"),
                testing::HasSubstr("pose 0: The camera's eye and target"));
    EXPECT_THAT(refusal(R"({"near": 5, "far": 1, "poses": [)" + pose + "]}"), testing::HasSubstr("near distance"));
    EXPECT_THAT(refusal(R"({"fovy_deg": 180, "poses": [)" + pose + "]}"), testing::HasSubstr("field of view"));
}

TEST(CameraPathFile, takesMemoryForItsPosesAlone) {
    const std::string pose = R"({"eye":[0,0,3],"target":[0,0,0],"up":[0,1,0]})";
    std::string lists, numbers;
    for (int i = 0; i < 2'000'000; ++i) lists += "[],", numbers += "1,";
    const std::string ignored =
        R"({"unknown":[)" + lists + R"([]],"poses":[{"also":[)" + lists + R"({}],)" + pose.substr(1) + "]}";
    const std::string wrong = R"({"poses":[{"eye":[)" + numbers + R"(1],"target":[0,0,0],"up":[0,1,0]}]})";
    EXPECT_EQ(refusal(ignored), "");
    EXPECT_EQ(refusal(wrong), ": pose 0: \"eye\" must be three numbers.");
    if (!test::memoryIsTheWorks()) return;
    for (const std::string* text : {&ignored, &wrong}) {
        const TemporaryFile file(*text);
        EXPECT_LT(test::peakBytesOf([&] { (void)readCameraPath(file.path()); }), size_t{8} << 20);
    }
}

TEST(CameraPathFile, hasAMillionPosesAtMost) {
    std::string text = R"({"poses":[)";
    for (size_t pose = 0; pose < kMostPoses; ++pose) text += R"({"eye":[0,0,3],"target":[0,0,0],"up":[0,1,0]},)";
    EXPECT_THAT(refusal(text + R"({"eye":[0,0,3],"target":[0,0,0],"up":[0,1,0]}]})"),
                testing::HasSubstr("has more than 1000000 poses"));
    text.back() = ']';
    EXPECT_EQ(refusal(text + "}"), "");
}

TEST(CameraPathFile, theLastOfTwoFieldsOfANameCounts) {
    const std::string pose = R"({"eye":[9],"eye":[0,0,3],"target":[0,0,0],"up":[0,1,0]})";
    EXPECT_EQ(refusal(R"({"near":"wide","poses":7,"poses":[)" + pose + R"(],"near":0.1})"), "");
    EXPECT_EQ(refusal(R"({"near":0.1,"poses":[)" + pose + R"(],"near":"wide"})"), ": \"near\" must be a number.");
}

TEST(CameraPath, unknownOrMalformedNameIsRefused) {
    const ScenePointer scene = sceneOf({squareMesh(1, 0)});
    for (const char* name : {"orbi:4", "case-4", "case-0", "/no/such/path.json", ""}) {
        try {
            (void)cameraPath(name, *scene);
            FAIL() << name;
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), name[0] == '/' ? ErrorKind::Input : ErrorKind::Usage) << name;
        }
    }
    for (const char* name : {"orbit:0", "walk:-1", "fibonacci:many", "orbit:", "walk:4x", "walk:1000001"})
        EXPECT_THROW((void)cameraPath(name, *scene), Error) << name;
    EXPECT_EQ(cameraPath("orbit:7", *scene).poses.size(), 7u);
    EXPECT_EQ(cameraPath("walk", *scene).poses.size(), 16u);
}

TEST(CameraPath, builtInPathsMakePicturesOfEveryScene) {
    const MeshPointer point = meshOf({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {0, 1, 2});
    const std::vector<ScenePointer> scenes{sceneOf({sphereMesh(80)}),
                                           sceneOf({squareMesh(1, 0)}),
                                           sceneOf({point}),
                                           std::make_shared<Scene>("empty", std::vector<MeshPointer>{}, std::vector<Instance>{}),
                                           sceneOf({squareMesh(1e-6f, 0)}),
                                           sceneOf({squareMesh(1, 0)}, {translation({1e7, -1e7, 1e7})}),
                                           sceneOf({squareMesh(1e9f, 0)})};
    for (const ScenePointer& scene : scenes)
        for (const BuiltInPath& path : builtInPaths()) {
            std::string name = path.id;
            if (name.ends_with(":N")) name.back() = '9';
            const CameraPath built = cameraPath(name, *scene);
            EXPECT_EQ(built.name, name);
            for (size_t i = 0; i < built.poses.size(); ++i)
                EXPECT_NO_THROW(validate(built.camera(i), {640, 480})) << name << " pose " << i;
        }
}

TEST(CameraPath, fibonacciLiesEvenlyOnTheSphereOfThreeRadii) {
    const ScenePointer scene = sceneOf({sphereMesh(320)}, {translation({5, 6, 7}) * scaling(Vec3(2.0))});
    const CameraPath path = cameraPath("fibonacci:200", *scene);
    const Sphere& sphere = scene->boundingSphere();
    Vec3 mean(0.0);
    for (const CameraPath::Pose& pose : path.poses) {
        EXPECT_NEAR(glm::distance(pose.eye, sphere.centre), 3 * sphere.radius, 1e-9);
        EXPECT_EQ(pose.target, sphere.centre);
        mean += (pose.eye - sphere.centre) / (3 * sphere.radius * 200);
    }
    EXPECT_LT(glm::length(mean), 0.02) << "the poses are not spread evenly";
    EXPECT_NEAR(path.fovy.degrees(), 45, 1e-12);
}

TEST(CameraPath, sceneOfManyObjectsIsWalkedThroughByDefault) {
    EXPECT_EQ(defaultPathName(*sceneOf({squareMesh(1, 0)})), "fibonacci:16");
    EXPECT_EQ(defaultPathName(*sceneOf({squareMesh(1, 0), squareMesh(1, 1)})), "walk:16");
}

TEST(CameraPath, horizontalFieldIsTheViewsOwn) {
    for (const double degrees : {1.0, 30.0, 90.0, 170.0})
        for (const Viewport& size : {Viewport{1920, 1080}, Viewport{10, 700}}) {
            Camera camera;
            camera.fovy = verticalField(Angle::fromDegrees(degrees), size);
            const double half = std::atan(View(camera, size).frustum().tanHalfWidth);
            EXPECT_NEAR(2.0 * half, Angle::fromDegrees(degrees).radians(), 1e-9);
        }
    EXPECT_NEAR(verticalField(Angle::fromDegrees(30), {1920, 1080}).degrees(), 17.14, 0.01);
}

TEST(CameraPath, overviewShowsEverything) {
    for (const double aspect : {0.2, 1.0, 3.0}) {
        const ScenePointer scene = sceneOf({sphereMesh(320), squareMesh(4, 3)}, {translation({5, 6, 7}), Mat4(1.0)});
        const View view(overviewCamera(*scene, aspect), {int(1000 * aspect), 1000});
        for (size_t i = 0; i < scene->instances().size(); ++i) {
            const TriangleMesh& mesh = scene->meshOf(i);
            for (size_t v = 0; v < mesh.vertexCount(); ++v)
                for (const Plane& plane : view.frustum().planes)
                    EXPECT_GT(
                        plane.distance(Vec3(scene->instances()[i].worldFromMesh * Vec4(mesh.position(v), 1.0)) - view.eye()),
                        0.0);
        }
    }
}

TEST(CameraPath, onePoseOfACaseIsThatOfTheWholePath) {
    const ScenePointer scene = openScene("star:seed=5,triangles=2000").scene;
    for (const char* name : {"case-1", "case-2", "case-3", "orbit:5", "walk:6"}) {
        const CameraPath whole = cameraPath(name, *scene);
        for (const size_t pose : {size_t(0), size_t(3), whole.poses.size() - 1}) {
            const CameraPath one = cameraPathAt(name, pose, *scene);
            ASSERT_EQ(one.poses.size(), whole.poses.size()) << name;
            EXPECT_EQ(one.camera(pose), whole.camera(pose)) << name << ", pose " << pose;
        }
    }
    EXPECT_THROW((void)cameraPathAt("case-4", 0, *scene), Error);
}

}  // namespace
}  // namespace cullscope::test::camera_path_test
