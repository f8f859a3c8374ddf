#include "core/visibility/octree_walk.h"

#include <algorithm>

#include "core/geometry/separation.h"
#include "core/visibility/eye_bounds.h"

namespace cullscope {
namespace {

constexpr uint32_t kPlanes = 6;
constexpr uint32_t kAllPlanes = (1u << kPlanes) - 1;

/// The result of testing bounds against the planes of a mask, and by separating axes.
struct MaskedTest {
    uint32_t planes = 0;  ///< planes of the mask that may cut it
    bool outside = false;
    bool byPlane = false;                     ///< with `outside`: by a plane; false: by a separating axis
    FrustumPlane plane = FrustumPlane::Left;  ///< with `byPlane`: the plane it lies outside of
    double distance = 0.0;                    ///< with `byPlane`: signed distance of the point farthest inside
    uint32_t tested = 0;
};

/// `inner` and `outer` return the signed distances of the points farthest inside and farthest outside a plane. `first` is tested
/// before the others, if the mask contains it, and is set to the plane that rejects the bounds. A distance of NaN rejects
/// nothing.
template <typename Inner, typename Outer>
MaskedTest testPlanes(const Frustum& frustum, uint32_t mask, double margin, uint8_t& first, const Inner& inner,
                      const Outer& outer) {
    MaskedTest test{mask};
    const auto isOutside = [&](uint32_t p) {
        test.distance = inner(frustum.planes[p]);
        ++test.tested;
        return test.distance < -margin;
    };
    const auto outside = [&](uint32_t p) {
        first = uint8_t(p);
        return MaskedTest{mask, true, true, static_cast<FrustumPlane>(p), test.distance, test.tested};
    };
    const uint32_t asked = first;
    if (asked < kPlanes && (mask >> asked & 1) != 0 && isOutside(asked)) return outside(asked);
    for (uint32_t p = 0; p < kPlanes; ++p) {
        if ((mask >> p & 1) == 0) continue;
        if (p != asked && isOutside(p)) return outside(p);
        if (outer(frustum.planes[p]) > margin) test.planes &= ~(1u << p);
    }
    return test;
}

class GroupWalk {
public:
    GroupWalk(const InstanceOctree& octree, const Scene& scene, const View& view, Trace* trace, const OctreeWalkOptions& options)
        : m_octree(octree),
          m_scene(scene),
          m_frustum(view.frustum()),
          m_eye(view.eye()),
          m_trace(trace),
          m_memory(trace == nullptr ? options.memory : nullptr),
          m_refine(options.refine) {}

    /// Recursive, at most InstanceOctree::kMaxDepth calls deep.
    void visit(uint32_t number, uint32_t mask) {
        const InstanceOctree::Node& node = m_octree.nodes()[number];
        ++figures.nodesVisited;
        const EyeBox box = relativeToEye(node.box, m_eye);
        const double margin = marginFromEye(node.box.centre(), box.centre, glm::length(box.halfExtent), m_eye);
        uint8_t unknown = LastFailedPlanes::kNone;
        MaskedTest test = testPlanes(
            m_frustum, mask, margin, m_memory != nullptr ? m_memory->ofGroup(number) : unknown,
            [&](const Plane& plane) { return pVertexDistance(plane, box); },
            [&](const Plane& plane) { return plane.distance(box.centre) - glm::dot(glm::abs(plane.normal), box.halfExtent); });
        figures.planesTested += test.tested;
        if (needsAxes(test)) test.outside = separated(m_frustum, box, margin);
        if (m_trace != nullptr) record(number, test, margin);
        if (test.outside)
            drop(node, test, margin);
        else if (test.planes == 0)
            for (const uint32_t instance : m_octree.instancesOf(node)) kept.push_back({instance, 0});
        else if (node.leaf())
            for (const uint32_t instance : m_octree.instancesOf(node)) testObject(instance, test.planes);
        else
            for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child) visit(child, test.planes);
    }

    std::vector<KeptObject> kept;
    OctreeWalkCounters figures;

private:
    /// Whether separating axes are to be tested after the planes; counts the test.
    bool needsAxes(const MaskedTest& test) {
        if (!m_refine || test.outside || !mayBeSeparated(test.planes)) return false;
        ++figures.axesTested;
        return true;
    }

    void testObject(uint32_t instance, uint32_t mask) {
        ++figures.objectsTested;
        const EyeBounds bounds = boundsFromEye(m_scene, instance, m_eye);
        uint8_t unknown = LastFailedPlanes::kNone;
        MaskedTest test = testPlanes(
            m_frustum, mask, bounds.margin, m_memory != nullptr ? m_memory->ofObject(instance) : unknown,
            [&](const Plane& plane) { return farthestInside(plane, bounds); },
            [&](const Plane& plane) { return farthestOutside(plane, bounds); });
        figures.planesTested += test.tested;
        if (needsAxes(test))
            test.outside = separated(m_frustum, bounds.box, bounds.margin) || separated(m_frustum, bounds.sphere, bounds.margin);
        if (!test.outside) return kept.push_back({instance, uint8_t(test.planes)});
        ++figures.objectsCulled;
        figures.trianglesCulled += m_scene.meshOf(instance).triangleCount();
        if (m_trace != nullptr) reject(instance, test, bounds.margin);
    }

