#include "core/visibility/group_walk.h"

#include "core/visibility/eye_bounds.h"

namespace cullscope {
namespace {

constexpr uint32_t kPlanes = 6;
constexpr uint32_t kAllPlanes = (1u << kPlanes) - 1;

/// What the planes of a mask say of something.
struct MaskedTest {
    uint32_t planes = 0;  ///< of the mask, those that may cut it
    bool outside = false;
    FrustumPlane plane = FrustumPlane::Left;  ///< where outside
    double distance = 0.0;                    ///< the same
    uint32_t tested = 0;
};

/// `inner` and `outer` give the signed distances of the points farthest inside and farthest outside a plane. NaN decides nothing.
template <typename Inner, typename Outer>
MaskedTest testPlanes(const Frustum& frustum, uint32_t mask, double slack, const Inner& inner, const Outer& outer) {
    MaskedTest test{mask};
    for (uint32_t p = 0; p < kPlanes; ++p) {
        if ((mask >> p & 1) == 0) continue;
        const double distance = inner(frustum.planes[p]);
        ++test.tested;
        if (distance < -slack) return {mask, true, static_cast<FrustumPlane>(p), distance, test.tested};
        if (outer(frustum.planes[p]) > slack) test.planes &= ~(1u << p);
    }
    return test;
}

class GroupWalk {
public:
    GroupWalk(const InstanceOctree& octree, const Scene& scene, const View& view, Trace* trace)
        : m_octree(octree), m_scene(scene), m_frustum(view.frustum()), m_eye(view.eye()), m_trace(trace) {}

    /// At most InstanceOctree::kMaxDepth calls deep.
    void visit(uint32_t number, uint32_t mask) {
        const InstanceOctree::Node& node = m_octree.nodes()[number];
        ++figures.nodesVisited;
        const EyeBox box = relativeToEye(node.box, m_eye);
        const double slack = slackFromEye(node.box.centre(), box.centre, glm::length(box.half), m_eye);
        const MaskedTest test = testPlanes(
            m_frustum, mask, slack, [&](const Plane& plane) { return pVertexDistance(plane, box); },
            [&](const Plane& plane) { return plane.distance(box.centre) - glm::dot(glm::abs(plane.normal), box.half); });
        figures.planesTested += test.tested;
        if (m_trace != nullptr) record(number, test, slack);
        if (test.outside)
            drop(node, test, slack);
        else if (test.planes == 0)
            for (const uint32_t instance : m_octree.instancesOf(node)) kept.push_back({instance, 0});
        else if (node.leaf())
            for (const uint32_t instance : m_octree.instancesOf(node)) testObject(instance, test.planes);
        else
            for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child) visit(child, test.planes);
    }

    std::vector<KeptObject> kept;
    GroupWalkFigures figures;

private:
    void testObject(uint32_t instance, uint32_t mask) {
        ++figures.objectsTested;
        const EyeBounds bounds = boundsFromEye(m_scene, instance, m_eye);
        const MaskedTest test = testPlanes(
            m_frustum, mask, bounds.slack, [&](const Plane& plane) { return farthestInside(plane, bounds); },
            [&](const Plane& plane) { return farthestOutside(plane, bounds); });
        figures.planesTested += test.tested;
        if (!test.outside) return kept.push_back({instance, uint8_t(test.planes)});
        ++figures.objectsCulled;
        figures.trianglesCulled += m_scene.meshOf(instance).triangleCount();
        if (m_trace != nullptr) reject(instance, test.plane, test.distance, bounds.slack);
    }

    void drop(const InstanceOctree::Node& node, const MaskedTest& test, double slack) {
        figures.objectsCulled += node.count;
        figures.trianglesCulled += node.triangles;
        if (m_trace == nullptr) return;
        for (const uint32_t instance : m_octree.instancesOf(node)) {
            const EyeBounds bounds = boundsFromEye(m_scene, instance, m_eye);
            // The object lies in the group's box and is outside with it, whatever the last digits of its own distance or slack.
            reject(instance, test.plane, std::min(farthestInside(m_frustum.planes[size_t(test.plane)], bounds), test.distance),
                   std::min(bounds.slack, slack));
        }
    }

    void reject(uint32_t instance, FrustumPlane plane, double distance, double bound) {
        m_trace->events.push_back(
            {TraceEvent::Kind::TestedPlane, instance, plane, Containment::Outside, distance, Cause::OutsideFrustum, bound});
        m_trace->events.push_back({TraceEvent::Kind::Culled, instance});
    }

    void record(uint32_t number, const MaskedTest& test, double slack) {
        if (test.outside)
            m_trace->groups.push_back({number, Containment::Outside, test.plane, test.distance, slack, true});
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
};

InsideNode groupOf(const InstanceOctree::Node& node, const TestedGroup* tested, const InsideNode* parent) {
    InsideNode group;
    group.instance = InsideNode::kGroup;
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

std::vector<KeptObject> keptObjects(const InstanceOctree& octree, const Scene& scene, const View& view, GroupWalkFigures* figures,
                                    Trace* trace) {
    GroupWalk walk(octree, scene, view, trace);
    if (!octree.nodes().empty()) walk.visit(0, kAllPlanes);
    if (figures != nullptr) {
        figures->nodesVisited += walk.figures.nodesVisited;
        figures->objectsTested += walk.figures.objectsTested;
        figures->planesTested += walk.figures.planesTested;
        figures->objectsCulled += walk.figures.objectsCulled;
        figures->trianglesCulled += walk.figures.trianglesCulled;
    }
    return std::move(walk.kept);
}

void addGroups(Inside& inside, const InstanceOctree& octree, const Scene& scene, const Trace& trace) {
    const auto base = int32_t(inside.nodes.size());
    std::vector<const TestedGroup*> tested(octree.nodes().size(), nullptr);
    for (const TestedGroup& group : trace.groups) tested[group.node] = &group;
    std::vector<int32_t> leafOf(scene.instances().size(), -1);
    inside.nodes.reserve(inside.nodes.size() + octree.nodes().size());
    for (size_t i = 0; i < octree.nodes().size(); ++i) {
        const InstanceOctree::Node& node = octree.nodes()[i];
        const int32_t parent = node.parent < 0 ? -1 : base + node.parent;
        inside.nodes.push_back(groupOf(node, tested[i], parent < 0 ? nullptr : &inside.nodes[size_t(parent)]));
        inside.nodes.back().parent = parent;
        if (!node.leaf()) continue;
        for (const uint32_t instance : octree.instancesOf(node)) leafOf[instance] = base + int32_t(i);
    }
    for (size_t i = 0; i < size_t(base); ++i)
        if (!inside.nodes[i].isGroup()) inside.nodes[i].parent = leafOf[inside.nodes[i].instance];
}

}  // namespace cullscope
