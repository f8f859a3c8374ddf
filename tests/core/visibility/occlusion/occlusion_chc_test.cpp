#include <map>
#include <numeric>

#include "core/geometry/random.h"
#include "core/visibility/occlusion/chc_groups.h"
#include "core/visibility/why.h"
#include "tests/core/measure/crowd.h"
#include "tests/support/gl_environment.h"
#include "tests/support/wall_scene.h"

namespace cullscope::test::occlusion_chc_test {
namespace {

using occlusion::questionEnds;
using occlusion::tightBoxes;
using Settings = std::map<std::string, std::string>;
using testing::ElementsAre;
using testing::IsEmpty;

/// The original algorithm (Bittner, Wimmer, Piringer & Purgathofer 2004): one query for each group, and one for each visible leaf
/// in every frame.
const Settings kPlain{{"batch", "1"}, {"together", "1"}, {"retest", "1"}, {"depth", "0"}};

CullerPointer occlusionChc(const Settings& settings = {}) {
    ParameterSet parameters(findStrategy("occlusion-chc").info.parameters);
    for (const auto& [key, value] : settings) parameters.setFromText(key, value);
    return makeCuller("occlusion-chc", parameters);
}

View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {100, 100}}; }

Culled frameOf(Culler& culler, const View& view = standardView(), Recording recording = Recording::On) {
    return culler.cull(view, recording, &GlEnvironment::renderer());
}

TEST(OcclusionChc, oneQueryCoversNodesThatWillStayHidden) {
    const std::vector<double> sure(7, 1.0), unsure(4, 0.29), mixed{0.99, 0.99, 0.99, 0.3};
    EXPECT_THAT(questionEnds(sure, 50), ElementsAre(7));
    EXPECT_THAT(questionEnds(sure, 3), ElementsAre(3, 6, 7));
    EXPECT_THAT(questionEnds(sure, 1), ElementsAre(1, 2, 3, 4, 5, 6, 7));
    EXPECT_THAT(questionEnds(unsure, 50), ElementsAre(1, 2, 3, 4)) << "that a query fails costs more than it saves";
    EXPECT_THAT(questionEnds(mixed, 50), ElementsAre(3, 4));
    EXPECT_THAT(questionEnds({}, 50), IsEmpty());
    // Three nodes of p = 0.7325, which were hidden for one frame: 3 / (1 + 3 (1 - p^3)) = 1.064; of four it is 1.039.
    EXPECT_THAT(questionEnds(std::vector<double>(6, 0.99 - 0.7 * std::exp(-1.0)), 50), ElementsAre(3, 6));
}

TEST(OcclusionChc, tightBoxesHoldEveryObjectAndHaveNoMoreSurfaceThanTold) {
    const auto surface = [](const Box3& box) {
        const Vec3 edge = 2.0 * box.halfExtent();
        return 2.0 * (edge.x * edge.y + edge.y * edge.z + edge.z * edge.x);
    };
    size_t several = 0;
    for (uint64_t seed = 1; seed <= 40; ++seed) {
        const ScenePointer scene = crowd(seed);
        const InstanceOctree octree(*scene, 1 + uint32_t(seed % 5));
        for (uint32_t node = 0; node < octree.nodes().size(); ++node)
            for (const double area : {0.0, 1.0, 1.4, 100.0})
                for (const size_t depth : {size_t{0}, size_t{1}, size_t{3}}) {
                    const std::vector<Box3> boxes = tightBoxes(octree, *scene, node, depth, area);
                    double sum = 0.0;
                    for (const Box3& box : boxes) sum += surface(box);
                    const double own = surface(octree.nodes()[node].box);
                    ASSERT_LE(sum, std::max(area, 1.0) * own * (1.0 + 1e-12)) << "seed " << seed << " node " << node;
                    several += boxes.size() > 1 ? 1 : 0;
                    if (depth == 0) {
                        ASSERT_EQ(boxes.size(), 1u);
                    }
                    for (const uint32_t instance : octree.instancesOf(octree.nodes()[node])) {
                        const Box3& object = scene->instanceBox(instance);
                        ASSERT_TRUE(std::ranges::any_of(boxes,
                                                        [&](const Box3& box) {
                                                            return glm::all(glm::lessThanEqual(box.min, object.min)) &&
                                                                   glm::all(glm::greaterThanEqual(box.max, object.max));
                                                        }))
                            << "seed " << seed << " node " << node << " object " << instance << " depth " << depth << " area "
                            << area;
                    }
                }
    }
    EXPECT_GT(several, 1000u);
}

