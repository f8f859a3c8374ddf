// What recorded frames say that they leave out (FrameLog::coarser): nothing of small scenes, and where it begins.

#include <gmock/gmock.h>

#include "core/mesh/parametric.h"
#include "tests/support/culler.h"
#include "tests/support/cut_scenes.h"
#include "tests/support/gl_environment.h"

namespace cullscope::test::coarser_logs_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

View ahead(Viewport size) { return {{{0, 0, 6}, Vec3(0.0), {0, 1, 0}, Angle::fromDegrees(60), 0.1, 100}, size}; }

std::vector<std::string> coarser(const char* id, const ScenePointer& scene, Viewport size = {80, 60},
                                 Recording recording = Recording::On) {
    const CullerPointer culler = makeCuller(id);
    culler->build(*scene);
    std::vector<std::string> words;
    for (const Message& one : culler->cull(ahead(size), recording, &GlEnvironment::renderer()).log.coarser)
        words.push_back(one.english());
    return words;
}

ScenePointer spheres(int count) {
    std::vector<Mat4> places;
    for (int i = 0; i < count; ++i)
        places.push_back(translation({0.4 * (i % 9) - 1.6, 0.4 * (i / 9) - 1.6, 0}) * scaling(Vec3(0.1)));
    return copiesOf(sphereMesh(80), places);
}

TEST(CoarserLogs, framesOfSmallScenesLeaveNothingOut) {
    const ScenePointer scene = spheres(4);
    for (const RegisteredStrategy& strategy : strategies())
        if (!unavailable(strategy.info, GlEnvironment::info())) {
            EXPECT_THAT(coarser(strategy.info.id.c_str(), scene), IsEmpty()) << strategy.info.id;
        }
}

/// Squares behind each other, each of which hides all after it.
ScenePointer squares(int count) {
    std::vector<MeshPointer> meshes;
    for (int i = 0; i < count; ++i) meshes.push_back(squareMesh(2, -0.01f * float(i)));
    return sceneOf(std::move(meshes));
}

TEST(CoarserLogs, eachLimitIsSaidWhereItIsPassed) {
    const ScenePointer fine = sceneOf({randomTriangles(1, 22'000, 0.03)}), medium = sceneOf({randomTriangles(1, 1'200, 0.1)});
    const std::string causes = "causes by object, above 5000 groups of triangles";
    EXPECT_THAT(coarser("depth-buffer", medium), IsEmpty());
    EXPECT_THAT(coarser("depth-buffer", fine, {640, 480}), ElementsAre("by bands of rows, above 2000 triangles", causes));
    EXPECT_THAT(coarser("scan-line", medium), IsEmpty());
    EXPECT_THAT(coarser("scan-line", fine, {1600, 1200}), Contains("by row, above 25000 spans"));
    EXPECT_THAT(coarser("scan-line", squares(60), {320, 480}), ElementsAre("without single edges, above 50000 of them"));
    EXPECT_THAT(coarser("scan-line", squares(220), {320, 480}), ElementsAre("by row, above 100000 steps"));
    EXPECT_THAT(coarser("painter", squares(60)), IsEmpty());
    EXPECT_THAT(coarser("painter", medium), ElementsAre("without depths and tests 1 and 2, above 1000 triangles"));
    EXPECT_THAT(coarser("painter", fine), ElementsAre("drawn polygons alone, above 5000 triangles"));
    EXPECT_THAT(coarser("bsp", medium), IsEmpty());
    EXPECT_THAT(coarser("bsp", fine), ElementsAre("the first 20000 nodes alone"));
    for (const char* id : {"spherical", "spherical-lossless"}) {
        EXPECT_THAT(coarser(id, spheres(64)), IsEmpty()) << id;
        EXPECT_THAT(coarser(id, spheres(65)), ElementsAre("results alone, above 64 objects")) << id;
    }
}

TEST(CoarserLogs, measuredFramesSayNothing) {
    EXPECT_THAT(coarser("depth-buffer", sceneOf({sphereMesh(20'000)}), {80, 60}, Recording::Off), IsEmpty());
    EXPECT_THAT(coarser("spherical", spheres(65), {80, 60}, Recording::Off), IsEmpty());
}

TEST(CoarserLogs, partOfALogKeepsWhatItLeavesOut) {
    const CullerPointer culler = makeCuller("painter");
    const ScenePointer scene = sceneOf({randomTriangles(1, 1'200, 0.1)});
    culler->build(*scene);
    const FrameLog log = culler->cull(ahead({80, 60}), Recording::On).log;
    ASSERT_EQ(log.coarser.size(), 1u);
    ASSERT_EQ(log.upTo(3).coarser.size(), 1u);
    EXPECT_EQ(log.upTo(3).coarser.front().english(), log.coarser.front().english());
}

}  // namespace
}  // namespace cullscope::test::coarser_logs_test