    void drop(const InstanceOctree::Node& node, const MaskedTest& test, double margin) {
        figures.objectsCulled += node.count;
        figures.trianglesCulled += node.triangles;
        if (m_trace == nullptr) return;
        for (const uint32_t instance : m_octree.instancesOf(node)) {
            const EyeBounds bounds = boundsFromEye(m_scene, instance, m_eye);
            MaskedTest own = test;
            // The object lies in the group's box and is outside with it; its own distance and margin may differ in the last
            // digits.
            if (test.byPlane)
                own.distance = std::min(farthestInside(m_frustum.planes[size_t(test.plane)], bounds), test.distance);
            else
                findOwnPlane(bounds, own);
            reject(instance, own, std::min(bounds.margin, margin));
        }
    }

    /// The group as a whole is outside no single plane, but this object of it may be.
    void findOwnPlane(const EyeBounds& bounds, MaskedTest& test) const {
        for (uint32_t p = 0; p < kPlanes && !test.byPlane; ++p) {
            test.distance = farthestInside(m_frustum.planes[p], bounds);
            test.byPlane = test.distance < -bounds.margin;
            test.plane = static_cast<FrustumPlane>(p);
        }
    }

    void reject(uint32_t instance, const MaskedTest& test, double bound) {
        TraceEvent event{test.byPlane ? TraceEvent::Kind::TestedPlane : TraceEvent::Kind::TestedAxes, instance, test.plane};
        event.containment = Containment::Outside;
        event.distance = test.byPlane ? test.distance : 0.0;
        event.bound = bound;
        m_trace->events.push_back(event);
        m_trace->events.push_back({TraceEvent::Kind::Culled, instance});
    }

    void record(uint32_t number, const MaskedTest& test, double margin) {
        if (test.outside && test.byPlane)
            m_trace->groups.push_back({number, Containment::Outside, test.plane, test.distance, margin, true});
        else if (test.outside)
            m_trace->groups.push_back({number, Containment::Outside, {}, 0.0, margin, true});
        else if (test.planes == 0)
            m_trace->groups.push_back({number, Containment::Inside, {}, 0.0, 0.0, true});
        else
            m_trace->groups.push_back({number});
    }

    const InstanceOctree& m_octree;
    const Scene& m_scene;
    const Frustum& m_frustum;
    Vec3 m_eye;
    Trace* m_trace;
    LastFailedPlanes* m_memory;
    bool m_refine;
};

SnapshotNode groupOf(const InstanceOctree::Node& node, const TestedGroup* tested, const SnapshotNode* parent) {
    SnapshotNode group;
    group.instance = SnapshotNode::kGroup;
    group.objects = node.count;
    group.box = node.box;
    group.triangles = node.triangles;
    if (tested != nullptr) {
        group.containment = tested->containment;
        group.culled = tested->containment == Containment::Outside;
        if (group.culled) group.rejectedBy = tested->plane;
    } else if (parent != nullptr) {
        group.containment = parent->containment;
        group.culled = parent->culled;
        group.rejectedBy = parent->rejectedBy;
    }
    return group;
}

}  // namespace

std::vector<KeptObject> keptObjects(const InstanceOctree& octree, const Scene& scene, const View& view,
                                    OctreeWalkCounters* figures, Trace* trace, const OctreeWalkOptions& options) {
    GroupWalk walk(octree, scene, view, trace, options);
    if (!octree.nodes().empty()) walk.visit(0, kAllPlanes);
    if (figures != nullptr) {
        figures->nodesVisited += walk.figures.nodesVisited;
        figures->objectsTested += walk.figures.objectsTested;
        figures->planesTested += walk.figures.planesTested;
        figures->axesTested += walk.figures.axesTested;
        figures->objectsCulled += walk.figures.objectsCulled;
        figures->trianglesCulled += walk.figures.trianglesCulled;
    }
    return std::move(walk.kept);
}

void sortNearestFirst(std::vector<KeptObject>& kept, const Scene& scene, const Vec3& eye) {
    std::vector<std::pair<double, KeptObject>> byDistance;
    byDistance.reserve(kept.size());
    for (const KeptObject& object : kept) {
        const Sphere& sphere = scene.instanceSphere(object.instance);
        byDistance.emplace_back(glm::length(sphere.centre - eye) - sphere.radius, object);
    }
    std::ranges::stable_sort(byDistance, {}, &std::pair<double, KeptObject>::first);
    std::ranges::transform(byDistance, kept.begin(), &std::pair<double, KeptObject>::second);
}

void addGroups(StructureSnapshot& snapshot, const InstanceOctree& octree, const Scene& scene, const Trace& trace) {
    const auto base = int32_t(snapshot.nodes.size());
    std::vector<const TestedGroup*> tested(octree.nodes().size(), nullptr);
    for (const TestedGroup& group : trace.groups) tested[group.node] = &group;
    std::vector<int32_t> leafOf(scene.instances().size(), -1);
    snapshot.nodes.reserve(snapshot.nodes.size() + octree.nodes().size());
    for (size_t i = 0; i < octree.nodes().size(); ++i) {
        const InstanceOctree::Node& node = octree.nodes()[i];
        const int32_t parent = node.parent < 0 ? -1 : base + node.parent;
        snapshot.nodes.push_back(groupOf(node, tested[i], parent < 0 ? nullptr : &snapshot.nodes[size_t(parent)]));
        snapshot.nodes.back().parent = parent;
        if (!node.leaf()) continue;
        for (const uint32_t instance : octree.instancesOf(node)) leafOf[instance] = base + int32_t(i);
    }
    for (size_t i = 0; i < size_t(base); ++i)
        if (!snapshot.nodes[i].isGroup()) snapshot.nodes[i].parent = leafOf[snapshot.nodes[i].instance];
}

}  // namespace cullscope