TEST(OcclusionChc, leavesOutWhatAWallHidesInEveryFrame) {
    const ScenePointer scene = wallBeforeSpheres();
    for (const Settings& settings : {Settings{}, kPlain, Settings{{"leaf", "3"}}, Settings{{"together", "1"}}}) {
        const CullerPointer culler = occlusionChc(settings);
        culler->build(*scene);
        EXPECT_EQ(culler->promise(), Promise::Conservative);
        for (int i = 0; i < 5; ++i) {
            const Culled frame = frameOf(*culler);
            EXPECT_TRUE(drawn(frame).contains(0) && drawn(frame).contains(1));
            const uint64_t hidden = frame.culledTriangles[size_t(Cause::Hidden)];
            EXPECT_GT(hidden, 0u) << i;
            EXPECT_EQ(frame.consideredTriangles + hidden + frame.culledTriangles[size_t(Cause::OutsideFrustum)],
                      scene->triangleCount());
        }
    }
}

TEST(OcclusionChc, standingViewNeedsOneQueryForAllThatIsHidden) {
    const ScenePointer scene = boxesBehindHalfAWall();
    std::map<std::string, double> queries;
    for (const auto& [name, settings] : std::map<std::string, Settings>{{"CHC++", {}}, {"CHC", kPlain}}) {
        const CullerPointer culler = occlusionChc(settings);
        culler->build(*scene);
        Culled frame;
        for (int i = 0; i < 40; ++i) frame = frameOf(*culler, standardView(), Recording::Off);
        queries[name] = figure(frame, "queries");
        if (name == "CHC") continue;
        EXPECT_EQ(figure(frame, "multi_queries"), 1.0);
        EXPECT_EQ(figure(frame, "split_queries"), 0.0);
        EXPECT_EQ(figure(frame, "queries"), 1.0 + figure(frame, "retest_queries"));
    }
    EXPECT_GT(queries["CHC"], 5.0 * queries["CHC++"]);
}

TEST(OcclusionChc, visibleLeavesAreAskedAboutAgainEverySoManyFrames) {
    const ScenePointer scene = boxesBehindHalfAWall();
    constexpr size_t kEvery = 8, kFrames = 40;
    std::map<std::string, std::vector<double>> asked;
    for (const char* phase : {"random", "same"}) {
        const CullerPointer culler = occlusionChc({{"retest", std::to_string(kEvery)}, {"phase", phase}});
        culler->build(*scene);
        for (size_t i = 0; i < kFrames; ++i)
            asked[phase].push_back(figure(frameOf(*culler, standardView(), Recording::Off), "retest_queries"));
    }
    const auto last = [&](const std::string& phase) { return std::span(asked[phase]).last(kEvery); };
    const double sum = std::accumulate(last("same").begin(), last("same").end(), 0.0);
    EXPECT_GT(sum, 100.0) << "visible boxes";
    EXPECT_EQ(std::accumulate(last("random").begin(), last("random").end(), 0.0), sum) << "each once in as many frames";
    EXPECT_EQ(std::ranges::max(last("same")), sum) << "all in one frame";
    EXPECT_LT(std::ranges::max(last("random")), 0.4 * sum) << "spread";
}

