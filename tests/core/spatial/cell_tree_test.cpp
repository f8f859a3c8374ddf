// The division of the triangles over the tree's nodes.
#include "core/spatial/cell_tree.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "tests/support/test_scenes.h"
#include "tests/support/tested_trees.h"

namespace cullscope::test::cell_tree_test {
namespace {

using Node = CellTree::Node;

TEST(CellTree, orderHoldsEveryTriangleOnce) {
    forAllTrees([](const CellTree& tree) {
        std::vector<uint32_t> order(tree.triangleOrder().begin(), tree.triangleOrder().end());
        std::ranges::sort(order);
        ASSERT_EQ(order.size(), tree.mesh().triangleCount());
        for (uint32_t i = 0; i < order.size(); ++i) ASSERT_EQ(order[i], i);
        ASSERT_EQ(tree.indices().size(), tree.mesh().indices().size());
        for (size_t place = 0; place < order.size(); ++place)
            for (size_t i = 0; i < 3; ++i)
                ASSERT_EQ(tree.indices()[3 * place + i], tree.mesh().indices()[3 * size_t(tree.triangleOrder()[place]) + i]);
    });
}

/// Expects the children to partition their parent's triangles, in ascending order of their cells inside its cell.
void expectTiled(const CellTree& tree, const Node& node) {
    uint32_t next = node.first;
    uint64_t nextCode = 0;
    ASSERT_GE(node.childCount, 1);
    ASSERT_LE(node.childCount, 4);
    for (uint32_t i = 0; i < node.childCount; ++i) {
        const Node& child = tree.nodes()[node.firstChild + i];
        ASSERT_EQ(child.first, next);
        ASSERT_GT(child.count, 0U);
        ASSERT_GT(child.level, node.level);
        ASSERT_EQ(child.code >> (2 * (child.level - node.level)), node.code);
        const uint64_t code = uint64_t(child.code) << (2 * (kFinestLevel - child.level));
        ASSERT_GE(code, nextCode);
        nextCode = code + 1;
        next += child.count;
    }
    ASSERT_EQ(next, node.first + node.count);
}

TEST(CellTree, childrenNestAndTile) {
    forAllTrees([](const CellTree& tree) {
        std::vector<uint32_t> parents(tree.nodes().size(), 0);
        ASSERT_EQ(tree.nodes()[0].first, 0U);
        ASSERT_EQ(tree.nodes()[0].count, tree.mesh().triangleCount());
        for (uint32_t number = 0; number < tree.nodes().size(); ++number) {
            const Node& node = tree.nodes()[number];
            if (node.childCount == 0) continue;
            ASSERT_GT(node.firstChild, number);
            ASSERT_LE(node.firstChild + node.childCount, tree.nodes().size());
            for (uint32_t i = 0; i < node.childCount; ++i) ++parents[node.firstChild + i];
            ASSERT_NO_FATAL_FAILURE(expectTiled(tree, node));
        }
        for (uint32_t number = 1; number < parents.size(); ++number) ASSERT_EQ(parents[number], 1U) << "node " << number;
    });
}

TEST(CellTree, everyTriangleIsInOneLeafWhoseCellHoldsItsCentroid) {
    forAllTrees([](const CellTree& tree) {
        size_t inLeaves = 0;
        for (const Node& node : tree.nodes()) {
            if (node.childCount > 0) continue;
            inLeaves += node.count;
            for (uint32_t place = node.first; place < node.first + node.count; ++place) {
                const std::array<Vec3, 3> corners = tree.corners(tree.triangleOrder()[place]);
                const Vec3 centroid = corners[0] + corners[1] + corners[2];
                if (centroid == Vec3(0.0)) continue;
                ASSERT_EQ(mapCellOf(tree.layout(), centroid, node.level), node.cell()) << "triangle at place " << place;
                ASSERT_EQ(tree.leafAt(centroid), &node);
            }
        }
        ASSERT_EQ(inLeaves, tree.mesh().triangleCount());
    });
}

TEST(CellTree, leavesAreAsFineAsAsked) {
    forAllTrees([](const CellTree& tree) {
        uint32_t deepest = 0;
        size_t leaves = 0;
        for (const Node& node : tree.nodes()) {
            deepest = std::max(deepest, uint32_t(node.level));
            leaves += node.childCount == 0 ? 1 : 0;
        }
        EXPECT_EQ(tree.deepestLevel(), deepest);
        EXPECT_EQ(tree.leafCount(), leaves);
    });
    const MeshPointer mesh = starMesh(7, 20'000);
    for (const CellTree::Options& options : kAllOptions) {
        SCOPED_TRACE(named(*mesh, options));
        const CellTree tree(mesh, options);
        for (const Node& node : tree.nodes()) {
            if (node.childCount > 0) continue;
            const bool fewEnough = node.count <= (options.level == 0 ? CellTree::kTrianglesALeaf : 1);
            EXPECT_TRUE(fewEnough || node.level == (options.level == 0 ? kFinestLevel : options.level)) << node.count;
            EXPECT_LE(node.level, options.level == 0 ? kFinestLevel : options.level);
        }
    }
}

TEST(CellTree, doesNotDependOnTheNumberOfThreads) {
    const auto fields = [](const Node& n) {
        return std::tuple(n.low, n.high, n.coneAxis, n.coneCosine, n.coneSine, n.planeMargin, n.leastHeight,
                          std::tuple(n.first, n.count, n.firstChild, n.code, n.level, n.childCount));
    };
    for (const MeshPointer& mesh : {knotMesh(30'000), awkwardTriangles(), bowlMesh(20'000)})
        for (const CellTree::Options& options : kAllOptions) {
            SCOPED_TRACE(named(*mesh, options));
            const auto builtBy = [&](size_t threads) {
                const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
                return CellTree(mesh, options);
            };
            const CellTree one = builtBy(1), two = builtBy(2);
            ASSERT_TRUE(std::ranges::equal(one.triangleOrder(), two.triangleOrder()));
            ASSERT_EQ(one.nodes().size(), two.nodes().size());
            for (size_t i = 0; i < one.nodes().size(); ++i) ASSERT_EQ(fields(one.nodes()[i]), fields(two.nodes()[i]));
        }
}

TEST(CellTree, leafAtADirectionWithoutTrianglesIsNone) {
    // A tiny triangle far above the centre of the bounding sphere, and one far below it.
    const MeshPointer mesh = looseTriangles({{Vec3f(-0.01f, -0.01f, 1), Vec3f(0.01f, -0.01f, 1), Vec3f(0, 0.01f, 1)},
                                             {Vec3f(-0.01f, -0.01f, -1), Vec3f(0, 0.01f, -1), Vec3f(0.01f, -0.01f, -1)}});
    for (const MapLayout layout : {MapLayout::Octahedral, MapLayout::LatitudeLongitude}) {
        const CellTree tree(mesh, {layout, 9});
        EXPECT_EQ(tree.leafAt({1.0, 0.3, 0.2}), nullptr);
        for (uint32_t triangle = 0; triangle < 2; ++triangle) {
            const std::array<Vec3, 3> corners = tree.corners(triangle);
            const Node* leaf = tree.leafAt(corners[0] + corners[1] + corners[2]);
            ASSERT_NE(leaf, nullptr);
            EXPECT_EQ(tree.triangleOrder()[leaf->first], triangle);
            EXPECT_EQ(leaf->count, 1U);
        }
    }
}

TEST(CellTree, meshWithoutTrianglesHasNoNodes) {
    for (const CellTree::Options& options : kAllOptions) {
        const CellTree tree(meshOf({}, {}), options);
        EXPECT_TRUE(tree.nodes().empty());
        EXPECT_EQ(tree.leafCount(), 0U);
        EXPECT_EQ(tree.leafAt({0, 0, 1}), nullptr);
        EXPECT_EQ(tree.bytes(), 0U);
    }
}

TEST(CellTree, oneTriangleIsOneLeaf) {
    for (const CellTree::Options& options : kAllOptions) {
        const CellTree tree(meshOf({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {0, 1, 2}), options);
        ASSERT_EQ(tree.nodes().size(), 1U);
        EXPECT_EQ(tree.nodes()[0].count, 1U);
        EXPECT_EQ(tree.nodes()[0].coneAxis, Vec3f(0, 0, 1));
        EXPECT_NEAR(tree.nodes()[0].leastHeight, std::sqrt(0.5), 1e-6);
    }
}

TEST(CellTree, trianglesAtOnePointAreKeptAndHaveNoNormals) {
    const std::array<Vec3f, 3> point{Vec3f(0.3f, 0.2f, 0.1f), Vec3f(0.3f, 0.2f, 0.1f), Vec3f(0.3f, 0.2f, 0.1f)};
    for (const CellTree::Options& options : kAllOptions) {
        const CellTree tree(looseTriangles(std::vector(200, point)), options);
        ASSERT_FALSE(tree.nodes().empty());
        EXPECT_EQ(tree.nodes()[0].count, 200U);
        for (const Node& node : tree.nodes()) {
            EXPECT_EQ(node.coneAxis, Vec3f(0.0f));
            EXPECT_EQ(node.coneCosine, 1.0f);
            EXPECT_EQ(node.leastHeight, std::numeric_limits<float>::infinity());
        }
    }
}

}  // namespace
}  // namespace cullscope::test::cell_tree_test
