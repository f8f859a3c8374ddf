// What a recorded walk over groups of objects says, and the groups as boxes.

#include "core/geometry/random.h"
#include "tests/support/decisions.h"
#include "tests/support/grouped_frustum.h"
#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"
#include "tests/support/walked.h"

namespace cullscope::test::recorded_walk_test {
namespace {

/// Checks that every decision of a recorded walk is about what was tested there and then.
void expectSound(const Walked& walk, const InstanceOctree& octree, const Scene& scene, const View& view) {
    const Decision* test = nullptr;
    for (const Decision& decision : walk.log.decisions) {
        const bool ofGroup = decision.subject.kind == Subject::Kind::Node;
        if (decision.outcome == Decision::Outcome::Open) {
            test = &decision;
            EXPECT_NE(isPlaneTest(decision), isAxisTest(decision));
            EXPECT_GT(decision.margin(), 0.0);
            if (!decision.plane) continue;
            EXPECT_EQ(decision.containment == Containment::Outside, decision.distance() < -decision.margin());
            if (ofGroup) continue;
            const Plane& plane = view.frustum().planes[size_t(*decision.plane)];
            const OwnTest own = ownTest(plane, scene, decision.subject.number, view.eye());
            EXPECT_NEAR(decision.distance(), own.inner, own.margin) << "not of its own bounds";
            continue;
        }
        ASSERT_NE(test, nullptr);
        EXPECT_EQ(test->subject, decision.subject) << "an end without its test";
        EXPECT_EQ(test->containment == Containment::Outside, decision.outcome == Decision::Outcome::Culled);
        EXPECT_EQ(decision.cause, Cause::OutsideFrustum);
        if (!ofGroup) continue;
        const auto objects = octree.instancesOf(octree.nodes()[decision.subject.number]);
        EXPECT_TRUE(std::ranges::equal(walk.log.objectsOf(decision), objects));
    }
}

TEST(RecordedWalk, everyCulledObjectIsCulledOnceAndOnlyTestsThatWereMadeAreThere) {
    size_t byAxes = 0;
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const ScenePointer scene = randomScene(seed);
        const size_t objects = scene->instances().size();
        const InstanceOctree octree(*scene);
        Random random(seed);
        for (int i = 0; i < 20; ++i) {
            const RandomView sample = randomView(*scene, random);
            const View view(sample.camera, sample.viewport);
            const bool refine = i % 2 != 0;
            const Walked recorded = walked(octree, *scene, view, Recording::On, refine);
            const Walked plain = walked(octree, *scene, view, Recording::Off, refine);
            const Kept kept = byInstance(recorded.objects, objects);
            EXPECT_EQ(kept, byInstance(plain.objects, objects)) << "recording changes the answer";
            EXPECT_EQ(recorded.figures.planesTested, plain.figures.planesTested);
            EXPECT_TRUE(plain.log.decisions.empty());
            const std::vector<Decision>& decisions = recorded.log.decisions;
            EXPECT_EQ(uint64_t(std::ranges::count_if(decisions, isPlaneTest)), recorded.figures.planesTested);
            EXPECT_EQ(uint64_t(std::ranges::count_if(decisions, isAxisTest)), recorded.figures.axesTested);
            EXPECT_EQ(visitedGroups(recorded.log).size(), recorded.figures.nodesVisited);
            expectSound(recorded, octree, *scene, view);
            byAxes += recorded.figures.axesTested;
            const std::vector<int> culled = timesDecided(recorded.log, Decision::Outcome::Culled, objects);
            uint64_t triangles = 0;
            for (size_t instance = 0; instance < objects; ++instance) {
                EXPECT_EQ(culled[instance], kept[instance] ? 0 : 1) << "seed " << seed << " instance " << instance;
                triangles += kept[instance] ? 0 : scene->meshOf(instance).triangleCount();
            }
            EXPECT_EQ(triangles, recorded.figures.trianglesCulled);
        }
    }
    EXPECT_GT(byAxes, 100u);
}

TEST(RecordedWalk, objectDecidedWithItsGroupHasNoTests) {
    const ScenePointer scene = boxField(12, 1.5);
    const InstanceOctree octree(*scene);
    const View view({{3, 4, 3}, {5, 0, 2}, {0, 1, 0}, Angle::fromDegrees(50), 0.1, 100}, {64, 64});
    const FrameLog log = walked(octree, *scene, view, Recording::On).log;
    std::vector<int> tested(scene->instances().size(), 0), inGroups(tested.size(), 0);
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind == Subject::Kind::Object)
            tested[decision.subject.number] = 1;
        else
            for (const uint32_t instance : log.objectsOf(decision)) ++inGroups[instance];
    }
    for (size_t i = 0; i < tested.size(); ++i) EXPECT_EQ(tested[i] + inGroups[i], 1) << "object " << i;
    EXPECT_GT(std::ranges::count(tested, 1), 5);
    EXPECT_GT(std::ranges::count(inGroups, 1), 50);
}

