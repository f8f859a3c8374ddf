// The bounds of every node, checked against its triangles.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/tested_trees.h"

namespace cullscope::test::cell_tree_bounds_test {
namespace {

using Node = CellTree::Node;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A triangle from its stored float positions, whose differences are exact in double.
struct Facet {
    std::array<Vec3, 3> corners;  ///< relative to the sphere's centre
    Vec3 normal{0.0};             ///< unit; the null vector where it has no area
    double height = kInfinity;    ///< smallest altitude; infinite where corners coincide
};

Facet facetOf(const CellTree& tree, uint32_t triangle) {
    std::array<Vec3, 3> p;
    for (size_t i = 0; i < 3; ++i) p[i] = Vec3(tree.mesh().positions()[tree.mesh().indices()[3 * size_t(triangle) + i]]);
    Facet facet;
    for (size_t i = 0; i < 3; ++i) facet.corners[i] = p[i] - tree.sphere().centre;
    if (p[0] == p[1] || p[1] == p[2] || p[2] == p[0]) return facet;
    const Vec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
    const double area = glm::length(normal);
    facet.height = area / std::max({glm::length(p[1] - p[0]), glm::length(p[2] - p[1]), glm::length(p[0] - p[2])});
    if (area > 0.0) facet.normal = normal / area;
    return facet;
}

/// By place in the tree's order.
std::vector<Facet> facetsOf(const CellTree& tree) {
    std::vector<Facet> facets;
    for (const uint32_t triangle : tree.triangleOrder()) facets.push_back(facetOf(tree, triangle));
    return facets;
}

std::span<const Facet> below(const Node& node, const std::vector<Facet>& facets) {
    return std::span(facets).subspan(node.first, node.count);
}

bool hasNormals(const Node& node) { return node.coneAxis != Vec3f(0.0f); }
Vec3 middleOf(const Node& node) { return 0.5 * (Vec3(node.low) + Vec3(node.high)); }

TEST(CellTreeBounds, boxesHoldTheirTriangles) {
    forAllTrees([](const CellTree& tree) {
        const std::vector<Facet> facets = facetsOf(tree);
        for (const Node& node : tree.nodes()) {
            Vec3 low(kInfinity), high(-kInfinity);
            for (const Facet& facet : below(node, facets))
                for (const Vec3& corner : facet.corners) {
                    low = glm::min(low, corner);
                    high = glm::max(high, corner);
                }
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_LE(double(node.low[axis]), low[axis]);
                ASSERT_GE(double(node.high[axis]), high[axis]);
                const double room = 1e-6 * tree.sphere().radius;
                ASSERT_GE(double(node.low[axis]), low[axis] - room);
                ASSERT_LE(double(node.high[axis]), high[axis] + room);
            }
        }
    });
}

TEST(CellTreeBounds, leastHeightIsTheSmallestAltitude) {
    forAllTrees([](const CellTree& tree) {
        const std::vector<Facet> facets = facetsOf(tree);
        // The centre is not a float, so differences from it are rounded in proportion to its size.
        const double rounding = 1e-13 * tree.sphere().radius;
        for (const Node& node : tree.nodes()) {
            double height = kInfinity;
            for (const Facet& facet : below(node, facets)) height = std::min(height, facet.height);
            if (height == kInfinity) {
                ASSERT_EQ(node.leastHeight, std::numeric_limits<float>::infinity());
                continue;
            }
            ASSERT_LE(double(node.leastHeight), height + rounding) << "node of " << node.count << " triangles";
            ASSERT_GE(double(node.leastHeight), height * (1.0 - 1e-6) - rounding);
        }
    });
}

TEST(CellTreeBounds, conesHoldAllNormals) {
    forAllTrees([](const CellTree& tree) {
        const std::vector<Facet> facets = facetsOf(tree);
        // How far a normal lies outside the cone: in the cosine and in the sine of its angle to the axis.
        double beyondCosine = -kInfinity, beyondSine = -kInfinity;
        for (const Node& node : tree.nodes()) {
            if (node.coneCosine > 1.0f) continue;
            ASSERT_TRUE(!hasNormals(node) || node.coneCosine > 0.104f);
            ASSERT_TRUE(!hasNormals(node) || std::abs(glm::length(Vec3(node.coneAxis)) - 1.0) < 1e-6);
            for (const Facet& facet : below(node, facets)) {
                if (facet.normal == Vec3(0.0) || facet.height < 1e-9 * tree.sphere().radius) continue;
                ASSERT_TRUE(hasNormals(node)) << "a node without normals has a triangle that has one";
                const Vec3 axis(node.coneAxis);
                beyondCosine = std::max(beyondCosine, double(node.coneCosine) - glm::dot(facet.normal, axis));
                beyondSine = std::max(beyondSine, glm::length(glm::cross(facet.normal, axis)) - double(node.coneSine));
            }
        }
        EXPECT_LE(beyondCosine, 0.0);
        EXPECT_LE(beyondSine, 0.0);
    });
}

TEST(CellTreeBounds, planeMarginHoldsForAllPlanes) {
    forAllTrees([](const CellTree& tree) {
        const std::vector<Facet> facets = facetsOf(tree);
        for (const Node& node : tree.nodes()) {
            if (node.coneCosine > 1.0f || !hasNormals(node)) continue;
            double farthest = -kInfinity;
            for (const Facet& facet : below(node, facets))
                if (facet.normal != Vec3(0.0) && facet.height >= 1e-9 * tree.sphere().radius)
                    farthest = std::max(farthest, glm::dot(facet.normal, middleOf(node) - facet.corners[0]));
            ASSERT_LE(farthest, double(node.planeMargin)) << "node of " << node.count << " triangles";
            if (node.childCount == 0 && node.leastHeight > 1e-4 * tree.sphere().radius) {
                ASSERT_GE(farthest, double(node.planeMargin) - 1e-5 * tree.sphere().radius);
            }
        }
    });
}

TEST(CellTreeBounds, smoothSurfaceHasConesInAllLeaves) {
    for (const MapLayout layout : {MapLayout::Octahedral, MapLayout::LatitudeLongitude}) {
        const CellTree tree(sphereMesh(100'000), {layout, 0});
        const auto cones = std::ranges::count_if(
            tree.nodes(), [](const Node& node) { return node.childCount == 0 && node.coneCosine <= 1.0f && hasNormals(node); });
        EXPECT_EQ(size_t(cones), tree.leafCount());
    }
}

TEST(CellTreeBounds, theMeanShareFacingAwayIsThatOfRandomDirections) {
    for (const MeshPointer& mesh : {sphereMesh(20'000), starMesh(3, 20'000), torusMesh(20'000), squareMesh(1, 0)}) {
        const CellTree tree(mesh, {MapLayout::Octahedral, 0});
        Random random(5);
        constexpr int kDirections = 2000;
        double away = 0.0;
        for (int i = 0; i < kDirections; ++i) {
            const Vec3 towardsEye = random.direction();
            for (const Node& node : tree.nodes()) {
                if (!node.leaf() || !node.hasCone()) continue;
                // All normals around the axis are turned away where the axis is, by more than the cone's angle beyond 90°.
                const double angle = std::acos(std::clamp(glm::dot(Vec3(node.coneAxis), towardsEye), -1.0, 1.0));
                away += angle - std::acos(double(node.coneCosine)) > std::numbers::pi / 2 ? node.count : 0;
            }
        }
        away /= double(kDirections) * double(mesh->triangleCount());
        EXPECT_NEAR(meanShareFacingAway(SurfaceNodes(tree.nodes())), away, 0.02);
    }
}

// The bowl's two walls face each other in every direction. An inner node whose children's axes cancel out was once taken for one
// without normals, and its cone contained none of them.
TEST(CellTreeBounds, childrenThatFaceAgainstEachOtherLeaveNoCone) {
    const CellTree tree(bowlMesh(20'000), {MapLayout::LatitudeLongitude, 9});
    const std::vector<Facet> facets = facetsOf(tree);
    size_t cancelled = 0;
    for (const Node& node : tree.nodes()) {
        Vec3 sum(0.0);
        for (uint32_t i = 0; i < node.childCount; ++i) {
            const Node& child = tree.nodes()[node.firstChild + i];
            sum += double(child.count) * Vec3(child.coneAxis);
        }
        const bool normals = std::ranges::any_of(below(node, facets), [](const Facet& f) { return f.normal != Vec3(0.0); });
        if (node.childCount == 0 || !normals || glm::length(sum) >= 1e-3) continue;
        ++cancelled;
        EXPECT_EQ(node.coneCosine, 2.0f);
    }
    EXPECT_GT(cancelled, 0U) << "the bowl no longer has such a node: take another mesh";
}

TEST(CellTreeBounds, centreInACornerIsNoTroubleForWhatMeetsThere) {
    std::vector<std::array<Vec3f, 3>> fan;
    for (const float x : {1.0f, -1.0f})
        for (const float y : {1.0f, -1.0f}) {
            fan.push_back({Vec3f(0.0f), Vec3f(x, 0, 0), Vec3f(0, y, 0)});
            fan.push_back({Vec3f(0.0f), Vec3f(0, y, 0), Vec3f(0, 0, x)});
        }
    // The centroid is the sphere's centre, so it has no direction.
    fan.push_back({Vec3f(0.5f, 0, 0), Vec3f(-0.25f, 0.25f, 0), Vec3f(-0.25f, -0.25f, 0)});
    for (const CellTree::Options& options : kAllOptions) {
        const CellTree tree(looseTriangles(fan), options);
        EXPECT_LT(glm::length(tree.sphere().centre), 1e-6);
        EXPECT_EQ(tree.nodes()[0].count, fan.size());
        const std::vector<Facet> facets = facetsOf(tree);
        for (const Node& node : tree.nodes()) {
            for (const Facet& facet : below(node, facets)) {
                EXPECT_FALSE(glm::any(glm::isnan(facet.normal)));
                if (node.coneCosine <= 1.0f) {
                    EXPECT_GE(glm::dot(facet.normal, Vec3(node.coneAxis)), double(node.coneCosine));
                }
            }
            EXPECT_FALSE(std::isnan(node.planeMargin) || std::isnan(node.coneSine) || std::isnan(node.leastHeight));
        }
    }
}

}  // namespace
}  // namespace cullscope::test::cell_tree_bounds_test
