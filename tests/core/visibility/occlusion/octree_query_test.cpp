#include "core/spatial/instance_octree.h"

#include <map>
#include <set>

#include "core/frame/prediction.h"
#include "core/mesh/parametric.h"
#include "core/scene/camera_path.h"
#include "core/scene/layers_scene.h"
#include "core/visibility/why.h"
#include "tests/support/gl_environment.h"
#include "tests/support/wall_scene.h"

namespace cullscope::test::octree_query_test {
namespace {

using Settings = std::map<std::string, std::string>;

CullerPointer octreeQuery(const Settings& settings = {}) {
    ParameterSet parameters(findStrategy("octree-query").info.parameters);
    for (const auto& [key, value] : settings) parameters.setFromText(key, value);
    return makeCuller("octree-query", parameters);
}

View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {100, 100}}; }

Culled frameOf(Culler& culler, const View& view, Recording recording = Recording::On) {
    return culler.cull(view, recording, &GlEnvironment::renderer());
}

TEST(OctreeQuery, leavesOutWhatAWallHidesAndDrawsTheRest) {
    const ScenePointer scene = wallBeforeSpheres();
    for (const Settings& settings :
         {Settings{}, Settings{{"batch", "1"}}, Settings{{"ask", "leaves"}}, Settings{{"leaf", "3"}}}) {
        const CullerPointer culler = octreeQuery(settings);
        culler->build(*scene);
        EXPECT_EQ(culler->promise(), Promise::Conservative);
        const Culled frame = frameOf(*culler, standardView());
        if (settings.contains("batch")) {
            EXPECT_EQ(drawn(frame), (std::set<uint32_t>{0, 1})) << "asked one by one, the wall hides every sphere behind it";
        }
        EXPECT_TRUE(drawn(frame).contains(0) && drawn(frame).contains(1));
        const uint64_t hidden = frame.culledTriangles[size_t(Cause::Hidden)];
        EXPECT_GT(hidden, 0u);
        EXPECT_EQ(frame.consideredTriangles + hidden + frame.culledTriangles[size_t(Cause::OutsideFrustum)],
                  scene->triangleCount());
    }
}

TEST(OctreeQuery, ofLayersOnlyTheFirstIsDrawn) {
    const ScenePointer scene = layersScene("layers", {32, 200});
    const CameraPath path = cameraPath("front:3", *scene);
    for (const char* batch : {"1", "16", "4096"}) {
        const CullerPointer culler = octreeQuery({{"batch", batch}});
        culler->build(*scene);
        for (size_t pose = 0; pose < 3; ++pose) {
            const Culled frame = frameOf(*culler, View(path.camera(pose), {96, 64}));
            EXPECT_EQ(drawn(frame), std::set<uint32_t>{0}) << batch;
            EXPECT_EQ(figure(frame, "query_batches"), std::string(batch) == "1" ? 5 : 3) << "one sibling on each level";
        }
    }
}

TEST(OctreeQuery, asksAboutLeavesOnlyWhereToldSo) {
    const ScenePointer scene = wallBeforeSpheres();
    const InstanceOctree octree(*scene, 1);
    for (const char* ask : {"nodes", "leaves"}) {
        const CullerPointer culler = octreeQuery({{"ask", ask}, {"batch", "1"}});
        culler->build(*scene);
        const Culled frame = frameOf(*culler, standardView());
        size_t inner = 0, leaves = 0;
        for (const Decision& decision : frame.log.decisions)
            if (decision.line == 5) ++(octree.nodes()[decision.subject.number].leaf() ? leaves : inner);
        EXPECT_GT(leaves + inner, 0u);
        EXPECT_EQ(inner > 0, std::string(ask) == "nodes");
        EXPECT_EQ(double(leaves + inner), figure(frame, "queries"));
    }
}

TEST(OctreeQuery, boxAroundTheEyeOrAcrossTheNearPlaneIsNotAskedAbout) {
    // The sphere around the eye is drawn first; it hides the square at distance 1.5, but not what reaches before the near plane.
    const ScenePointer scene =
        sceneOf({sphereMesh(320), squareMesh(0.05f, -0.15f), sphereMesh(320), squareMesh(20, -1.5f)},
                {scaling(Vec3(1.4)), Mat4(1.0), translation({0, 0, -0.55}) * scaling(Vec3(0.5)), Mat4(1.0)});
    // Both sides are drawn: of the sphere around the eye only the back is seen.
    const CullerPointer culler = octreeQuery({{"batch", "1"}, {"facing", "two-sided"}});
    culler->build(*scene);
    const Culled frame = frameOf(*culler, standardView());
    EXPECT_EQ(drawn(frame), (std::set<uint32_t>{0, 1, 2}));
    for (const Command& command : frame.log.commands)
        if (const auto* asked = std::get_if<AskedBoxes>(&command))
            for (const EyeBox& box : asked->boxes) {
                EXPECT_LT(box.centre.z + box.halfExtent.z, -0.1);
            }
}