TEST(RecordedWalk, boundIsTheOneThatDecided) {
    // Its stretched sphere extends farther than its box and has the larger margin; it lies in front of the near plane by a
    // distance between the two. The group of this one object has the box's margin.
    const double groupMargin = (0.9 + 10.0) * 0x1p-20;
    const ScenePointer scene =
        copiesOf(boxMesh(Vec3f(-1), Vec3f(1)), {translation({0, 0, -0.9 + 1.3 * groupMargin}) * scaling({10, 0.1, 0.1})});
    const View view({Vec3(0.0), {0, 0, -1}, {0, 1, 0}, Angle::fromDegrees(90), 1, 100}, {64, 64});
    const Walked walk = walked(InstanceOctree(*scene), *scene, view, Recording::On);
    EXPECT_EQ(walk.kept(), 0u);
    ASSERT_EQ(walk.log.decisions.size(), 6u) << "five planes and the end";
    const Decision &test = walk.log.decisions[4], &end = walk.log.decisions[5];
    EXPECT_EQ(test.plane, FrustumPlane::Near);
    EXPECT_GT(ownTest(view.frustum().planes[4], *scene, 0, view.eye()).margin, -test.distance());
    EXPECT_LT(test.distance(), -test.margin());
    EXPECT_EQ(end.subject, test.subject);
    EXPECT_THAT(walk.log.objectsOf(end), testing::ElementsAre(0));
}

TEST(GroupNodes, resultsAndPlacesFitThoseOfTheParents) {
    for (uint64_t seed = 1; seed <= 20; ++seed) {
        const ScenePointer scene = randomScene(seed);
        GroupedCuller strategy;
        strategy.build(*scene);
        Random random(seed);
        for (int i = 0; i < 10; ++i) {
            const RandomView sample = randomView(*scene, random);
            const Culled frame = strategy.cull(View(sample.camera, sample.viewport), Recording::On);
            const StructureSnapshot snapshot = strategy.snapshot(frame.log);
            const size_t objects = scene->instances().size();
            ASSERT_EQ(snapshot.nodes.size(), objects + strategy.octree().nodes().size());
            for (size_t n = 0; n < snapshot.nodes.size(); ++n) {
                const SnapshotNode& node = snapshot.nodes[n];
                EXPECT_EQ(node.isGroup(), n >= objects);
                EXPECT_EQ(node.culled, node.containment == Containment::Outside);
                EXPECT_EQ(node.culled, node.rejectedBy.has_value());
                if (node.parent < 0) {
                    EXPECT_EQ(n, objects) << "two roots";
                    continue;
                }
                const SnapshotNode& parent = snapshot.nodes[size_t(node.parent)];
                ASSERT_TRUE(parent.isGroup());
                EXPECT_TRUE(glm::all(glm::lessThanEqual(parent.box.min, node.box.min)));
                EXPECT_TRUE(glm::all(glm::greaterThanEqual(parent.box.max, node.box.max)));
                if (parent.culled) {
                    EXPECT_TRUE(node.culled && node.rejectedBy == parent.rejectedBy);
                } else if (parent.containment == Containment::Inside) {
                    EXPECT_FALSE(node.culled);
                }
            }
        }
    }
}

TEST(GroupNodes, testedAreThoseThatTheStreamSaysATestOf) {
    const ScenePointer scene = boxField(12, 1.5);
    GroupedCuller strategy;
    strategy.build(*scene);
    const View view({{3, 4, 3}, {5, 0, 2}, {0, 1, 0}, Angle::fromDegrees(50), 0.1, 100}, {64, 64});
    const FrameLog log = strategy.cull(view, Recording::On).log;
    // Also of the first entries: nothing that comes later counts.
    for (const size_t k : {size_t{0}, log.entries() / 4, log.entries() / 2, log.entries()}) {
        const FrameLog part = log.upTo(k);
        const std::vector<VisitedGroup> visited = visitedGroups(part);
        size_t groups = 0;
        for (const SnapshotNode& node : strategy.snapshot(part).nodes) {
            if (!node.isGroup()) continue;
            groups += node.tested ? 1 : 0;
            const auto is = [&](const VisitedGroup& group) { return group.node == node.number; };
            EXPECT_EQ(node.tested, std::ranges::any_of(visited, is)) << "group " << node.number << " of " << k;
        }
        EXPECT_EQ(groups, visited.size());
    }
}

TEST(GroupNodes, countsAddUp) {
    const ScenePointer scene = boxField(12, 1.5);
    GroupedCuller strategy;
    strategy.build(*scene);
    EXPECT_EQ(strategy.snapshot({}).nodes.size(), strategy.octree().nodes().size()) << "nothing was decided about an object";
    const View over({{0, 50, 1}, {0, 0, 0}, {0, 1, 0}, Angle::fromDegrees(60), 1, 1000}, {64, 64});
    const StructureSnapshot snapshot = strategy.snapshot(strategy.cull(over, Recording::On).log);
    std::vector<uint32_t> objects(snapshot.nodes.size(), 0);
    std::vector<uint64_t> triangles(snapshot.nodes.size(), 0);
    for (const SnapshotNode& node : snapshot.nodes) {
        EXPECT_FALSE(node.culled) << "all is in view";
        if (node.parent < 0) continue;
        objects[size_t(node.parent)] += node.objects;
        triangles[size_t(node.parent)] += node.triangles;
    }
    for (size_t n = 0; n < snapshot.nodes.size(); ++n) {
        if (!snapshot.nodes[n].isGroup()) continue;
        EXPECT_EQ(objects[n], snapshot.nodes[n].objects);
        EXPECT_EQ(triangles[n], snapshot.nodes[n].triangles);
    }
}

}  // namespace
}  // namespace cullscope::test::recorded_walk_test
