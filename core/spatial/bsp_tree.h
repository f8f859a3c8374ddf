#pragma once

#include <optional>

#include "core/spatial/cut_triangles.h"

namespace cullscope {

/// Which plane divides a node's polygons. All but Given take the plane of one of them.
enum class BspPlane {
    First,    ///< of the first polygon
    Fewest,   ///< of k candidates the one that cuts the fewest polygons; of equal ones the one that divides best
    Balance,  ///< of k candidates the one whose larger side is smallest, cut polygons counted on both
    Given     ///< the scene's own planes, one a level; what lies together in a cell below them is divided as by Fewest
};

struct BspOptions {
    BspPlane plane = BspPlane::Balance;
    int candidates = 8;          ///< of Fewest and Balance, spread evenly over the node's polygons
    uint64_t limit = 1'000'000;  ///< of polygons, whole and cut, and of nodes
};

/// A binary space partitioning tree of a scene's triangles (Fuchs, Kedem & Naylor 1980), cut where a plane passes through them.
/// Polygons that lie in a node's plane are kept at the node. Its shape does not depend on an eye.
class BspTree {
public:
    static constexpr int32_t kNone = -1;
    /// Candidates are judged by so many of a node's polygons at most, spread evenly.
    static constexpr size_t kJudged = 256;

    struct Node {
        CuttingPlane plane;  ///< none of a leaf
        bool leaf = false;   ///< a cell with its polygons, which lie in one plane, or empty; only below given planes
        uint32_t depth = 0;  ///< the root's is 0
        int32_t parent = kNone, front = kNone, back = kNone;
        uint32_t firstPart = 0, partCount = 0;  ///< in its plane or cell
        uint32_t polygons = 0;                  ///< of it and all below
        Box3 box;                               ///< around these
    };
    /// A polygon that is a triangle of the scene or a part of one.
    struct Part {
        uint32_t triangle = 0;  ///< scene triangle number
        uint32_t first = 0;     ///< of the triangles that it is drawn as
        uint32_t count = 0;
        double share = 1.0;  ///< of the triangle's area
    };

    /// Builds it without recursion; nodes are numbered level by level. Throws Error(Usage) where more polygons or nodes would be
    /// made than the limit allows (each given plane divides every cell: n of them make 2ⁿ cells), or (Given)
    /// where the scene has no planes; Error(Interrupted) on a stop request.
    BspTree(const Scene& scene, const BspOptions& options, const Progress& progress = {});

    [[nodiscard]] const std::vector<Node>& nodes() const { return m_nodes; }
    /// In the order of the nodes; those of one node by descending triangle number.
    [[nodiscard]] const std::vector<Part>& parts() const { return m_parts; }
    [[nodiscard]] std::span<const Part> partsOf(const Node& node) const {
        return std::span(m_parts).subspan(node.firstPart, node.partCount);
    }
    /// Triangles without area, which no plane sorts; they cover nothing.
    [[nodiscard]] std::span<const Part> flatParts() const { return std::span(m_parts).subspan(m_firstFlat); }
    /// What the parts are drawn as: positions, normals and scene triangle numbers.
    [[nodiscard]] const OwnTriangles& drawn() const { return m_drawn; }
    [[nodiscard]] uint32_t depth() const { return m_depth; }
    [[nodiscard]] uint64_t cuts() const { return m_cuts; }
    [[nodiscard]] uint64_t bytes() const;

    /// On which side of a node's plane a point lies: 1 in front, −1 behind, 0 in it. Exact.
    [[nodiscard]] static int sideOf(const Node& node, const Vec3& point);

    /// Goes through the tree from the far to the near side of every plane (nearFirst: the other way round), without recursion.
    /// Calls `visit(number, side)` when it comes to a node, and `show(number)` where the node's own polygons come in the order.
    template <typename Visit, typename ShowParts>
    void walk(const Vec3& eye, bool nearFirst, const Visit& visit, const ShowParts& show) const {
        struct Step {
            int32_t node;
            bool own;
        };
        std::vector<Step> steps;
        const auto push = [&](int32_t node, bool own) {
            if (node != kNone) steps.push_back({node, own});
        };
        push(m_nodes.empty() ? kNone : 0, false);
        while (!steps.empty()) {
            const Step step = steps.back();
            steps.pop_back();
            const auto number = uint32_t(step.node);
            if (step.own) {
                show(number);
                continue;
            }
            const Node& node = m_nodes[number];
            const int side = node.leaf ? 0 : sideOf(node, eye);
            visit(number, side);
            const bool frontFirst = (side < 0) != nearFirst;
            push(frontFirst ? node.back : node.front, false);
            push(step.node, true);
            push(frontFirst ? node.front : node.back, false);
        }
    }

private:
    class Builder;

    std::vector<Node> m_nodes;
    std::vector<Part> m_parts;
    OwnTriangles m_drawn;
    size_t m_firstFlat = 0;
    uint32_t m_depth = 0;
    uint64_t m_cuts = 0;
};

}  // namespace cullscope
