// The causes that `clusters` gives for what it leaves out, checked triangle by triangle, and what it builds.
#include <gmock/gmock.h>

#include <tbb/global_control.h>

#include "core/scene/eye_triangle.h"
#include "core/visibility/left_out_triangles.h"
#include "core/visibility/scene_clusters.h"
#include "core/visibility/structure_store.h"
#include "core/visibility/why.h"
#include "tests/support/culler.h"
#include "tests/support/gl_environment.h"
#include "tests/support/lossless_scenes.h"

namespace cullscope::test::clusters_test {
namespace {

View around(const Scene& scene, Random& random, double fovyDegrees = 40) {
    const Sphere& sphere = scene.instanceSphere(0);
    const Vec3 eye = sphere.centre + sphere.radius * random.between(1.1, 6.0) * random.direction();
    return {{eye, sphere.centre + 0.5 * sphere.radius * random.direction(), random.direction(), Angle::fromDegrees(fovyDegrees),
             1e-3 * sphere.radius, 100 * sphere.radius},
            {300, 200}};
}

CullerPointer clustersOf(const Scene& scene, const std::vector<std::pair<const char*, const char*>>& parameters) {
    CullerPointer strategy = strategyWith("clusters", parameters);
    strategy->build(scene);
    return strategy;
}

/// Bodies of several clusters in rows, mirrored and flattened ones among them.
ScenePointer rows() {
    std::vector<Mat4> places;
    for (int i = 0; i < 36; ++i)
        places.push_back(translation({3.0 * (i % 6), 0.0, -3.0 * (i / 6)}) *
                         scaling({i % 3 == 0 ? -1.0 : 1.0, 1.0, i % 4 == 1 ? 0.2 : 1.0}));
    return copiesOf(starMesh(4, 5'000), places);
}

TEST(Clusters, causeOfALeftOutClusterIsTrueOfItsTriangles) {
    std::array<uint64_t, kCauseCount> judged{};
    const std::vector<MeshPointer> meshes{starMesh(7, 16'000), bumpyMesh(3, 16'000, 0.4), knotMesh(4'000), bowlMesh(4'000)};
    for (size_t m = 0; m < meshes.size(); ++m) {
        Random random(m + 1);
        const Mat4 place = m % 2 == 0 ? scaling({-1, 1, 1}) : rotation({1, 2, 3}, 1.0) * scaling({1, 1, 0.4});
        const ScenePointer scene = sceneOf({meshes[m]}, {place});
        const CullerPointer strategy =
            clustersOf(*scene, {{"facing", "front"}, {"size", m < 2 ? "64" : "128"}, {"occlusion", "none"}});
        for (int i = 0; i < 12; ++i) {
            const View view = around(*scene, random);
            const Culled frame = strategy->cull(view, Recording::On);
            const InstanceFromEye instance(*scene, 0, view.eye());
            for (const Decision& cluster : frame.log.decisions) {
                if (cluster.subject.kind != Subject::Kind::Cell || cluster.outcome != Decision::Outcome::Culled) continue;
                for (uint32_t p = cluster.places.first; p < cluster.places.first + cluster.places.count; ++p) {
                    const uint64_t triangle = frame.drawList.triangleAt(0, p);
                    ++judged[size_t(cluster.cause)];
                    const std::array<Vec3, 3> corners = instance.corners(triangle);
                    const bool outside = std::ranges::any_of(view.frustum().planes, [&](const Plane& plane) {
                        return std::ranges::all_of(corners, [&](const Vec3& corner) { return plane.distance(corner) < 0.0; });
                    });
                    EXPECT_TRUE(cluster.cause == Cause::OutsideFrustum ? outside : instance.facesAway(triangle))
                        << "mesh " << m << " view " << i << " triangle " << triangle << ": " << causeName(cluster.cause);
                }
            }
        }
    }
    EXPECT_GT(judged[size_t(Cause::OutsideFrustum)], 1000u);
    EXPECT_GT(judged[size_t(Cause::BackFacing)], 1000u);
    EXPECT_EQ(judged[size_t(Cause::Hidden)], 0u);
}

TEST(Clusters, everyTriangleIsDrawnOrCounted) {
    const ScenePointer scene = rows();
    const CullerPointer strategy = clustersOf(*scene, {});
    Random random(11);
    uint64_t drawn = 0, culled = 0, oneByOne = 0;
    for (int i = 0; i < 30; ++i) {
        const Culled frame = strategy->cull(around(*scene, random, 60));
        uint64_t left = 0;
        for (const uint64_t count : frame.culledTriangles) left += count;
        EXPECT_EQ(left + frame.consideredTriangles, scene->triangleCount());
        EXPECT_EQ(frame.parts[0].culledTriangles, frame.culledTriangles[size_t(Cause::OutsideFrustum)]);
        EXPECT_EQ(frame.parts[1].culledTriangles + frame.parts[3].culledTriangles,
                  frame.culledTriangles[size_t(Cause::BackFacing)] + frame.culledTriangles[size_t(Cause::NoSample)]);
        oneByOne += frame.parts[3].culledTriangles;
        drawn += frame.consideredTriangles;
        culled += left;
    }
    EXPECT_GT(drawn, scene->triangleCount());
    EXPECT_GT(culled, scene->triangleCount());
    EXPECT_GT(oneByOne, scene->triangleCount() / 10);
}

TEST(Clusters, trianglesThatAreLeftOutOneByOneShowNothing) {
    // In pictures of few pixels; both sides drawn and front sides alone.
    const ScenePointer scene = rows();
    Renderer& renderer = GlEnvironment::renderer();
    const SceneBuffers buffers(scene, Upload::Vbo);
    uint64_t away = 0, withoutSample = 0;
    for (const char* facing : {"two-sided", "front"}) {
        const CullerPointer strategy = clustersOf(*scene, {{"facing", facing}}),
                            without = clustersOf(*scene, {{"facing", facing}, {"samples", "false"}});
        Random random(5);
        for (int i = 0; i < 20; ++i) {
            const View view(around(*scene, random, 60).camera(), {160, 120});
            const Culled frame = strategy->cull(view, Recording::On, &renderer), all = without->cull(view);
            EXPECT_LE(frame.consideredTriangles, all.consideredTriangles);
            Framebuffer target(view.viewport()), whole(view.viewport());
            renderer.draw(buffers, view, frame.log, target);
            renderer.draw(buffers, view, everything(*scene, frame.drawList.facing), whole);
            ASSERT_EQ(target.readDepth(), whole.readDepth()) << facing << " view " << i;
            forEachLeftOut(frame.log, [&](uint32_t instance, const LeftOutTriangles& triangles) {
                away += triangles.count(Cause::BackFacing);
                withoutSample += triangles.count(Cause::NoSample);
                if (triangles.runs.empty() || i > 0) return;
                // Why says it of the triangle itself.
                const LeftOutTriangles::Run& run = triangles.runs.front();
                const uint32_t own = frame.drawList.triangleAt(scene->instances()[instance].mesh, run.places.first);
                const auto steps = why(*strategy->built(), frame.log, scene->firstTriangle(instance) + own);
                const std::string& sentence = decidingStep(steps)->sentence.text;
                EXPECT_THAT(sentence, testing::HasSubstr(run.cause == Cause::NoSample ? "No pixel centre" : "faces away"));
            });
        }
    }
    EXPECT_GT(away, 10'000u);
    EXPECT_GT(withoutSample, 10'000u);
}

TEST(Clusters, conesAreUsedOnlyWhereBackSidesAreNotDrawn) {
    const auto withCones = [](const MeshPointer& mesh, const char* facing, const char* cones) {
        const ScenePointer scene = sceneOf({mesh});
        const View view({{0, 0, 5}, Vec3(0.0), {0, 1, 0.1}, Angle::fromDegrees(40), 0.1, 100}, {200, 200});
        return clustersOf(*scene, {{"facing", facing}, {"cones", cones}, {"samples", "false"}})
                   ->cull(view)
                   .culledTriangles[size_t(Cause::BackFacing)] > 0;
    };
    const MeshPointer star = starMesh(2, 8'000);
    EXPECT_TRUE(withCones(star, "auto", "true"));
    EXPECT_FALSE(withCones(star, "auto", "false"));
    EXPECT_FALSE(withCones(star, "two-sided", "true"));
    EXPECT_FALSE(withCones(openBowlMesh(8'000), "auto", "true")) << "open: both sides are drawn";
    EXPECT_FALSE(withCones(changed(*star, kStay, [](size_t i) { return i % 5 == 0; }), "auto", "true")) << "inconsistent";
}

TEST(Clusters, parallelViewIsCulledByPlanesAlone) {
    const ScenePointer scene = sceneOf({starMesh(2, 8'000)});
    Camera camera{{0, 0, 5}, {0.9, 0, 0}, {0, 1, 0}, Angle::fromDegrees(10), 0.1, 100};
    camera.projection = ProjectionKind::Parallel;
    const Culled frame = clustersOf(*scene, {})->cull(View(camera, {200, 200}));
    EXPECT_EQ(frame.culledTriangles[size_t(Cause::BackFacing)], 0u);
    EXPECT_EQ(frame.consideredTriangles + frame.culledTriangles[size_t(Cause::OutsideFrustum)], scene->triangleCount());
}

TEST(Clusters, answerDoesNotDependOnRecordingOrTheThreads) {
    const ScenePointer scene = rows();
    const CullerPointer strategy = clustersOf(*scene, {});
    Random random(3);
    for (int i = 0; i < 10; ++i) {
        const View view = around(*scene, random, 70);
        const Culled plain = strategy->cull(view);
        EXPECT_EQ(strategy->cull(view, Recording::On).drawList.ranges, plain.drawList.ranges);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        EXPECT_EQ(strategy->cull(view).drawList.ranges, plain.drawList.ranges);
    }
}

TEST(Clusters, instancesOfAMeshShareItsClusters) {
    const MeshPointer star = starMesh(4, 5'000);
    const SceneClusters one(*sceneOf({star}), 128, {});
    const SceneClusters many(*rows(), 128, {});
    EXPECT_EQ(one.bytes(), many.bytes());
    EXPECT_EQ(many.meshes.size(), 1u);
    EXPECT_GE(many.meshes.front()->clusterCount(), 5'000u / 128);
}

TEST(Clusters, hierarchyIsNotOpenedWhereNothingIsDecided) {
    // A mesh of many clusters, wholly in view from all sides: one node; partly in view: far fewer nodes than clusters.
    const ScenePointer scene = sceneOf({starMesh(9, 100'000)});
    const CullerPointer strategy = clustersOf(*scene, {{"facing", "two-sided"}, {"occlusion", "none"}});
    const auto visited = [&](const Vec3& target) {
        return strategy->cull(View({{0, 0, 8}, target, {0, 1, 0}, Angle::fromDegrees(30), 0.1, 100}, {300, 300})).nodesVisited;
    };
    EXPECT_LE(visited({0, 0, 0}), 3u);
    EXPECT_LT(visited({2.2, 0, 0}), SceneClusters(*scene, 128, {}).meshes.front()->clusterCount() / 2);
    EXPECT_GT(visited({2.2, 0, 0}), 20u);
}

TEST(Clusters, whyOfATriangleNamesItsClustersTests) {
    const ScenePointer scene = sceneOf({starMesh(2, 8'000)});
    StructureStore store;
    const BuiltStrategyPointer strategy =
        buildStrategy("clusters", ParameterSet(findStrategy("clusters").info.parameters), scene, store);
    const View view({{0, 0, 5}, Vec3(0.0), {0, 1, 0.1}, Angle::fromDegrees(40), 0.1, 100}, {200, 200});
    FrameContext frame(*scene, view, true);
    strategy->draw(frame, *strategy->begin());
    const FrameLog log = frame.take();
    const auto culled = std::ranges::find_if(log.decisions, [](const Decision& decision) {
        return decision.outcome == Decision::Outcome::Culled && decision.cause == Cause::BackFacing;
    });
    ASSERT_NE(culled, log.decisions.end());
    const uint64_t triangle = triangleAt(log.order.get(), 0, culled->places.first);
    const std::vector<WhyStep> steps = why(*strategy, log, triangle);
    const WhyStep* deciding = decidingStep(steps);
    ASSERT_NE(deciding, nullptr);
    EXPECT_THAT(deciding->sentence.english(), testing::HasSubstr("have the eye behind them"));
}

}  // namespace
}  // namespace cullscope::test::clusters_test
