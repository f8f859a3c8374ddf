#include <map>
#include <numeric>

#include "core/mesh/parametric.h"
#include "core/scene/gallery/gallery.h"
#include "tests/support/culler.h"
#include "tests/support/decisions.h"
#include "tests/support/gl_environment.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::strategies_test {
namespace {

constexpr int kScenes = 40;
constexpr int kViewsPerScene = 10;

CullerPointer frustumBy(const char* box) {
    ParameterSet parameters(findStrategy("frustum").info.parameters);
    parameters.setFromText("box", box);
    return makeCuller("frustum", parameters);
}

/// Calls `check(scene, view)` for views of random scenes, after building each of `strategies` for the scene.
template <typename Check>
void onRandomViews(const std::vector<Culler*>& strategies, const Check& check) {
    for (uint64_t seed = 1; seed <= kScenes; ++seed) {
        const ScenePointer scene = randomScene(seed);
        for (Culler* strategy : strategies) strategy->build(*scene);
        Random random(seed);
        for (int i = 0; i < kViewsPerScene; ++i) {
            const RandomView view = randomView(*scene, random);
            check(*scene, View(view.camera, view.viewport));
            if (testing::Test::HasFailure()) FAIL() << "scene seed " << seed << " view " << i;
        }
    }
}

std::vector<int> timesDrawn(const Culled& frame, const Scene& scene) {
    std::vector<int> times(scene.instances().size(), 0);
    for (const DrawRange& range : frame.drawList.ranges) ++times[range.instance];
    return times;
}

/// The standard camera of the battery: at the origin looking down −z, 90°, near 0.1, far 10.
View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 10}, {100, 100}}; }

TEST(Strategies, countersAddUpToTheScene) {
    const CullerPointer all = makeCuller("all");
    const CullerPointer backface = makeCuller("backface");
    const CullerPointer frustum = makeCuller("frustum");
    const CullerPointer length = frustumBy("length");
    const CullerPointer oriented = frustumBy("oriented");
    const CullerPointer octree = makeCuller("frustum-octree");
    const std::vector<Culler*> strategies{all.get(), backface.get(), frustum.get(), length.get(), oriented.get(), octree.get()};
    onRandomViews(strategies, [&](const Scene& scene, const View& view) {
        for (Culler* strategy : strategies) {
            const Culled frame = strategy->cull(view);
            const uint64_t culled = std::accumulate(frame.culledTriangles.begin(), frame.culledTriangles.end(), uint64_t{0});
            EXPECT_EQ(frame.consideredTriangles + culled, scene.triangleCount());
            EXPECT_EQ(frame.consideredTriangles, frame.drawList.triangleCount());
            EXPECT_EQ(frame.drawList.facing, strategy->facing());
            EXPECT_THAT(timesDrawn(frame, scene), testing::Each(testing::Le(1)));
        }
        EXPECT_EQ(all->cull(view).consideredTriangles, scene.triangleCount());
        EXPECT_EQ(backface->cull(view).consideredTriangles, scene.triangleCount());
    });
}

