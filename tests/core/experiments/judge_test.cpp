// What another program says that it draws, beside the truth; and the suite of scenes with what must be drawn.
#include "core/experiments/suite/judge.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/experiments/stability/battery.h"
#include "core/experiments/suite/suite.h"
#include "core/scene/scene_source.h"
#include "tests/support/gl_environment.h"
#include "tests/support/long_mode.h"
#include "tests/support/refusal.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::judge_test {
namespace {

using suite::CullingKind;
using suite::Judgement;
using suite::JudgeRequest;

constexpr Viewport kSize{200, 200};

/// A wall, and two squares before it of about 1,000 pixels and of one; a square behind the wall, and one beside the view.
ScenePointer wallAndSquares() {
    return sceneOf(
        {squareMesh(3, -4), squareMesh(0.316f, -2), squareMesh(0.012f, -2), squareMesh(1, -6), squareMesh(1, -2)},
        {Mat4(1.0), translation({0.005, 0.005, 0}), translation({1.005, 1.005, 0}), Mat4(1.0), translation({9, 0, 0})});
}
enum Object : uint32_t { Wall, Large, Small, Hidden, Beside };

CameraPath onePose() {
    CameraPath path{.name = "one", .fovy = Angle::fromDegrees(90), .nearDistance = 0.1, .farDistance = 10};
    path.poses.push_back({Vec3(0.0), {0, 0, -1}, {0, 1, 0}});
    return path;
}

Judgement judged(const std::vector<uint32_t>& objects) {
    JudgeRequest request;
    request.scene = wallAndSquares();
    request.path = onePose();
    request.size = kSize;
    DrawnSets::Triangles triangles;
    for (const uint32_t object : objects) {
        const uint64_t first = request.scene->firstTriangle(object);
        triangles.emplace_back(first, first + request.scene->meshOf(object).triangleCount());
    }
    request.drawn.poses = {triangles};
    return suite::judgeDrawn(request, GlEnvironment::renderer());
}

TEST(Judge, oneVisibleObjectLeftOutIsFoundWhateverItsSize) {
    EXPECT_TRUE(judged({Wall, Large, Small}).right());
    for (const auto& [without, most] : {std::pair(Large, uint64_t{1100}), std::pair(Small, uint64_t{1})}) {
        std::vector<uint32_t> objects{Wall, Large, Small};
        std::erase(objects, uint32_t(without));
        const Judgement judgement = judged(objects);
        EXPECT_FALSE(judgement.right());
        EXPECT_EQ(judgement.kind(), CullingKind::Lossy);
        ASSERT_EQ(judgement.poses[0].missing.size(), 1u);
        EXPECT_EQ(judgement.poses[0].missing[0].instance, uint32_t(without));
        EXPECT_EQ(judgement.poses[0].missing[0].pixels, judgement.total().missedPixels);
        EXPECT_LE(judgement.total().missedPixels, most);
        EXPECT_GE(judgement.total().missedPixels, most == 1 ? 1u : 900u);
        EXPECT_EQ(judgement.worstPose(), std::optional<size_t>(0));
    }
}

TEST(Judge, cullingIsCalledWhatItIs) {
    EXPECT_EQ(judged({Wall, Large, Small, Hidden, Beside}).kind(), CullingKind::None);
    EXPECT_EQ(judged({Wall, Large, Small, Hidden}).kind(), CullingKind::Frustum);
    EXPECT_EQ(judged({Wall, Large, Small}).kind(), CullingKind::Occlusion);
    EXPECT_EQ(judged({Wall, Large, Small, Beside}).kind(), CullingKind::Occlusion);
    EXPECT_EQ(judged({Large, Small}).kind(), CullingKind::Lossy);
    EXPECT_EQ(judged({}).kind(), CullingKind::Lossy);
    const Judgement frustum = judged({Wall, Large, Small, Hidden});
    EXPECT_EQ(frustum.poses[0].inVain, 1u);
    EXPECT_EQ(frustum.poses[0].inVainInView, 1u);
    EXPECT_EQ(frustum.poses[0].leftOut, 1u);
    EXPECT_EQ(frustum.poses[0].leftOutInView, 0u);
    EXPECT_EQ(frustum.total().needlesslyDrawnTriangles, 3u) << "those of the hidden square, and one of that of one pixel";
    EXPECT_THAT(suite::kindSentence(frustum).english(), testing::HasSubstr("View-frustum culling: all 1 objects"));
}

/// OpenSceneGraph 3.6.5's own frustum culling of the suite's field, as tests/benchmark/judge_openscenegraph keeps it.
TEST(Judge, openSceneGraphsFrustumCullingIsCalledFrustumCulling) {
    const std::vector<suite::SuiteScene> scenes = suite::suiteScenes();
    const auto found = std::ranges::find(scenes, "field", &suite::SuiteScene::name);
    ASSERT_NE(found, scenes.end());
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("cullscope-osg-" + std::to_string(getpid()));
    const auto written = suite::writeSuite(folder, {*found}, GlEnvironment::renderer());
    JudgeRequest request;
    request.scene = openScene((folder / "field.obj").string()).scene;
    request.drawn = readDrawnSets(CULLSCOPE_SOURCE_DIR "/tests/benchmark/openscenegraph-drawn.json", *request.scene);
    request.path = cameraPath((folder / "field.required.json").string(), *request.scene);
    request.size = found->sizes.front();
    ASSERT_EQ(request.path.poses.size(), request.drawn.path.poses.size());
    for (size_t pose = 0; pose < request.path.poses.size(); ++pose)
        EXPECT_LT(glm::length(request.path.poses[pose].eye - request.drawn.path.poses[pose].eye), 1e-9) << "another walk is kept";
    const Judgement judgement = suite::judgeDrawn(request, GlEnvironment::renderer());
    EXPECT_EQ(judgement.kind(), CullingKind::Frustum);
    EXPECT_GT(judgement.total().coveredPixels, 100'000u);
    EXPECT_GT(judgement.total().needlesslyDrawnTriangles, judgement.total().submittedTriangles / 2)
        << "it does not see what is hidden";
    // An object that is seen is left out of one of its sets.
    const Reference truth = itemBufferReference(GlEnvironment::renderer(), SceneBuffers(request.scene, Upload::Vbo),
                                                View(request.path.camera(0), request.size), Facing::TwoSided);
    const uint64_t seen = request.scene->instanceOf(truth.visibleTriangles.front());
    const uint64_t first = request.scene->firstTriangle(seen), end = first + request.scene->meshOf(seen).triangleCount();
    DrawnSets::Triangles rest;
    for (const auto& [from, to] : request.drawn.poses[0]) {
        if (from < first) rest.emplace_back(from, std::min(to, first));
        if (to > end) rest.emplace_back(std::max(from, end), to);
    }
    request.drawn.poses[0] = rest;
    const Judgement without = suite::judgeDrawn(request, GlEnvironment::renderer());
    EXPECT_FALSE(without.right());
    ASSERT_FALSE(without.poses[0].missing.empty());
    EXPECT_EQ(without.poses[0].missing[0].instance, seen);
    std::filesystem::remove_all(folder);
}

class Suite : public testing::Test {
protected:
    void SetUp() override {
        m_folder = std::filesystem::temp_directory_path() / ("cullscope-suite-" + std::to_string(getpid()));
        std::filesystem::create_directories(m_folder);
    }
    void TearDown() override { std::filesystem::remove_all(m_folder); }
    [[nodiscard]] std::filesystem::path file(const std::string& name) const { return m_folder / name; }
    std::filesystem::path write(const std::string& text) const {
        std::ofstream(file("drawn.json")) << text;
        return file("drawn.json");
    }

private:
    std::filesystem::path m_folder;
};

TEST_F(Suite, requiredSetsAreJudgedRightAndOneTriangleLessIsNot) {
    std::vector<suite::SuiteScene> scenes = suite::suiteScenes();
    EXPECT_GT(scenes.size(), 25u);
    if (fewSamples())
        std::erase_if(scenes, [](const suite::SuiteScene& one) { return one.name != "case-27-cycle" && one.name != "field"; });
    const auto written = suite::writeSuite(file("suite"), scenes, GlEnvironment::renderer());
    ASSERT_EQ(written.size(), scenes.size());
    size_t judgedFiles = 0, lessIsWrong = 0;
    for (const auto& entry : std::filesystem::directory_iterator(file("suite"))) {
        const std::string name = entry.path().filename().string();
        if (!name.ends_with(".required.json")) continue;
        JudgeRequest request;
        request.scene = openScene((file("suite") / (name.substr(0, name.find('.')) + ".obj")).string()).scene;
        request.drawn = readDrawnSets(entry.path(), *request.scene);
        request.path = cameraPath(entry.path().string(), *request.scene);
        std::ifstream in(entry.path());
        const auto json = nlohmann::json::parse(in);
        request.size = {json["size"][0], json["size"][1]};
        if (request.size.width > 2000) continue;
        ++judgedFiles;
        EXPECT_TRUE(suite::judgeDrawn(request, GlEnvironment::renderer()).right()) << name;
        auto pose = std::ranges::find_if(request.drawn.poses, [](const auto& one) { return !one.empty(); });
        if (pose == request.drawn.poses.end()) continue;
        ++pose->front().first;
        EXPECT_FALSE(suite::judgeDrawn(request, GlEnvironment::renderer()).right()) << name;
        ++lessIsWrong;
    }
    EXPECT_GE(judgedFiles, fewSamples() ? 2u : 30u);
    EXPECT_GE(lessIsWrong, fewSamples() ? 2u : 28u);
    EXPECT_TRUE(std::filesystem::exists(file("suite") / "README.md"));
    std::ifstream in(file("suite") / "battery.json");
    EXPECT_EQ(nlohmann::json::parse(in)["cases"].size(), stability::battery().size());
}

TEST_F(Suite, setsNameObjectsByNumberNameAndRange) {
    const ScenePointer scene = wallAndSquares();
    const DrawnSets sets =
        readDrawnSets(write(R"({"poses": [{"objects": [0, "object 2", "3-4"]}, {"triangles": [1, "4-5", 5]}]})"), *scene);
    ASSERT_EQ(sets.poses.size(), 2u);
    EXPECT_EQ(sets.poses[0], (DrawnSets::Triangles{{0, 2}, {4, 10}}));
    EXPECT_EQ(sets.poses[1], (DrawnSets::Triangles{{1, 2}, {4, 6}}));
    EXPECT_FALSE(sets.byObjects);
    EXPECT_TRUE(sets.path.poses.empty());
    const auto refusal = [&](const std::string& text) {
        return refusalOf([&] { (void)readDrawnSets(write(text), *scene); }, ErrorKind::Input);
    };
    using testing::HasSubstr;
    EXPECT_THAT(refusal(R"({"poses": [{"objects": [5]}]})"), HasSubstr("pose 0: 5 names nothing"));
    EXPECT_THAT(refusal(R"({"poses": [{"objects": []}, {"objects": ["wall"]}]})"), HasSubstr("pose 1: \"wall\" names nothing"));
    EXPECT_THAT(refusal(R"({"poses": [{"triangles": ["7-3"]}]})"), HasSubstr("\"7-3\""));
    EXPECT_THAT(refusal(R"({"poses": [{"triangles": [-1]}]})"), HasSubstr("-1"));
    EXPECT_THAT(refusal(R"({"poses": [{}]})"), HasSubstr("objects"));
    EXPECT_THAT(refusal(R"({"poses": []})"), HasSubstr("poses"));
    EXPECT_THAT(refusal(R"([1)"), HasSubstr("is not JSON"));
    EXPECT_THAT(refusal(R"({"fovy_deg": "x", "poses": [{"objects": []}]})"), HasSubstr("fovy_deg"));
    EXPECT_THAT(refusal(R"({"projection": "flat", "poses": [{"objects": []}]})"), HasSubstr("\"projection\""));
    EXPECT_THAT(refusal(R"({"projection": "parallel", "poses": [{"objects": []}]})"), HasSubstr("\"height\""));
    EXPECT_THAT(refusal(R"({"projection": "parallel", "height": 0, "poses": [{"objects": [], "eye": [0,0,1]}]})"),
                HasSubstr("height"));
    EXPECT_THAT(refusal(R"({"poses": [{"objects": [], "eye": [0,0]}]})"), HasSubstr("three numbers"));
    EXPECT_THAT(refusal(R"({"poses": [{"objects": [], "eye": [0,0,1], "target": [0,0,0]}, {"objects": []}]})"),
                HasSubstr("some poses"));
}

TEST_F(Suite, setsAreReadAsTheyWereWritten) {
    const ScenePointer scene = wallAndSquares();
    CameraPath path = onePose();
    writeDrawnSets(file("sets.json"), {"wall.obj", path, kSize, "two-sided", {{path.poses[0], {0, 2}, {{0, 2}, {4, 5}}}}});
    const DrawnSets sets = readDrawnSets(file("sets.json"), *scene);
    EXPECT_EQ(sets.poses[0], (DrawnSets::Triangles{{0, 2}, {4, 5}}));
    ASSERT_EQ(sets.path.poses.size(), 1u);
    EXPECT_EQ(sets.path.camera(0), path.camera(0));
    EXPECT_EQ(cameraPath(file("sets.json").string(), *scene).camera(0), path.camera(0)) << "it is a camera path, too";
    CameraPath parallel = path;
    parallel.projection = ProjectionKind::Parallel;
    parallel.height = 7.5;
    writeDrawnSets(file("sets.json"), {"wall.obj", parallel, kSize, "two-sided", {{path.poses[0], {0, 2}, {}}}});
    EXPECT_EQ(readDrawnSets(file("sets.json"), *scene).path.camera(0), parallel.camera(0));
    EXPECT_EQ(cameraPath(file("sets.json").string(), *scene).camera(0), parallel.camera(0));
    JudgeRequest request{scene, path, sets, kSize};
    request.path.poses.push_back(path.poses[0]);
    EXPECT_THAT(refusalOf([&] { (void)suite::judgeDrawn(request, GlEnvironment::renderer()); }, ErrorKind::Input),
                testing::HasSubstr("1 poses, and the camera path 2"));
}

TEST(DrawnSets, nearestPoseIsTheOneWithTheCamera) {
    DrawnSets sets;
    for (int i = 0; i < 6; ++i) sets.path.poses.push_back({Vec3(i % 3, 0, 0), Vec3(i % 3, 0, i < 3 ? -1 : 1), {0, 1, 0}});
    for (size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(sets.nearestPose(sets.path.camera(i)), i);
        Camera near = sets.path.camera(i);
        near.eye.x += 0.1;
        near.target += Vec3(0.1, 0.05, 0);
        EXPECT_EQ(sets.nearestPose(near), i);
    }
}

TEST(RangesOf, joinsWhatFollowsItself) {
    EXPECT_EQ(rangesOf({}), DrawnSets::Triangles{});
    EXPECT_EQ(rangesOf({7, 3, 4, 4, 5, 9}), (DrawnSets::Triangles{{3, 6}, {7, 8}, {9, 10}}));
}

}  // namespace
}  // namespace cullscope::test::judge_test
