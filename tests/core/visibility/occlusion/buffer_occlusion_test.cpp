// Occluders in software: what they hide, what is said of it, and that nothing is done where nothing can hide.

#include <map>
#include <set>

#include "core/mesh/parametric.h"
#include "core/visibility/why.h"
#include "tests/support/wall_scene.h"

namespace cullscope::test::buffer_occlusion_test {
namespace {

constexpr std::array kBoth{"occlusion-depth", "occlusion-masked"};

View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {128, 128}}; }

CullerPointer cullerOf(const char* id, const Scene& scene, const std::map<std::string, std::string>& settings = {}) {
    ParameterSet parameters(findStrategy(id).info.parameters);
    for (const auto& [key, value] : settings) parameters.setFromText(key, value);
    CullerPointer culler = makeCuller(id, parameters);
    culler->build(scene);
    return culler;
}

TEST(BufferOcclusion, leavesOutWhatAWallHidesAndDrawsTheRest) {
    const ScenePointer scene = wallBeforeSpheres();
    for (const char* id : kBoth) {
        const CullerPointer culler = cullerOf(id, *scene);
        EXPECT_EQ(culler->promise(), Promise::Conservative);
        const Culled frame = culler->cull(standardView());
        EXPECT_EQ(drawn(frame), (std::set<uint32_t>{0, 1})) << id;
        EXPECT_EQ(frame.culledTriangles[size_t(Cause::Hidden)], 12u * scene->meshOf(3).triangleCount());
        EXPECT_EQ(frame.consideredTriangles + frame.culledTriangles[size_t(Cause::Hidden)] +
                      frame.culledTriangles[size_t(Cause::OutsideFrustum)],
                  scene->triangleCount());
        EXPECT_GT(figure(frame, "hidden_nodes"), 0.0) << "groups are left out whole";
    }
}

TEST(BufferOcclusion, recordedFrameDecidesAsAMeasuredOneAndNamesEveryObjectOnce) {
    const ScenePointer scene = wallBeforeSpheres();
    for (const char* id : kBoth) {
        const CullerPointer culler = cullerOf(id, *scene);
        const Culled measured = culler->cull(standardView()), recorded = culler->cull(standardView(), Recording::On);
        EXPECT_EQ(measured.drawList.ranges, recorded.drawList.ranges);
        EXPECT_EQ(measured.culledTriangles, recorded.culledTriangles);
        EXPECT_TRUE(measured.log.decisions.empty());
        std::vector<int> ends(scene->instances().size(), 0);
        for (const Decision& decision : recorded.log.decisions) {
            if (decision.outcome == Decision::Outcome::Open) continue;
            if (decision.subject.kind == Subject::Kind::Object) ++ends[decision.subject.number];
            for (const uint32_t instance : recorded.log.objectsOf(decision)) ++ends[instance];
        }
        EXPECT_THAT(ends, testing::Each(1)) << id;
    }
}

TEST(BufferOcclusion, withoutOccludersNothingIsAskedOrHidden) {
    // Spheres of triangles below the least size, and a budget of none.
    const ScenePointer scene = wallBeforeSpheres();
    for (const char* id : kBoth)
        for (const std::map<std::string, std::string>& settings :
             {std::map<std::string, std::string>{{"pixels", "1e6"}}, {{"triangles", "0"}}}) {
            const Culled frame = cullerOf(id, *scene, settings)->cull(standardView());
            EXPECT_EQ(drawn(frame).size(), 14u) << "all but the one behind the eye";
            EXPECT_EQ(figure(frame, "occluders"), 0.0);
            EXPECT_EQ(figure(frame, "questions"), 0.0);
            EXPECT_EQ(frame.log.counters.workBytes, 0u) << "no buffer";
        }
}

TEST(BufferOcclusion, budgetOfTrianglesIsKept) {
    const ScenePointer scene = wallBeforeSpheres();
    for (const char* id : kBoth)
        for (const char* most : {"1", "2", "100"}) {
            const Culled frame = cullerOf(id, *scene, {{"triangles", most}, {"pixels", "1"}})->cull(standardView());
            EXPECT_LE(figure(frame, "occluder_triangles"), std::stod(most));
            EXPECT_GT(figure(frame, "occluder_triangles"), 0.0);
        }
}