TEST(Strategies, lengthDrawsAllThatPVertexDraws) {
    const CullerPointer frustum = frustumBy("p-vertex");
    const CullerPointer length = frustumBy("length");
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

/// Every subject ends once, after its tests, with what they found; every object that is drawn ends so by itself, and every other
/// one by itself or with its group.
void expectDecisionsFit(const Culled& frame, const Scene& scene) {
    const std::vector<int> drawn = timesDrawn(frame, scene);
    std::vector<int> culled(drawn.size(), 0), kept(drawn.size(), 0);
    std::map<std::pair<Subject::Kind, uint32_t>, const Decision*> outside;  // by subject
    for (const Decision& decision : frame.log.decisions) {
        const bool ofObject = decision.subject.kind == Subject::Kind::Object;
        if (ofObject) {
            ASSERT_LT(decision.subject.number, drawn.size());
            EXPECT_EQ(culled[decision.subject.number] + kept[decision.subject.number], 0) << "a decision after the end";
        }
        if (decision.outcome == Decision::Outcome::Open) {
            if (decision.containment == Containment::Outside)
                outside[{decision.subject.kind, decision.subject.number}] = &decision;
            continue;
        }
        const auto test = outside.find({decision.subject.kind, decision.subject.number});
        EXPECT_EQ(decision.outcome == Decision::Outcome::Culled, test != outside.end()) << "the tests decide";
        if (decision.outcome == Decision::Outcome::Culled) {
            ASSERT_NE(test, outside.end()) << "a decision without its tests";
            EXPECT_TRUE(test->second->distance() < 0.0 || !test->second->plane);
            EXPECT_EQ(decision.cause, Cause::OutsideFrustum);
            forObjectsOf(frame.log, decision, [&](uint32_t instance) { ++culled[instance]; });
        } else if (ofObject) {
            ++kept[decision.subject.number];
        }
    }
    EXPECT_EQ(kept, drawn);
    for (size_t i = 0; i < drawn.size(); ++i) EXPECT_EQ(culled[i], 1 - drawn[i]) << "instance " << i;
}

TEST(Strategies, decisionsAgreeWithWhatIsDrawn) {
    const CullerPointer frustum = frustumBy("p-vertex");
    const CullerPointer length = frustumBy("length");
    const CullerPointer oriented = frustumBy("oriented");
    const CullerPointer octree = makeCuller("frustum-octree");
    const std::vector<Culler*> strategies{frustum.get(), length.get(), oriented.get(), octree.get()};
    onRandomViews(strategies, [&](const Scene& scene, const View& view) {
        for (Culler* strategy : strategies) expectDecisionsFit(strategy->cull(view, Recording::On), scene);
    });
}

TEST(Strategies, objectThatFrustumTestsAloneIsTestedByItself) {
    const CullerPointer frustum = makeCuller("frustum");
    onRandomViews({frustum.get()}, [&](const Scene& scene, const View& view) {
        const FrameLog log = frustum->cull(view, Recording::On).log;
        std::vector<size_t> planes(scene.instances().size(), 0);
        for (const Decision& decision : log.decisions) {
            ASSERT_EQ(decision.subject.kind, Subject::Kind::Object);
            if (isPlaneTest(decision)) ++planes[decision.subject.number];
            // The sphere and the box of a kept object were tested against all six.
            EXPECT_TRUE(decision.outcome != Decision::Outcome::Drawn ||
                        planes[decision.subject.number] == 2 * kFrustumPlaneCount);
        }
        EXPECT_THAT(planes, testing::Each(testing::Ge(1u)));
    });
}

TEST(Strategies, baselinesSayThatEveryInstanceIsDrawn) {
    const ScenePointer scene = randomScene(3);
    for (const char* id : {"all", "backface"}) {
        const CullerPointer strategy = makeCuller(id);
        strategy->build(*scene);
        const FrameLog log = strategy->cull(standardView(), Recording::On).log;
        ASSERT_EQ(log.decisions.size(), scene->instances().size());
        for (uint32_t i = 0; i < log.decisions.size(); ++i) {
            EXPECT_EQ(log.decisions[i].outcome, Decision::Outcome::Drawn);
            EXPECT_EQ(log.decisions[i].subject, Subject::ofObject(i));
        }
    }
}

TEST(Strategies, instanceWithoutTrianglesIsNotDrawn) {
    const ScenePointer scene = sceneOf({meshOf({{0, 0, -5}}, {}), squareMesh(1, -5)});
    for (const RegisteredStrategy& registered : strategies()) {
        const CullerPointer strategy = makeCuller(registered.info.id);
        strategy->build(*scene);
        const Culled frame = strategy->cull(standardView(), &GlEnvironment::renderer());
        ASSERT_EQ(frame.drawList.ranges.size(), 1u) << registered.info.id;
        EXPECT_EQ(frame.drawList.ranges[0].instance, 1u);
    }
}

TEST(Strategies, emptySceneGivesAnEmptyList) {
    const Scene scene("empty", {}, {});
    for (const RegisteredStrategy& registered : strategies()) {
        const CullerPointer strategy = makeCuller(registered.info.id);
        strategy->build(scene);
        EXPECT_TRUE(strategy->cull(standardView(), &GlEnvironment::renderer()).drawList.ranges.empty());
    }
}

TEST(Frustum, objectInViewIsDrawnAndObjectBesideItCulled) {
    const MeshPointer sphere = sphereMesh(80);
    const ScenePointer scene = copiesOf(sphere, {translation({0, 0, -5}), translation({0, 0, 5}), translation({9, 0, -5}),
                                                 translation({0, 0, -13}), translation({5.5, 0, -5}), scaling(Vec3(50.0))});
    const CullerPointer frustum = makeCuller("frustum");
    frustum->build(*scene);
    EXPECT_THAT(timesDrawn(frustum->cull(standardView()), *scene), testing::ElementsAre(1, 0, 0, 0, 1, 1));
}

TEST(Frustum, axisAlignedBoxThatOnlyItsLengthKeepsIsCulled) {
    // Flat along x, above the view: none of its corners is in the frustum, but its circumscribed sphere is (stability case 3, as
    // an object).
    const ScenePointer scene = sceneOf({boxMesh({-60, 9, -6}, {60, 11, -4})});
    const CullerPointer tight = frustumBy("p-vertex");
    const CullerPointer loose = frustumBy("length");
    tight->build(*scene);
    loose->build(*scene);
    EXPECT_TRUE(tight->cull(standardView()).drawList.ranges.empty());
    EXPECT_EQ(loose->cull(standardView()).drawList.ranges.size(), 1u);
}

TEST(Facing, autoFollowsWhetherMeshesAreClosed) {
    ParameterSet parameters(findStrategy("frustum").info.parameters);
    const auto resolved = [&](const Scene& scene) {
        const CullerPointer strategy = makeCuller("frustum", parameters);
        strategy->build(scene);
        return strategy->cull(standardView()).drawList.facing;
    };
    const ScenePointer closed = sceneOf({boxMesh(Vec3f(-1), Vec3f(1))});
    const ScenePointer mixed = sceneOf({boxMesh(Vec3f(-1), Vec3f(1)), squareMesh(1, 0)});
    const ScenePointer open = sceneOf({squareMesh(1, 0), squareMesh(1, 1)});
    EXPECT_EQ(resolved(*closed), Facing::Front);
    EXPECT_EQ(resolved(*mixed), Facing::ByObject);
    EXPECT_EQ(resolved(*open), Facing::TwoSided);
    EXPECT_EQ(facingOf(*mixed, 0, Facing::ByObject), Facing::Front);
    EXPECT_EQ(facingOf(*mixed, 1, Facing::ByObject), Facing::TwoSided);
    parameters.setFromText("facing", "two-sided");
    EXPECT_EQ(resolved(*closed), Facing::TwoSided);
    parameters.setFromText("facing", "front");
    EXPECT_EQ(resolved(*open), Facing::Front);
}

TEST(Baselines, facingRulesAreThoseOfTheirNames) {
    const ScenePointer open = sceneOf({squareMesh(1, -5)});
    const CullerPointer all = makeCuller("all");
    const CullerPointer backface = makeCuller("backface");
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

TEST(Baselines, backFacesOfMeshesWithPocketsThatAreInsideOutMayBeSeen) {
    const CullerPointer backface = makeCuller("backface");
    const ScenePointer scene = galleryScene("gallery/case-35-inside-out");
    ASSERT_TRUE(scene->frontFacesSuffice()) << "closed, consistently oriented, and more of it outward";
    backface->build(*scene);
    EXPECT_EQ(backface->promise(), Promise::Approximate);
    // Two objects that cross: each hides its own back faces.
    const ScenePointer crossing = sceneOf({boxMesh(Vec3f(-1), Vec3f(1)), boxMesh(Vec3f(0), Vec3f(2))});
    backface->build(*crossing);
    EXPECT_EQ(backface->promise(), Promise::Conservative);
}

}  // namespace
}  // namespace cullscope::test::strategies_test
