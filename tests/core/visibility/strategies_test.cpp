#include <numeric>

#include "core/mesh/parametric.h"
#include "core/visibility/registry.h"
#include "tests/support/gl_environment.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::strategies_test {
namespace {

constexpr int kScenes = 40;
constexpr int kViewsPerScene = 10;

StrategyPointer frustumBy(const char* box) {
    ParameterSet parameters(findStrategy("frustum").info.parameters);
    parameters.setFromText("box", box);
    return makeStrategy("frustum", parameters);
}

/// Calls `check(scene, view)` for views of random scenes, after building each of `strategies` for the scene.
template <typename Check>
void onRandomViews(const std::vector<Strategy*>& strategies, const Check& check) {
    for (uint64_t seed = 1; seed <= kScenes; ++seed) {
        const ScenePointer scene = randomScene(seed);
        for (Strategy* strategy : strategies) strategy->build(*scene);
        Random random(seed);
        for (int i = 0; i < kViewsPerScene; ++i) {
            const RandomView view = randomView(*scene, random);
            check(*scene, View(view.camera, view.viewport));
            if (testing::Test::HasFailure()) FAIL() << "scene seed " << seed << " view " << i;
        }
    }
}

std::vector<int> timesDrawn(const Verdict& verdict, const Scene& scene) {
    std::vector<int> times(scene.instances().size(), 0);
    for (const DrawRange& range : verdict.drawList.ranges) ++times[range.instance];
    return times;
}

/// The standard camera of the battery: at the origin looking down −z, 90°, near 0.1, far 10.
View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 10}, {100, 100}}; }

TEST(Strategies, countersAddUpToTheScene) {
    const StrategyPointer all = makeStrategy("all");
    const StrategyPointer backface = makeStrategy("backface");
    const StrategyPointer frustum = makeStrategy("frustum");
    const StrategyPointer length = frustumBy("length");
    const StrategyPointer oriented = frustumBy("oriented");
    const StrategyPointer octree = makeStrategy("frustum-octree");
    const std::vector<Strategy*> strategies{all.get(), backface.get(), frustum.get(), length.get(), oriented.get(), octree.get()};
    onRandomViews(strategies, [&](const Scene& scene, const View& view) {
        for (Strategy* strategy : strategies) {
            const Verdict verdict = strategy->cull(view);
            const uint64_t culled = std::accumulate(verdict.culledTriangles.begin(), verdict.culledTriangles.end(), uint64_t{0});
            EXPECT_EQ(verdict.consideredTriangles + culled, scene.triangleCount());
            EXPECT_EQ(verdict.consideredTriangles, verdict.drawList.triangleCount());
            EXPECT_EQ(verdict.drawList.facing, strategy->facing());
            EXPECT_THAT(timesDrawn(verdict, scene), testing::Each(testing::Le(1)));
        }
        EXPECT_EQ(all->cull(view).consideredTriangles, scene.triangleCount());
        EXPECT_EQ(backface->cull(view).consideredTriangles, scene.triangleCount());
    });
}

TEST(Strategies, lengthDrawsAllThatPVertexDraws) {
    const StrategyPointer frustum = frustumBy("p-vertex");
    const StrategyPointer length = frustumBy("length");
    uint64_t wasted = 0;
    onRandomViews({frustum.get(), length.get()}, [&](const Scene& scene, const View& view) {
        const std::vector<int> tight = timesDrawn(frustum->cull(view), scene);
        const std::vector<int> loose = timesDrawn(length->cull(view), scene);
        for (size_t i = 0; i < tight.size(); ++i) {
            EXPECT_LE(tight[i], loose[i]) << "instance " << i;
            wasted += size_t(loose[i] - tight[i]);
        }
    });
    EXPECT_GT(wasted, 0u) << "the views show no corner that the length test wastes";
}

TEST(Strategies, traceAgreesWithVerdict) {
    const StrategyPointer frustum = frustumBy("p-vertex");
    const StrategyPointer length = frustumBy("length");
    const StrategyPointer oriented = frustumBy("oriented");
    const StrategyPointer octree = makeStrategy("frustum-octree");
    const std::vector<Strategy*> strategies{frustum.get(), length.get(), oriented.get(), octree.get()};
    onRandomViews(strategies, [&](const Scene& scene, const View& view) {
        for (Strategy* strategy : strategies) {
            Trace trace;
            const std::vector<int> drawn = timesDrawn(strategy->cull(view, &trace), scene);
            std::vector<int> ended(drawn.size(), 0);
            const TraceEvent* lastTest = nullptr;
            for (const TraceEvent& event : trace.events) {
                ASSERT_LT(event.instance, drawn.size());
                EXPECT_EQ(ended[event.instance], 0) << "an event after the subject's end";
                if (event.kind == TraceEvent::Kind::TestedPlane || event.kind == TraceEvent::Kind::TestedAxes) {
                    lastTest = &event;
                    continue;
                }
                ++ended[event.instance];
                ASSERT_NE(lastTest, nullptr);
                ASSERT_EQ(lastTest->instance, event.instance) << "a decision without its tests";
                const bool culled = event.kind == TraceEvent::Kind::Culled;
                EXPECT_EQ(drawn[event.instance], culled ? 0 : 1);
                EXPECT_EQ(lastTest->containment == Containment::Outside, culled);
                EXPECT_TRUE(!culled || lastTest->distance < 0.0 || lastTest->kind == TraceEvent::Kind::TestedAxes);
                EXPECT_EQ(event.cause, Cause::OutsideFrustum);
            }
            EXPECT_THAT(ended, testing::Each(1));
        }
    });
}

