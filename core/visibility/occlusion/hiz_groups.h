#pragma once

#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "core/visibility/occlusion/two_passes.h"
#include "core/visibility/octree_walk.h"

namespace cullscope::occlusion {

/// Groups of an octree that a view has found not to be hidden although nothing in them was visible. For some frames it goes on
/// with what is in them without asking about them.
class ShownGroups {
public:
    /// Begins a frame, in which what was noted long ago is forgotten.
    void beginFrame();
    void note(uint32_t node) { m_until[node] = m_frame + kFrames; }
    [[nodiscard]] bool contains(uint32_t node) const { return m_until.contains(node); }

private:
    /// A question costs a wait for OpenGL, an unasked group the questions about its parts.
    static constexpr uint64_t kFrames = 16;

    uint64_t m_frame = 0;
    std::unordered_map<uint32_t, uint64_t> m_until;  ///< by node: the frame at which it is forgotten
};

/// The leaf of every object; kNoLeaf of those without triangles.
inline constexpr uint32_t kNoLeaf = UINT32_MAX;
[[nodiscard]] std::vector<uint32_t> leavesOfObjects(const InstanceOctree& octree, size_t objects);

/// By node: the squared diagonal of the largest box of an object in it.
[[nodiscard]] std::vector<float> largestOfNodes(const InstanceOctree& octree, const Scene& scene);

/// The nodes that hold one of these objects (keys of what was visible, DrawnParts::Part::key).
[[nodiscard]] std::unordered_set<uint32_t> nodesAround(const std::vector<uint64_t>& objects, const std::vector<uint32_t>& leaves,
                                                       const InstanceOctree& octree);

/// The lines of a strategy's listing at which the decisions about groups fall; their tests are at TwoPassLines::test.
struct HizGroupLines {
    OctreeWalkLines walk{};
    uint8_t hidden = 0;
};

struct HizGroupOptions {
    size_t large = 0;  ///< so many objects, of those of which nothing is known, are in no group that is asked about
    HizGroupLines lines{};
    LastFailedPlanes* planes = nullptr;
};

/// What is left out, and what it costs.
struct HizGroupCounters {
    OctreeWalkCounters walked;
    uint64_t hiddenGroups = 0;
};

/// Goes through the groups of an octree that intersect the frustum. Where something in a group was visible in the frame before,
/// the walk goes on with what is in it, and so it does with those objects of the other groups that look largest, which may hide
/// the rest. The groups that are left wait until those objects are drawn, and are then asked about as a whole: those that are
/// hidden are left out with all their objects, and of the others the parts are asked about.
class HizGroups {
public:
    /// `largest`: largestOfNodes.
    HizGroups(const InstanceOctree& octree, const std::vector<float>& largest, FrameContext& frame,
              const HizGroupOptions& options, std::unordered_set<uint32_t> open, ShownGroups& shown);

    /// The objects in the frustum whose groups are not asked about.
    [[nodiscard]] std::vector<KeptObject> begin();
    /// Whether groups wait.
    [[nodiscard]] bool waiting() const { return !m_waiting.empty(); }
    /// Asks about them, and returns the objects of those that are not hidden.
    [[nodiscard]] std::vector<KeptObject> ask(SecondPass& pass);

    [[nodiscard]] const HizGroupCounters& counters() const { return m_counters; }

private:
    /// Which groups wait when a walk comes to them: none, those that are asked about, or all but leaves.
    enum class Waits : uint8_t { None, Asked, Nodes };
    [[nodiscard]] std::vector<KeptObject> walk(std::vector<NodeEntry> from, Waits waits);
    /// The objects that may look largest of the groups that wait; their leaves wait no more.
    [[nodiscard]] std::vector<KeptObject> largest();
    [[nodiscard]] bool isAsked(uint32_t node) const;
    void leaveOut(uint32_t node);
    /// What the walk goes on with in a group that is not hidden.
    void addParts(std::vector<NodeEntry>& entries, const NodeEntry& group) const;

    const InstanceOctree& m_octree;
    const std::vector<float>& m_largest;
    FrameContext& m_frame;
    HizGroupOptions m_options;
    std::unordered_set<uint32_t> m_open;
    ShownGroups& m_shown;
    std::vector<NodeEntry> m_waiting;
    HizGroupCounters m_counters;
};

}  // namespace cullscope::occlusion
