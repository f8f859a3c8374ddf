#pragma once

#include <cstdint>
#include <vector>

#include "core/scene/camera.h"
#include "core/spatial/instance_octree.h"
#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// An object that the planes of a view do not leave out.
struct KeptObject {
    uint32_t instance = 0;
    uint8_t planes = 0;  ///< bit p: FrustumPlane p may cut it; a plane whose bit is clear has all of it inside
};

/// What a walk cost and what it left out.
struct OctreeWalkCounters {
    uint64_t nodesVisited = 0;
    uint64_t objectsTested = 0;  ///< one by one, in leaves
    uint64_t planesTested = 0;   ///< of both, all planes together
    uint64_t axesTested = 0;     ///< of both, how many were tested by separating axes
    uint64_t objectsCulled = 0;
    uint64_t trianglesCulled = 0;
};

/// Under which plane each group and object was last left out: it is tested first the next time, for what it left out it will
/// most often leave out again (Assarsson & Möller 2000). Decides nothing.
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

struct OctreeWalkOptions {
    /// Groups and objects that no plane leaves out are tested by separating axes too (geometry/separation.h).
    bool refine = false;
    /// Null: the planes are tested in their own order. A traced walk neither reads nor writes it, so that it always tells the
    /// same.
    LastFailedPlanes* memory = nullptr;
};

/// The objects of a scene that reach into a view, in the octree's order, by its groups: one outside a plane is dropped with all
/// it holds; a plane that has all of a group inside is not tested below it (Assarsson & Möller 2000), and a group inside all six
/// hands on its run as it is. Conservative: an object that reaches into the frustum is always kept (bound: geometry/frustum.h,
/// conservativeMargin). `octree` is the scene's. Where given, `figures` is added to, and `trace` gets the visited groups and, for
/// every object that is left out, the test of its own bounds against the rejecting plane and its end; nothing about kept ones.
[[nodiscard]] std::vector<KeptObject> keptObjects(const InstanceOctree& octree, const Scene& scene, const View& view,
                                                  OctreeWalkCounters* figures = nullptr, Trace* trace = nullptr,
                                                  const OctreeWalkOptions& options = {});

/// Orders objects by the distance of their spheres from the eye: what is drawn first hides what comes after from the costly part
/// of OpenGL's work.
void sortNearestFirst(std::vector<KeptObject>& kept, const Scene& scene, const Vec3& eye);

/// Appends the octree's nodes to `inside` as groups, with what a traced walk decided about them (of those that it did not visit,
/// the nearest visited ancestor's), and hangs the objects' nodes that are there already under their leaves.
void addGroups(StructureSnapshot& snapshot, const InstanceOctree& octree, const Scene& scene, const Trace& trace);

}  // namespace cullscope
