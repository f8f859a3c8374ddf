#include "core/spatial/regular_octree.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/random_views.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test::regular_octree_test {
namespace {

bool holds(const Box3& outer, const Box3& inner) {
    return glm::all(glm::lessThanEqual(outer.min, inner.min)) && glm::all(glm::greaterThanEqual(outer.max, inner.max));
}

std::vector<uint32_t> allOf(const Scene& scene) {
    std::vector<uint32_t> instances(scene.instances().size());
    std::iota(instances.begin(), instances.end(), 0u);
    return instances;
}

/// 600 boxes of different sizes in a space that is longer than it is high.
ScenePointer scatteredBoxes(uint64_t seed) {
    Random random(seed);
    std::vector<Mat4> places;
    for (int i = 0; i < 600; ++i)
        places.push_back(translation({random.between(-50, 50), random.between(-5, 5), random.between(-20, 20)}) *
                         scaling(Vec3(random.between(0.01, 3.0))));
    return copiesOf(boxMesh(Vec3f(-1.0f), Vec3f(1.0f)), places);
}

TEST(RegularOctree, everyInstanceIsInTheLeafWhoseCellHoldsItsCentre) {
    const ScenePointer scene = scatteredBoxes(3);
    for (int levels = 1; levels <= 5; ++levels) {
        const RegularOctree octree(*scene, allOf(*scene), levels);
        std::vector<int> found(scene->instances().size(), 0);
        size_t leaves = 0;
        for (size_t number = 0; number < octree.nodes().size(); ++number) {
            const RegularOctree::Node& node = octree.nodes()[number];
            EXPECT_GT(node.count, 0u);
            EXPECT_EQ(node.leaf(), node.depth + 1 == levels);
            if (!node.leaf()) continue;
            ++leaves;
            for (const uint32_t instance : octree.instancesOf(node)) {
                ++found[instance];
                const Vec3 centre = scene->instanceBox(instance).centre();
                EXPECT_TRUE(holds(octree.cells()[number], {centre, centre})) << levels << " levels, instance " << instance;
                EXPECT_TRUE(holds(node.box, scene->instanceBox(instance)));
            }
        }
        EXPECT_EQ(found, std::vector<int>(found.size(), 1));
        EXPECT_LE(leaves, size_t(1) << (3 * (levels - 1)));
        if (levels == 3) {
            EXPECT_GT(leaves, 50u) << "600 boxes fill nearly every cell";
        }
    }
}

TEST(RegularOctree, childrenDivideTheirParent) {
    const ScenePointer scene = scatteredBoxes(4);
    const RegularOctree octree(*scene, allOf(*scene), 4);
    for (uint32_t number = 0; number < octree.nodes().size(); ++number) {
        const RegularOctree::Node& node = octree.nodes()[number];
        if (node.leaf()) continue;
        uint32_t next = node.first;
        uint64_t triangles = 0;
        for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child) {
            const RegularOctree::Node& part = octree.nodes()[child];
            EXPECT_EQ(part.parent, int32_t(number));
            EXPECT_EQ(part.first, next);
            EXPECT_TRUE(holds(node.box, part.box));
            EXPECT_TRUE(holds(octree.cells()[number], octree.cells()[child]));
            const Vec3 ratio = octree.cells()[number].halfExtent() / octree.cells()[child].halfExtent();
            for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(ratio[axis], 2.0, 1e-9);
            next += part.count;
            triangles += part.triangles;
        }
        EXPECT_EQ(next, node.first + node.count);
        EXPECT_EQ(triangles, node.triangles);
    }
}

TEST(RegularOctree, instancesWithoutTrianglesOrWithoutAFiniteBoxDoNoHarm) {
    const std::vector<Mat4> places{translation({1, 0, 0}), translation({std::numeric_limits<double>::infinity(), 0, 0}),
                                   translation({5, 1, 2})};
    const MeshPointer box = boxMesh(Vec3f(-1.0f), Vec3f(1.0f));
    const ScenePointer scene = sceneOf({box, box, box, meshOf({}, {})}, places);
    const RegularOctree octree(*scene, allOf(*scene), 4);
    ASSERT_FALSE(octree.nodes().empty());
    EXPECT_EQ(octree.nodes().front().count, 3u);
    EXPECT_TRUE(std::isinf(octree.nodes().front().box.max.x));
    EXPECT_TRUE(RegularOctree(*scene, std::vector<uint32_t>{3}, 4).nodes().empty());
    EXPECT_TRUE(RegularOctree(*scene, {}, 4).nodes().empty());
}

}  // namespace
}  // namespace cullscope::test::regular_octree_test