TEST(BufferOcclusion, occluderThatComesLaterHidesWhatWasKept) {
    // The box of the long bar begins nearer than the wall, but all that the view shows of it lies behind the wall.
    std::vector<MeshPointer> meshes{squareMesh(8, -3), boxMesh({-0.5f, -0.5f, -9}, {0.5f, 0.5f, -8}),
                                    meshOf({{-1, -1, -9}, {1, -1, -9}, {40, 1, -2.5f}, {-1, 1, -9}}, {0, 1, 3, 1, 2, 3})};
    const ScenePointer scene = sceneOf(std::move(meshes));
    for (const char* id : kBoth) {
        const Culled frame = cullerOf(id, *scene)->cull(standardView(), Recording::On);
        EXPECT_FALSE(drawn(frame).contains(1)) << id;
        EXPECT_TRUE(drawn(frame).contains(2)) << "a triangle of it reaches before the wall's plane";
        size_t again = 0;
        for (const Decision& decision : frame.log.decisions) again += decision.line == 9 ? 1 : 0;
        EXPECT_GT(again, 0u);
    }
}

TEST(BufferOcclusion, boxesOfPartsHideWhatOneBoxDoesNot) {
    // A strip that runs askew behind a wall: the corner of its box lies beyond the wall's edge, those of its parts do not.
    std::vector<Vec3f> corners;
    std::vector<uint32_t> indices;
    for (int i = 0; i <= 40; ++i) {
        const float ahead = 5.0f + float(i);
        corners.emplace_back(-0.5f * (ahead - 5.0f), -0.2f, -ahead);
        corners.emplace_back(-0.5f * (ahead - 5.0f), 0.2f, -ahead);
        if (i < 40)
            for (const int corner : {0, 2, 1, 1, 2, 3}) indices.push_back(uint32_t(2 * i + corner));
    }
    const MeshPointer wall = meshOf({{-2.8f, -9, -3}, {9, -9, -3}, {9, 9, -3}, {-2.8f, 9, -3}}, {0, 1, 2, 0, 2, 3});
    const ScenePointer scene = sceneOf({wall, meshOf(std::move(corners), std::move(indices))});
    for (const char* id : kBoth) {
        const Culled frame = cullerOf(id, *scene)->cull(standardView(), Recording::On);
        EXPECT_EQ(drawn(frame), std::set<uint32_t>{0}) << id;
    }
}

TEST(BufferOcclusion, treeWhyAndCountsTellWhatIsHidden) {
    const ScenePointer scene = wallBeforeSpheres();
    for (const char* id : kBoth) {
        const CullerPointer culler = cullerOf(id, *scene);
        const Culled frame = culler->cull(standardView(), Recording::On);
        for (const SnapshotNode& node : culler->snapshot(frame.log).nodes) {
            if (node.isGroup()) continue;
            EXPECT_EQ(node.culled, !drawn(frame).contains(node.instance));
            if (node.culled) {
                EXPECT_EQ(node.cause, node.instance == 2 ? Cause::OutsideFrustum : Cause::Hidden);
            }
        }
        const Bars bars = culler->built()->bars(frame.log).at(0);
        EXPECT_EQ(double(bars.bars[0].value), figure(frame, "hidden_nodes"));
        EXPECT_EQ(double(bars.bars[1].value), figure(frame, "hidden_objects"));
        EXPECT_EQ(double(bars.bars[2].value), figure(frame, "occluders"));
        EXPECT_EQ(bars.bars[3].value, 2u);
        const auto has = [&](uint32_t instance, const std::string& words) {
            for (const WhyStep& step : why(*culler->built(), frame.log, scene->firstTriangle(instance)))
                if (step.sentence.english().find(words) != std::string::npos) return true;
            return false;
        };
        EXPECT_TRUE(has(0, "largest triangles go into the buffer"));
        EXPECT_TRUE(has(0, "is given to OpenGL"));
        EXPECT_TRUE(has(5, "is not given to OpenGL"));
    }
}

}  // namespace
}  // namespace cullscope::test::buffer_occlusion_test
