#include "core/mesh/parametric.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/plane_distances.h"
#include "tests/support/culler.h"
#include "tests/support/decisions.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

// The cases of the battery of extremes keep their numbers: camera at the origin looking down −z, 90°, aspect 1, near 0.1, far 10
// unless stated.

namespace cullscope::test::frustum_octree_test {
namespace {

View standardView() { return {{Vec3(0.0), Vec3(0, 0, -1), Vec3(0, 1, 0), Angle::fromDegrees(90), 0.1, 10}, {100, 100}}; }

CullerPointer octree(const char* refine) {
    ParameterSet parameters(findStrategy("frustum-octree").info.parameters);
    parameters.setFromText("refine", refine);
    return makeCuller("frustum-octree", parameters);
}

std::vector<uint32_t> drawn(Culler& strategy, const View& view) {
    std::vector<uint32_t> instances;
    for (const DrawRange& range : strategy.cull(view).drawList.ranges) instances.push_back(range.instance);
    std::sort(instances.begin(), instances.end());
    return instances;
}

/// Copies of a mesh in a grid of n × n on the ground.
ScenePointer grid(int n, double spacing) {
    std::vector<Mat4> places;
    for (int i = 0; i < n * n; ++i) places.push_back(translation({spacing * (i % n), 0, -spacing * (i / n)}));
    return copiesOf(sphereMesh(80), places);
}

TEST(FrustumOctree, cases1And2ObjectBesideAnEdgeIsCulledWithRefinement) {
    const ScenePointer scene = sceneOf({sphereMesh(2000), boxMesh({15, -5, -30}, {40, 5, -9.5f}), boxMesh(Vec3f(-1), Vec3f(1))},
                                       {translation({13, 13, -11}) * scaling(Vec3(1.5)), Mat4(1.0), translation({0, 0, -5})});
    const CullerPointer refined = octree("true"), plain = octree("false");
    refined->build(*scene);
    plain->build(*scene);
    EXPECT_THAT(drawn(*plain, standardView()), testing::ElementsAre(0, 1, 2)) << "the plane tests' false positives";
    EXPECT_THAT(drawn(*refined, standardView()), testing::ElementsAre(2));
}

TEST(FrustumOctree, case22ObjectAroundTheEyeOrBeyondFarIsDrawn) {
    const ScenePointer scene = sceneOf({boxMesh({-1, -1, -3}, {1, 1, 3}), boxMesh(Vec3f(-1000), Vec3f(1000))});
    const CullerPointer strategy = octree("true");
    strategy->build(*scene);
    EXPECT_THAT(drawn(*strategy, standardView()), testing::ElementsAre(0, 1));
}

TEST(FrustumOctree, refinementDrawsLessThanPlanes) {
    uint64_t parted = 0;
    for (uint64_t seed = 1; seed <= 60; ++seed) {
        const ScenePointer scene = randomScene(seed);
        const CullerPointer refined = octree("true"), plain = octree("false");
        refined->build(*scene);
        plain->build(*scene);
        Random random(seed);
        for (int i = 0; i < 20; ++i) {
            const RandomView sample = randomView(*scene, random);
            const View view(sample.camera, sample.viewport);
            const std::vector<uint32_t> few = drawn(*refined, view), many = drawn(*plain, view);
            EXPECT_TRUE(std::includes(many.begin(), many.end(), few.begin(), few.end())) << "seed " << seed << " view " << i;
            parted += many.size() - few.size();
        }
    }
    EXPECT_GT(parted, 0u);
}

TEST(FrustumOctree, whatWasSeenBeforeChangesNothing) {
    const ScenePointer scene = grid(40, 3.0);
    const CullerPointer used = octree("true");
    used->build(*scene);
    Random random(7);
    for (int i = 0; i < 60; ++i) {
        Camera camera;
        camera.eye = {random.between(-10, 130), random.between(0, 20), random.between(-130, 10)};
        camera.target = camera.eye + random.direction();
        const View view(camera, {200, 150});
        const CullerPointer fresh = octree("true");
        fresh->build(*scene);
        EXPECT_EQ(used->cull(view).drawList.ranges, fresh->cull(view).drawList.ranges) << "view " << i;
    }
}

TEST(FrustumOctree, planeThatFailedIsTestedFirstTheNextTime) {
    const ScenePointer scene = grid(60, 3.0);
    const InstanceOctree tree(*scene);
    LastFailedPlanes memory(tree.nodes().size(), scene->instances().size());
    Camera camera;
    camera.eye = {90, 2, 0};
    camera.target = {90, 0, -60};
    const View view(camera, {200, 150});
    const auto walk = [&](OctreeWalkCounters& counters) {
        FrameContext frame(*scene, view, false);
        return keptObjects(tree, frame, &counters, {true, &memory}).size();
    };
    OctreeWalkCounters first, second;
    const size_t kept = walk(first);
    EXPECT_EQ(walk(second), kept);
    EXPECT_EQ(second.objectsCulled, first.objectsCulled);
    EXPECT_EQ(second.nodesVisited, first.nodesVisited);
    EXPECT_LT(second.planesTested, first.planesTested);
}

TEST(FrustumOctree, objectsAreDrawnFromNearToFar) {
    const ScenePointer scene = grid(12, 3.0);
    const CullerPointer strategy = octree("true");
    strategy->build(*scene);
    Camera camera;
    camera.eye = {16, 3, 8};
    camera.target = {16, 0, -20};
    const View view(camera, {200, 150});
    double last = -1.0;
    const std::vector<DrawRange> ranges = strategy->cull(view).drawList.ranges;
    ASSERT_GT(ranges.size(), 30u);
    for (const DrawRange& range : ranges) {
        const Sphere& sphere = scene->instanceSphere(range.instance);
        const double distance = glm::length(sphere.centre - camera.eye) - sphere.radius;
        EXPECT_GE(distance, last);
        last = distance;
    }
}

TEST(FrustumOctree, whatIsSaidToBePartedByAxesIsOutsideNoPlane) {
    const ScenePointer scene = grid(40, 3.0);
    const CullerPointer strategy = octree("true");
    strategy->build(*scene);
    Random random(11);
    std::array<size_t, 2> byAxes{};  ///< objects and groups
    for (int i = 0; i < 400; ++i) {
        Camera camera;
        camera.eye = {random.between(-10, 130), random.between(0, 20), random.between(-130, 10)};
        camera.target = camera.eye + random.direction();
        camera.farDistance = 30;
        const View view(camera, {200, 150});
        const FrameLog log = strategy->cull(view, Recording::On).log;
        for (const Decision& decision : log.decisions) {
            if (!isAxisTest(decision) || decision.containment != Containment::Outside) continue;
            const bool ofGroup = decision.subject.kind == Subject::Kind::Node;
            ++byAxes[ofGroup ? 1 : 0];
            for (const Decision& other : log.decisions)
                EXPECT_FALSE(other.subject == decision.subject && other.plane && other.containment == Containment::Outside);
            if (ofGroup) continue;
            for (const PlaneDistance& plane : planeDistances(*scene, view, decision.subject.number))
                EXPECT_NE(plane.containment, Containment::Outside) << "view " << i << " instance " << decision.subject.number;
        }
    }
    EXPECT_GT(byAxes[0], 10u);
    EXPECT_GT(byAxes[1], 10u);
}

TEST(FrustumOctree, recordedWalkTestsWhatAMeasuredOneTests) {
    const ScenePointer scene = grid(20, 3.0);
    const InstanceOctree tree(*scene);
    LastFailedPlanes ofRecorded(tree.nodes().size(), scene->instances().size()), ofMeasured = ofRecorded;
    Random random(5);
    uint64_t byMemory = 0;
    for (int i = 0; i < 200; ++i) {
        Camera camera;
        camera.eye = {random.between(-10, 70), random.between(0, 20), random.between(-70, 10)};
        camera.target = camera.eye + random.direction();
        const View view(camera, {200, 150});
        const auto walk = [&](LastFailedPlanes* memory, bool recording) {
            FrameContext frame(*scene, view, recording);
            OctreeWalkCounters counters;
            (void)keptObjects(tree, frame, &counters, {true, memory});
            return std::pair(counters, frame.take());
        };
        const auto [recorded, log] = walk(&ofRecorded, true);
        const auto [measured, none] = walk(&ofMeasured, false);
        const auto [fresh, alone] = walk(nullptr, false);
        EXPECT_EQ(recorded.planesTested, measured.planesTested) << "view " << i;
        EXPECT_EQ(recorded.axesTested, measured.axesTested);
        EXPECT_EQ(recorded.nodesVisited, measured.nodesVisited);
        EXPECT_EQ(recorded.objectsTested, measured.objectsTested);
        EXPECT_EQ(recorded.objectsCulled, fresh.objectsCulled);
        EXPECT_EQ(uint64_t(std::ranges::count_if(log.decisions, isPlaneTest)), measured.planesTested) << "view " << i;
        EXPECT_EQ(uint64_t(std::ranges::count_if(log.decisions, isAxisTest)), measured.axesTested);
        byMemory += recorded.planesTested != fresh.planesTested ? 1 : 0;
    }
    EXPECT_GT(byMemory, 50u) << "the memory chose another order";
}

TEST(FrustumOctree, everyObjectIsInAGroup) {
    const ScenePointer scene = grid(12, 3.0);
    const CullerPointer strategy = octree("true");
    strategy->build(*scene);
    const Culled frame = strategy->cull(standardView(), Recording::On);
    const StructureSnapshot snapshot = strategy->snapshot(frame.log);
    size_t groups = 0, objects = 0;
    for (const SnapshotNode& node : snapshot.nodes) {
        ++(node.isGroup() ? groups : objects);
        EXPECT_TRUE(node.isGroup() || node.parent >= 0);
    }
    EXPECT_EQ(objects, scene->instances().size());
    EXPECT_GT(groups, 30u);
}

}  // namespace
}  // namespace cullscope::test::frustum_octree_test