TEST(Strategies, traceDoesNotChangeTheVerdict) {
    const StrategyPointer frustum = makeStrategy("frustum");
    const StrategyPointer octree = makeStrategy("frustum-octree");
    onRandomViews({frustum.get(), octree.get()}, [&](const Scene&, const View& view) {
        for (Strategy* strategy : {frustum.get(), octree.get()}) {
            Trace trace;
            EXPECT_EQ(strategy->cull(view, &trace).drawList.ranges, strategy->cull(view).drawList.ranges);
        }
    });
}

TEST(Strategies, traceOfBaselinesHasEveryInstance) {
    const ScenePointer scene = randomScene(3);
    for (const char* id : {"all", "backface"}) {
        const StrategyPointer strategy = makeStrategy(id);
        strategy->build(*scene);
        Trace trace;
        (void)strategy->cull(standardView(), &trace);
        ASSERT_EQ(trace.events.size(), scene->instances().size());
        for (size_t i = 0; i < trace.events.size(); ++i) {
            EXPECT_EQ(trace.events[i].kind, TraceEvent::Kind::Accepted);
            EXPECT_EQ(trace.events[i].instance, i);
        }
    }
}

TEST(Strategies, instanceWithoutTrianglesIsNotDrawn) {
    const ScenePointer scene = sceneOf({meshOf({{0, 0, -5}}, {}), squareMesh(1, -5)});
    for (const RegisteredStrategy& registered : strategies()) {
        const StrategyPointer strategy = makeStrategy(registered.info.id);
        strategy->build(*scene);
        const Verdict verdict = strategy->cull(standardView(), nullptr, &GlEnvironment::renderer());
        ASSERT_EQ(verdict.drawList.ranges.size(), 1u) << registered.info.id;
        EXPECT_EQ(verdict.drawList.ranges[0].instance, 1u);
    }
}

TEST(Strategies, emptySceneGivesAnEmptyList) {
    const Scene scene("empty", {}, {});
    for (const RegisteredStrategy& registered : strategies()) {
        const StrategyPointer strategy = makeStrategy(registered.info.id);
        strategy->build(scene);
        EXPECT_TRUE(strategy->cull(standardView(), nullptr, &GlEnvironment::renderer()).drawList.ranges.empty());
    }
}

TEST(Frustum, objectInViewIsDrawnAndObjectBesideItCulled) {
    const MeshPointer sphere = sphereMesh(80);
    const ScenePointer scene = copiesOf(sphere, {translation({0, 0, -5}), translation({0, 0, 5}), translation({9, 0, -5}),
                                                 translation({0, 0, -13}), translation({5.5, 0, -5}), scaling(Vec3(50.0))});
    const StrategyPointer frustum = makeStrategy("frustum");
    frustum->build(*scene);
    EXPECT_THAT(timesDrawn(frustum->cull(standardView()), *scene), testing::ElementsAre(1, 0, 0, 0, 1, 1));
}

TEST(Frustum, axisAlignedBoxThatOnlyItsLengthKeepsIsCulled) {
    // Flat along x, above the view: none of its corners is in the frustum, but its circumscribed sphere is (stability case 3, as
    // an object).
    const ScenePointer scene = sceneOf({boxMesh({-60, 9, -6}, {60, 11, -4})});
    const StrategyPointer tight = frustumBy("p-vertex");
    const StrategyPointer loose = frustumBy("length");
    tight->build(*scene);
    loose->build(*scene);
    EXPECT_TRUE(tight->cull(standardView()).drawList.ranges.empty());
    EXPECT_EQ(loose->cull(standardView()).drawList.ranges.size(), 1u);
}

TEST(Facing, autoFollowsWhetherMeshesAreClosed) {
    ParameterSet parameters(findStrategy("frustum").info.parameters);
    const auto resolved = [&](const Scene& scene) {
        const StrategyPointer strategy = makeStrategy("frustum", parameters);
        strategy->build(scene);
        return strategy->cull(standardView()).drawList.facing;
    };
    const ScenePointer closed = sceneOf({boxMesh(Vec3f(-1), Vec3f(1))});
    const ScenePointer open = sceneOf({boxMesh(Vec3f(-1), Vec3f(1)), squareMesh(1, 0)});
    EXPECT_EQ(resolved(*closed), Facing::Front);
    EXPECT_EQ(resolved(*open), Facing::TwoSided);
    parameters.setFromText("facing", "two-sided");
    EXPECT_EQ(resolved(*closed), Facing::TwoSided);
    parameters.setFromText("facing", "front");
    EXPECT_EQ(resolved(*open), Facing::Front);
}

TEST(Baselines, facingRulesAreThoseOfTheirNames) {
    const ScenePointer open = sceneOf({squareMesh(1, -5)});
    const StrategyPointer all = makeStrategy("all");
    const StrategyPointer backface = makeStrategy("backface");
    all->build(*open);
    backface->build(*open);
    EXPECT_EQ(all->facing(), Facing::TwoSided);
    EXPECT_EQ(all->promise(), Promise::Conservative);
    EXPECT_EQ(backface->facing(), Facing::Front);
    EXPECT_EQ(backface->referenceFacing(), Facing::TwoSided);
    EXPECT_EQ(backface->promise(), Promise::Approximate) << "an open mesh shows its back faces";
    const ScenePointer closed = sceneOf({boxMesh(Vec3f(-1), Vec3f(1))});
    backface->build(*closed);
    EXPECT_EQ(backface->promise(), Promise::Conservative);
}

}  // namespace
}  // namespace cullscope::test::strategies_test
