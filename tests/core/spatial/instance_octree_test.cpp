#include "core/spatial/instance_octree.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/geometry/random.h"
#include "tests/support/stopped_work.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::instance_octree_test {
namespace {

MeshPointer smallBox() { return boxMesh(Vec3f(-0.1f), Vec3f(0.1f)); }

bool holds(const Box3& outer, const Box3& inner) {
    return glm::all(glm::lessThanEqual(outer.min, inner.min)) && glm::all(glm::greaterThanEqual(outer.max, inner.max));
}

/// Checks a node's box, range, triangle count and links against its instances.
void checkNode(const InstanceOctree& octree, const Scene& scene, size_t number) {
    const InstanceOctree::Node& node = octree.nodes()[number];
    Box3 box;
    uint64_t triangles = 0;
    for (const uint32_t instance : octree.instancesOf(node)) {
        box.add(scene.instanceBox(instance));
        triangles += scene.meshOf(instance).triangleCount();
    }
    EXPECT_TRUE(box.min == node.box.min && box.max == node.box.max) << "the box of node " << number << " is not the smallest";
    EXPECT_EQ(node.triangles, triangles);
    EXPECT_LE(node.depth, InstanceOctree::kMaxDepth);
    if (node.leaf()) return;
    EXPECT_GE(node.childCount, 2) << "a node that divides nothing";
    uint32_t next = node.first;
    for (uint32_t i = node.firstChild; i < node.firstChild + node.childCount; ++i) {
        ASSERT_GT(i, number);
        const InstanceOctree::Node& child = octree.nodes()[i];
        EXPECT_EQ(child.parent, int32_t(number));
        EXPECT_EQ(child.first, next) << "the runs of children do not follow each other";
        EXPECT_EQ(child.depth, node.depth + 1);
        EXPECT_TRUE(holds(node.box, child.box));
        next += child.count;
    }
    EXPECT_EQ(next, node.first + node.count);
}

/// Checks that every instance with triangles is in exactly one leaf, and every node.
void check(const InstanceOctree& octree, const Scene& scene) {
    std::vector<int> leaves(scene.instances().size(), 0);
    for (size_t i = 0; i < octree.nodes().size(); ++i) {
        checkNode(octree, scene, i);
        if (!octree.nodes()[i].leaf()) continue;
        for (const uint32_t instance : octree.instancesOf(octree.nodes()[i])) ++leaves[instance];
    }
    for (size_t i = 0; i < leaves.size(); ++i) EXPECT_EQ(leaves[i], scene.meshOf(i).triangleCount() > 0 ? 1 : 0) << i;
    EXPECT_EQ(octree.nodes().empty() ? 0 : octree.nodes()[0].count, octree.order().size());
}

uint32_t largestLeaf(const InstanceOctree& octree) {
    uint32_t largest = 0;
    for (const InstanceOctree::Node& node : octree.nodes())
        if (node.leaf()) largest = std::max(largest, node.count);
    return largest;
}

int depthOf(const InstanceOctree& octree) {
    int depth = 0;
    for (const InstanceOctree::Node& node : octree.nodes()) depth = std::max(depth, int(node.depth));
    return depth;
}

ScenePointer randomField(size_t count, const Vec3& size, uint64_t seed) {
    Random random(seed);
    std::vector<Mat4> places;
    for (size_t i = 0; i < count; ++i)
        places.push_back(translation(size * Vec3(random.unit(), random.unit(), random.unit())) *
                         scaling(Vec3(random.between(0.1, 3.0))));
    return copiesOf(smallBox(), places);
}

TEST(InstanceOctree, emptySceneHasNoNodes) {
    EXPECT_TRUE(InstanceOctree().nodes().empty());
    const Scene nothing("nothing", {}, {});
    EXPECT_TRUE(InstanceOctree(nothing).nodes().empty());
    EXPECT_TRUE(InstanceOctree(nothing).order().empty());
    const ScenePointer points = sceneOf({meshOf({{1, 2, 3}}, {}), meshOf({{4, 5, 6}}, {})});
    EXPECT_TRUE(InstanceOctree(*points).nodes().empty()) << "of instances without triangles";
}

TEST(InstanceOctree, oneInstanceIsOneLeaf) {
    const ScenePointer scene = sceneOf({meshOf({{1, 2, 3}}, {}), smallBox()});
    const InstanceOctree octree(*scene);
    ASSERT_EQ(octree.nodes().size(), 1u);
    EXPECT_TRUE(octree.nodes()[0].leaf());
    EXPECT_EQ(octree.nodes()[0].parent, -1);
    EXPECT_EQ(octree.order(), std::vector<uint32_t>{1});
    check(octree, *scene);
}

TEST(InstanceOctree, everyInstanceIsInOneLeafAndInItsBoxes) {
    for (const Vec3& size : {Vec3(10), Vec3(100, 0, 100), Vec3(0, 1e-3, 0), Vec3(1e9, 1, 1e-9)})
        for (const size_t count : {2, 4, 5, 9, 100, 3000}) {
            const ScenePointer scene = randomField(count, size, count);
            const InstanceOctree octree(*scene);
            check(octree, *scene);
            EXPECT_LE(largestLeaf(octree), InstanceOctree::kLeafInstances) << count;
            EXPECT_EQ(octree.bytes(), octree.nodes().size() * sizeof(InstanceOctree::Node) + 4 * octree.order().size());
        }
}

TEST(InstanceOctree, cellsAreEighthsOfTheirParents) {
    // A grid of 16³ is divided evenly at each level.
    std::vector<Mat4> places;
    for (int i = 0; i < 4096; ++i) places.push_back(translation(Vec3(i % 16, i / 16 % 16, i / 256)));
    const ScenePointer scene = copiesOf(smallBox(), places);
    const InstanceOctree octree(*scene);
    check(octree, *scene);
    EXPECT_EQ(octree.nodes().size(), 1u + 8 + 64 + 512 + 4096);
    for (const InstanceOctree::Node& node : octree.nodes()) {
        EXPECT_EQ(node.childCount, node.depth < 4 ? 8 : 0);
        EXPECT_EQ(node.count, 4096u >> (3 * node.depth));
        const double edge = 16.0 / (1 << node.depth) - 0.8;
        EXPECT_LT(glm::distance(node.box.max - node.box.min, Vec3(edge)), 1e-6);
    }
}

TEST(InstanceOctree, coincidentCentresEndInOneLeaf) {
    std::vector<Mat4> places(500, translation({3, 4, 5}));
    const ScenePointer same = copiesOf(smallBox(), places);
    const InstanceOctree one(*same);
    EXPECT_EQ(one.nodes().size(), 1u);
    check(one, *same);
    for (int i = 0; i < 500; ++i) places.push_back(translation({0.1 * i, 0, 0}));
    const ScenePointer mixed = copiesOf(smallBox(), places);
    const InstanceOctree octree(*mixed);
    check(octree, *mixed);
    EXPECT_EQ(largestLeaf(octree), 500u);
}

TEST(InstanceOctree, objectFarAwayLeavesTheOthersDivided) {
    // Relative to 1e12, the whole field lies in one of the 2^21 cells of a Morton code along each axis.
    Random random(5);
    std::vector<Mat4> places{translation(Vec3(1e12))};
    for (int i = 0; i < 2000; ++i) places.push_back(translation(10.0 * Vec3(random.unit(), random.unit(), random.unit())));
    const ScenePointer scene = copiesOf(smallBox(), places);
    const InstanceOctree octree(*scene);
    check(octree, *scene);
    EXPECT_LE(largestLeaf(octree), InstanceOctree::kLeafInstances);
}

TEST(InstanceOctree, depthEndsAtItsLimit) {
    // Each object twice as far out as the one before: every level of the octree separates only a few.
    std::vector<Mat4> places;
    for (int i = 0; i < 600; ++i) places.push_back(translation({std::ldexp(1.0, i - 300), 0, 0}) * scaling(Vec3(1e-200)));
    const ScenePointer scene = copiesOf(smallBox(), places);
    const InstanceOctree octree(*scene);
    check(octree, *scene);
    EXPECT_EQ(depthOf(octree), InstanceOctree::kMaxDepth);
}

TEST(InstanceOctree, instanceThatIsNotFiniteWidensOnlyBoxesThatHoldIt) {
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<Mat4> places;
    for (int i = 0; i < 40; ++i) places.push_back(translation({double(i), 0, 0}));
    places[7] = translation({std::nan(""), 0, 0});
    places[21] = scaling(Vec3(1e308)) * translation(Vec3(1e308));
    const ScenePointer scene = copiesOf(smallBox(), places);
    const InstanceOctree octree(*scene);
    std::vector<int> leaves(40, 0);
    for (const InstanceOctree::Node& node : octree.nodes()) {
        bool finite = true;
        for (const uint32_t instance : octree.instancesOf(node)) {
            finite = finite && instance != 7 && instance != 21;
            if (node.leaf()) ++leaves[instance];
        }
        EXPECT_EQ(node.box.min == Vec3(-infinity) && node.box.max == Vec3(infinity), !finite);
    }
    EXPECT_EQ(leaves, std::vector<int>(40, 1));
}

TEST(InstanceOctree, hundredThousandInstancesMakeTheSameShallowTree) {
    const ScenePointer scene = randomField(100'000, Vec3(1000, 10, 1000), 3);
    const InstanceOctree octree(*scene);
    check(octree, *scene);
    EXPECT_LE(largestLeaf(octree), InstanceOctree::kLeafInstances);
    EXPECT_LE(octree.nodes().size(), 100'000u);
    EXPECT_LE(depthOf(octree), 21);
    const InstanceOctree again(*scene);
    EXPECT_EQ(again.order(), octree.order());
}

TEST(InstanceOctree, buildStopsAtTheNextLookWhereverItIs) {
    const ScenePointer scene = randomField(6'000, Vec3(100), 4);
    uint64_t all = 0;
    {
        const WatchedWork watched;
        const InstanceOctree octree(*scene, 1);
        all = watched.steps();
        ASSERT_GT(octree.nodes().size(), 6'000u);
    }
    ASSERT_GT(all, 60'000u) << "the sort's comparisons among them";
    for (const uint64_t steps : {uint64_t{1}, all / 12, all / 2, all - 2 * WorkCheck::kBetween}) {
        const StoppedWork stopped =
            stoppedAfter(steps, [&](const Progress& progress) { (void)InstanceOctree(*scene, 1, progress); });
        EXPECT_TRUE(stopped.interrupted) << steps;
        EXPECT_LE(stopped.stepsAfter, WorkCheck::kBetween) << steps;
    }
}

}  // namespace
}  // namespace cullscope::test::instance_octree_test
