#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/frame/frame_context.h"
#include "core/frame/named_parts.h"
#include "core/spatial/instance_octree.h"
#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// An object that is outside no plane of a view.
struct KeptObject {
    uint32_t instance = 0;
    uint8_t planes = 0;  ///< bit p: FrustumPlane p may cut it; if clear, it lies completely inside that plane
};

/// The cost of a walk and what it culled.
struct OctreeWalkCounters {
    uint64_t nodesVisited = 0;
    uint64_t objectsTested = 0;  ///< one by one, in leaves
    uint64_t planesTested = 0;   ///< of groups and objects, planes tested in total
    uint64_t axesTested = 0;     ///< of groups and objects, how many were tested by separating axes
    uint64_t objectsCulled = 0;
    uint64_t trianglesCulled = 0;
};

/// The plane that last culled each group and object. It is tested first the next time, because it most often culls again
/// (Assarsson & Möller 2000). Does not change any result.
class LastFailedPlanes {
public:
    static constexpr uint8_t kNone = 0xFF;

    LastFailedPlanes() = default;
    LastFailedPlanes(size_t groups, size_t objects) : m_groups(groups, kNone), m_objects(objects, kNone) {}

    [[nodiscard]] uint8_t& ofGroup(uint32_t node) { return m_groups[node]; }
    [[nodiscard]] uint8_t& ofObject(uint32_t instance) { return m_objects[instance]; }
    [[nodiscard]] uint64_t bytes() const { return m_groups.size() + m_objects.size(); }

private:
    std::vector<uint8_t> m_groups, m_objects;
};

/// The lines of a strategy's listing at which the walk's decisions fall.
struct OctreeWalkLines {
    uint8_t groupPlanes = 0, groupAxes = 0;     ///< the tests of a group
    uint8_t groupOutside = 0, groupInside = 0;  ///< the end of a group that is decided as a whole
    uint8_t objectTests = 0, objectOutside = 0;
};

/// The nodes of an octree over objects, and the objects in its order.
struct GroupTree {
    std::span<const InstanceOctree::Node> nodes;
    std::span<const uint32_t> order;
    uint32_t firstNumber = 0;          ///< of the root in decisions, which number the nodes of all trees of a strategy
    const char* name = nullptr;        ///< of the root in lists, where there are several trees: a word that is not translated
    std::span<const Box3> boxes = {};  ///< by node: what is tested; empty: the nodes' own boxes

    GroupTree(std::span<const InstanceOctree::Node> allNodes, std::span<const uint32_t> objects)
        : nodes(allNodes), order(objects) {}
    // Not explicit: an octree is its nodes and its order.
    GroupTree(const InstanceOctree& octree) : nodes(octree.nodes()), order(octree.order()) {}  // NOLINT(*-explicit-*)

    [[nodiscard]] std::span<const uint32_t> instancesOf(const InstanceOctree::Node& node) const {
        return order.subspan(node.first, node.count);
    }
    [[nodiscard]] const Box3& boxOf(uint32_t node) const { return boxes.empty() ? nodes[node].box : boxes[node]; }
};

/// A node that a walk has still to visit.
struct NodeEntry {
    static constexpr uint32_t kAllPlanes = (1U << 6U) - 1;

    uint32_t node = 0;
    uint32_t planes = kAllPlanes;  ///< bit p: FrustumPlane p may cut it
};

struct OctreeWalkOptions {
    /// Tests groups and objects that are outside no plane by separating axes too (geometry/separation.h).
    bool refine = false;
    /// Null: the planes are tested in their own order.
    LastFailedPlanes* memory = nullptr;
    OctreeWalkLines lines{};
    /// Hears of a node that is outside no plane, in the octree's order, parents first. `planes`: those that may cut it. It
    /// returns whether the walk goes on below the node, or with its objects in a leaf. Then no node is kept as a whole without
    /// being visited. Empty: the walk goes on.
    std::function<bool(uint32_t node, uint32_t planes)> visited{};
    /// Hears of an object that is outside no plane, after `visited` of its leaf. It returns whether the object is kept; one that
    /// is not is its own to count and to say. Empty: the object is kept.
    std::function<bool(uint32_t instance, uint8_t nesting)> keeps{};
    /// The parts of a node, and the objects of a leaf, are visited by their distance from the eye, the nearest first, in place of
    /// the octree's order.
    bool nearestFirst = false;
    /// The nodes at which it begins, of which none lies within another. Empty: the root.
    std::vector<NodeEntry> from{};
};

/// The objects of a scene that intersect a view's frustum, in the octree's order. The walk tests groups: a group outside a plane
/// is culled with all its objects; a plane that a group lies completely inside is not tested below it (Assarsson & Möller 2000);
/// the range of a group inside all six is kept without further tests. Conservative: an object that intersects the frustum is
/// always kept (margin: geometry/frustum.h, conservativeMargin). `tree` is over the frame's
/// scene. The costs are added to `counters` if it is not null. A frame that records gets every test of every group and object
/// that the walk visits, the end of those that it culls, and that of groups that it keeps as a whole; what becomes of an object
/// that it keeps is for the strategy to say.
[[nodiscard]] std::vector<KeptObject> keptObjects(const GroupTree& tree, FrameContext& frame,
                                                  OctreeWalkCounters* counters = nullptr, const OctreeWalkOptions& options = {});

/// Sorts objects by the distance of their spheres from the eye: objects drawn first occlude later ones before fragment shading.
void sortNearestFirst(std::vector<KeptObject>& kept, const Scene& scene, const Vec3& eye);

/// Appends the tree's nodes to `snapshot` as groups, with the results of a recorded walk (for nodes that it did not visit,
/// those of the nearest visited ancestor), and makes the leaves the parents of the objects' nodes that `snapshot` already has.
void addGroups(StructureSnapshot& snapshot, const GroupTree& tree, const Scene& scene, const FrameLog& log);

/// The objects, and the leaves in which they lie by their numbers, for questions about these.
[[nodiscard]] NamedParts objectsByLeaf(const InstanceOctree& octree, const Scene& scene);

}  // namespace cullscope
