// The clusters of a mesh, and the bounds of every node, checked against its triangles.
#include "core/spatial/cluster_tree.h"

#include <gtest/gtest.h>

#include <set>

#include "core/base/error.h"
#include "tests/support/lossless_scenes.h"

namespace cullscope::test::cluster_tree_test {
namespace {

constexpr uint32_t kSizes[] = {16, 60, 128, 512};

template <typename Check>
void forAllTrees(const Check& check) {
    static const std::vector<NamedMesh> kMeshes = losslessMeshes(longMode());
    for (const NamedMesh& each : kMeshes)
        for (const uint32_t size : kSizes) {
            if (fewSamples() && size != 60) continue;
            SCOPED_TRACE(std::string(each.name) + ", " + std::to_string(size));
            check(ClusterTree(each.mesh, size), size);
            if (testing::Test::HasFatalFailure()) return;
        }
}

TEST(ClusterTree, leavesArePartsOfTheMeshInOrder) {
    forAllTrees([](const ClusterTree& tree, uint32_t size) {
        const size_t triangles = tree.mesh().triangleCount();
        std::set<uint32_t> all;
        for (uint32_t place = 0; place < triangles; ++place) all.insert(tree.triangleAt(place));
        ASSERT_EQ(all.size(), triangles);
        ASSERT_EQ(tree.divided(), triangles > size);
        std::vector<std::pair<uint32_t, uint32_t>> leaves;
        for (const SurfaceNode& node : tree.nodes()) {
            if (node.leaf()) {
                leaves.emplace_back(node.first, node.count);
                ASSERT_TRUE(node.count >= 1 && node.count <= size);
                continue;
            }
            ASSERT_LE(node.childCount, ClusterTree::kChildren);
            ASSERT_GE(node.childCount, 2u);
            uint32_t place = node.first;
            for (uint32_t i = 0; i < node.childCount; ++i) {
                const SurfaceNode& child = tree.nodes()[node.firstChild + i];
                ASSERT_EQ(child.first, place);
                ASSERT_EQ(child.level, node.level + 1);
                place += child.count;
            }
            ASSERT_EQ(place, node.first + node.count);
        }
        std::ranges::sort(leaves);
        ASSERT_EQ(leaves.size(), tree.clusterCount());
        uint32_t place = 0;
        for (const auto& [first, count] : leaves) {
            ASSERT_EQ(first, place);
            place += count;
        }
        ASSERT_EQ(place, triangles);
    });
}

TEST(ClusterTree, orderNamesTheSameTriangles) {
    forAllTrees([](const ClusterTree& tree, uint32_t /*size*/) {
        if (!tree.divided()) return;
        for (uint32_t place = 0; place < tree.mesh().triangleCount(); ++place)
            for (size_t c = 0; c < 3; ++c)
                ASSERT_EQ(tree.indices()[3 * size_t(place) + c], tree.mesh().indices()[3 * size_t(tree.triangleAt(place)) + c]);
    });
}

TEST(ClusterTree, boundsHoldForEveryTriangleBelow) {
    size_t cones = 0;
    forAllTrees([&](const ClusterTree& tree, uint32_t /*size*/) {
        for (const SurfaceNode& node : tree.nodes()) {
            cones += node.hasCone() ? 1 : 0;
            for (uint32_t place = node.first; place < node.first + node.count; ++place) {
                const TriangleCorners p = tree.corners(tree.triangleAt(place));
                for (const Vec3& corner : p)
                    for (int axis = 0; axis < 3; ++axis) {
                        ASSERT_LE(double(node.low[axis]), corner[axis]);
                        ASSERT_GE(double(node.high[axis]), corner[axis]);
                    }
                const Vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
                const double area = glm::length(normal);
                if (area == 0.0) continue;
                const double longest = std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
                ASSERT_LE(double(node.leastHeight), area / longest * (1.0 + 1e-12));
                if (!node.hasCone()) continue;
                ASSERT_GT(node.coneCosine, 0.104f) << "wider than 84°";
                ASSERT_GE(glm::dot(normal, Vec3(node.coneAxis)) / area, double(node.coneCosine) - 1e-7);
                ASSERT_LE(glm::dot(normal, node.middle() - p[0]) / area, double(node.planeMargin));
            }
        }
    });
    EXPECT_GT(cones, 1000u);
}

TEST(ClusterTree, mostClustersOfASmoothMeshHaveACone) {
    const ClusterTree tree(starMesh(5, 20'000), 128);
    EXPECT_GT(10 * tree.coneCount(), 9 * tree.clusterCount());
    EXPECT_LT(tree.clusterCount(), 1.4 * 20'000 / 128);
    EXPECT_EQ(ClusterTree(boxMesh({-1, -1, -1}, {1, 1, 1}), 128).coneCount(), 0u);
}

// What the verification after the build looks for, and what it does then.
TEST(SurfaceBounds, thatDoNotHoldForATriangleAreFoundAndWidened) {
    const TriangleCorners front{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, turned{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
        outside{{{0, 0, 0}, {2, 0, 0}, {0, 1, 0}}}, before{{{0, 0, -0.5}, {1, 0, -0.5}, {0, 1, -0.5}}},
        thin{{{0, 0, 0}, {1, 0, 0}, {0, 0.01, 0}}};
    const SurfaceBounds bounds = boundsOf(std::vector{front});
    ASSERT_TRUE(bounds.hasCone() && bounds.hasNormals());
    EXPECT_TRUE(holdsFor(bounds, front));
    SurfaceBounds large = bounds;
    large.low.z = -1.0f;
    large.high.z = 1.0f;
    EXPECT_TRUE(holdsFor(large, front));
    EXPECT_FALSE(holdsFor(large, turned)) << "its normal";
    EXPECT_FALSE(holdsFor(bounds, outside)) << "a corner";
    EXPECT_FALSE(holdsFor(large, before)) << "its plane";
    EXPECT_FALSE(holdsFor(bounds, thin)) << "its height";
    for (const TriangleCorners& other : {turned, outside, before, thin}) {
        const SurfaceBounds wide = widened(bounds, other);
        EXPECT_FALSE(wide.hasCone());
        EXPECT_TRUE(holdsFor(wide, front));
        EXPECT_TRUE(holdsFor(wide, other));
    }
}

TEST(ClusterTree, emptyMeshHasNoNodes) {
    const ClusterTree tree(meshOf({}, {}), 128);
    EXPECT_TRUE(tree.nodes().empty());
    EXPECT_EQ(tree.clusterCount(), 0u);
}

TEST(ClusterTree, stopsWhenAsked) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(ClusterTree(sphereMesh(2'000), 128, Progress{{}, stop.get_token()}), Error);
}

}  // namespace
}  // namespace cullscope::test::cluster_tree_test