TEST(OctreeQuery, leavesOfSeveralObjectsAreDrawnWhole) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = octreeQuery({{"leaf", "1000"}});
    culler->build(*scene);
    EXPECT_EQ(drawn(frameOf(*culler, standardView())).size(), scene->instances().size());
    EXPECT_EQ(culler->structure().figures.at(2).value, 1.0) << "leaves";
}

TEST(OctreeQuery, answersAreUsedSoManyFramesLater) {
    const ScenePointer scene = wallBeforeSpheres();
    for (const size_t latency : {size_t{1}, size_t{2}}) {
        const CullerPointer culler = octreeQuery({{"latency", std::to_string(latency)}, {"batch", "1"}});
        culler->build(*scene);
        EXPECT_EQ(culler->promise(), Promise::Approximate);
        for (size_t frames = 0; frames < 6; ++frames) {
            const Culled frame = frameOf(*culler, standardView(), Recording::Off);
            const bool hides = frame.culledTriangles[size_t(Cause::Hidden)] > 0;
            EXPECT_EQ(hides, frames >= latency) << frames;
            for (const Command& command : frame.log.commands) {
                const auto* asked = std::get_if<AskedBoxes>(&command);
                EXPECT_TRUE(asked == nullptr || !asked->answered) << "nothing is waited for";
            }
        }
    }
}

TEST(OctreeQuery, treeWhyAndCountsTellWhatIsHidden) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = octreeQuery({{"batch", "1"}});
    culler->build(*scene);
    const Culled frame = frameOf(*culler, standardView());
    const StructureSnapshot tree = culler->snapshot(frame.log);
    size_t hiddenGroups = 0;
    for (const SnapshotNode& node : tree.nodes) {
        if (node.isGroup()) {
            hiddenGroups += node.culled && node.cause == Cause::Hidden ? 1 : 0;
            continue;
        }
        EXPECT_EQ(node.culled, !drawn(frame).contains(node.instance));
        if (node.culled) {
            EXPECT_EQ(node.cause, node.instance == 2 ? Cause::OutsideFrustum : Cause::Hidden);
        }
    }
    EXPECT_GT(hiddenGroups, 0u);
    const Bars bars = culler->built()->bars(frame.log).at(0);
    EXPECT_EQ(double(bars.bars[2].value), figure(frame, "queries"));
    EXPECT_EQ(double(bars.bars[3].value), figure(frame, "hidden_nodes"));
    EXPECT_EQ(bars.bars[4].value, 2u) << "drawn";
    const auto has = [&](uint32_t instance, const std::string& words) {
        for (const WhyStep& step : why(*culler->built(), frame.log, scene->firstTriangle(instance)))
            if (step.sentence.english().find(words) != std::string::npos) return true;
        return false;
    };
    EXPECT_TRUE(has(5, "hides")) << "a sphere behind the wall";
    EXPECT_TRUE(has(5, "is not given to OpenGL"));
    EXPECT_TRUE(has(0, "is given to OpenGL"));
    EXPECT_FALSE(has(0, "edge of the frustum"));
    EXPECT_TRUE(has(1, "counts as visible")) << "the first one is not asked about";
}

TEST(OctreeQuery, leavesCanBeAskedForInASmallScene) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = octreeQuery({{"leaf", "2"}});
    culler->build(*scene);
    const Culled frame = frameOf(*culler, standardView());
    EXPECT_FALSE(culler->built()->parts(frame.log).divides()) << "an order is asked of objects";
    const NamedParts parts = culler->built()->partsByLeaf(frame.log);
    ASSERT_EQ(parts.parts.size(), scene->instances().size());
    const InstanceOctree octree(*scene, 2);
    EXPECT_EQ(parts.places.size(), parts.leaves);
    for (uint32_t i = 0; i < parts.parts.size(); ++i) {
        EXPECT_EQ(parts.parts[i].object, i);
        EXPECT_EQ(parts.parts[i].name, scene->instances()[i].name);
        const InstanceOctree::Node& leaf = octree.nodes()[std::stoul(parts.places.at(parts.parts[i].place.value()))];
        EXPECT_TRUE(leaf.leaf());
        EXPECT_TRUE(std::ranges::count(octree.instancesOf(leaf), i) == 1);
        EXPECT_EQ(parts.partAt(*scene, scene->firstTriangle(i), Vec3(0.0)), i) << "by a click";
        EXPECT_EQ(parts.middleOf(*scene, i), scene->instanceBox(i).centre());
    }
    Prediction leaf{Prediction::Question::Place, Prediction::Items::Parts};
    leaf.toggle(5);
    leaf.place(*parts.parts[5].place);
    leaf.toggle(7);
    leaf.place(*parts.parts[7].place == 0 ? 1 : 0);
    const std::vector<PredictionRow> rows = answerTo(leaf, *scene, frame.log, parts);
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rightRows(rows), 1u);
    // Of more leaves than a lecturer would name only their number is known.
    const ScenePointer many = boxesBehindHalfAWall();
    culler->build(*many);
    const NamedParts unnamed = culler->built()->partsByLeaf({});
    EXPECT_TRUE(unnamed.places.empty() && unnamed.parts.empty());
    EXPECT_GT(unnamed.leaves, NamedParts::kMostLeaves);
}

}  // namespace
}  // namespace cullscope::test::octree_query_test