TEST(OcclusionChc, whatBecomesHiddenIsFoundAndWhatComesIntoSightIsDrawnInTheSameFrame) {
    const ScenePointer scene = boxesBehindHalfAWall();
    const CullerPointer culler = occlusionChc({{"retest", "3"}});
    culler->build(*scene);
    const auto from = [](double x) {
        return View({Vec3(x, 0, 0), Vec3(x, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {100, 100});
    };
    // To the right half of the boxes come into sight, to the left the wall hides most of them.
    size_t left = 0, right = 0;
    for (int i = 0; i < 8; ++i) left = drawn(frameOf(*culler, from(-3.0), Recording::Off)).size();
    right = drawn(frameOf(*culler, from(3.0), Recording::Off)).size();
    EXPECT_GT(right, 2 * left);
    size_t again = 0;
    for (int i = 0; i < 8; ++i) again = drawn(frameOf(*culler, from(-3.0), Recording::Off)).size();
    EXPECT_EQ(again, left);
}

TEST(OcclusionChc, lateAnswersAreUsedInTheNextFrameAndNothingIsWaitedFor) {
    const ScenePointer scene = boxesBehindHalfAWall();
    const CullerPointer late = occlusionChc({{"latency", "1"}}), waiting = occlusionChc();
    late->build(*scene);
    waiting->build(*scene);
    EXPECT_EQ(late->promise(), Promise::Approximate);
    EXPECT_EQ(frameOf(*late).culledTriangles[size_t(Cause::Hidden)], 0u) << "a view without a past hides nothing";
    std::set<uint32_t> expected;
    for (int i = 0; i < 12; ++i) {
        EXPECT_GT(frameOf(*late).culledTriangles[size_t(Cause::Hidden)], 0u);
        expected = drawn(frameOf(*waiting));
    }
    EXPECT_EQ(drawn(frameOf(*late)), expected) << "a standing view";
    for (const Command& command : frameOf(*late).log.commands)
        if (const auto* asked = std::get_if<AskedBoxes>(&command)) EXPECT_FALSE(asked->answered);
}

TEST(OcclusionChc, severalThatShowTogetherAreAskedAboutOneByOne) {
    const ScenePointer scene = boxesBehindHalfAWall();
    const CullerPointer culler = occlusionChc({{"retest", "1"}});
    culler->build(*scene);
    for (int i = 0; i < 6; ++i) (void)frameOf(*culler);
    const View beside({Vec3(1.5, 0, 0), Vec3(1.5, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 100}, {100, 100});
    const Culled frame = frameOf(*culler, beside);
    EXPECT_GT(figure(frame, "split_queries"), 0.0);
    std::set<uint32_t> split;
    size_t answered = 0;
    for (const Decision& decision : frame.log.decisions) {
        if (decision.line == 7) split.insert(decision.subject.number);
        if (decision.line == 6 && split.contains(decision.subject.number)) ++answered;
    }
    EXPECT_GT(split.size(), 1u);
    EXPECT_EQ(answered, split.size());
}

TEST(OcclusionChc, treeWhyAndCountsTellWhatIsHidden) {
    const ScenePointer scene = wallBeforeSpheres();
    const CullerPointer culler = occlusionChc();
    culler->build(*scene);
    for (int i = 0; i < 3; ++i) (void)frameOf(*culler);
    const Culled frame = frameOf(*culler);
    size_t hiddenGroups = 0;
    for (const SnapshotNode& node : culler->snapshot(frame.log).nodes) {
        if (node.isGroup())
            hiddenGroups += node.culled && node.cause == Cause::Hidden ? 1 : 0;
        else
            EXPECT_EQ(node.culled, !drawn(frame).contains(node.instance));
    }
    EXPECT_GT(hiddenGroups, 0u);
    const Bars bars = culler->built()->bars(frame.log).at(0);
    EXPECT_EQ(double(bars.bars[3].value), figure(frame, "hidden_nodes"));
    const auto has = [&](uint32_t instance, const std::string& words) {
        for (const WhyStep& step : why(*culler->built(), frame.log, scene->firstTriangle(instance)))
            if (step.sentence.english().find(words) != std::string::npos) return true;
        return false;
    };
    EXPECT_TRUE(has(5, "what is drawn hides all")) << "a sphere behind the wall";
    EXPECT_TRUE(has(5, "is not given to OpenGL"));
    EXPECT_TRUE(has(0, "visible in the frame before"));
    EXPECT_TRUE(has(0, "is given to OpenGL"));
}

}  // namespace
}  // namespace cullscope::test::occlusion_chc_test
