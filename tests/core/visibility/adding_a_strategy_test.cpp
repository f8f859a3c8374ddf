// The worked example of docs/adding-a-strategy.md, whose code the build takes from that page.
#include "core/visibility/example/nearest.h"

#include "core/mesh/parametric.h"
#include "core/visibility/overlay.h"
#include "core/visibility/why.h"
#include "tests/support/culler.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::adding_a_strategy_test {
namespace {

/// Five spheres in a row before the eye.
ScenePointer row() {
    std::vector<Mat4> places;
    for (int i = 0; i < 5; ++i) places.push_back(translation({0, 0, -5.0 * (i + 1)}));
    return copiesOf(sphereMesh(80), places);
}

View ahead() { return {{Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(45), 0.1, 100}, {64, 64}}; }

TEST(AddingAStrategy, exampleDrawsTheNearestAndSaysWhy) {
    const RegisteredStrategy strategy = example::nearest();
    ParameterSet parameters(strategy.info.parameters);
    parameters.setFromText("count", "2");
    Culler culler(strategy, parameters);
    const ScenePointer scene = row();
    culler.build(*scene);
    const Culled culled = culler.cull(ahead(), Recording::On);
    EXPECT_EQ(culled.drawList.ranges, (std::vector<DrawRange>{{0, 0, 240}, {1, 0, 240}}));
    EXPECT_EQ(culled.culledTriangles[size_t(Cause::TooSmall)], 3u * 80);
    const StructureSnapshot tree = culler.snapshot(culled.log);
    ASSERT_EQ(tree.nodes.size(), 5u);
    for (const SnapshotNode& node : tree.nodes) EXPECT_EQ(node.culled, node.instance >= 2);
    const std::vector<WhyStep> steps = why(*culler.built(), culled.log, scene->firstTriangle(3));
    const auto says = [&](const std::string& sentence) {
        return std::ranges::any_of(steps, [&](const WhyStep& step) { return step.sentence.english() == sentence; });
    };
    EXPECT_TRUE(says("It is number 4 by distance, 19 from the eye."));
    EXPECT_TRUE(says("The strategy leaves the object out: too small."));
    EXPECT_TRUE(says("The triangle is not given to OpenGL."));
}

TEST(AddingAStrategy, overlayOfTheExampleLeadsToEveryDrawnObject) {
    const RegisteredStrategy strategy = example::nearest();
    ASSERT_NE(strategy.info.show("sight-lines"), nullptr);
    ParameterSet parameters(strategy.info.parameters);
    parameters.setFromText("count", "3");
    Culler culler(strategy, parameters);
    const ScenePointer scene = row();
    culler.build(*scene);
    const Culled culled = culler.cull(ahead(), Recording::On);
    const DrawStyle style;
    const View viewing = ahead();
    const OverlayContext context{*scene, viewing, style, {}, Vec3f(1.0f)};
    const std::vector<OverlayLines> lines =
        strategy.strategy->overlay("sight-lines", context, *culler.built()->structure(), culled.log);
    ASSERT_EQ(lines.size(), 1u);
    ASSERT_EQ(lines.front().lines.size(), 3u);
    for (uint32_t i = 0; i < 3; ++i) {
        EXPECT_EQ(lines.front().lines[i].from, Vec3(0.0));
        EXPECT_EQ(lines.front().lines[i].to, scene->instanceSphere(i).centre);
    }
}

TEST(AddingAStrategy, exampleBuildsNothingWhenItsCountChanges) {
    const RegisteredStrategy strategy = example::nearest();
    StructureStore store;
    const ScenePointer scene = row();
    ParameterSet parameters(strategy.info.parameters);
    const BuiltStrategyPointer first = buildStrategy(strategy, parameters, scene, store);
    parameters.setFromText("count", "3");
    EXPECT_EQ(buildStrategy(strategy, parameters, scene, store)->structure(), first->structure());
    EXPECT_EQ(store.built(), 1u);
}

}  // namespace
}  // namespace cullscope::test::adding_a_strategy_test
