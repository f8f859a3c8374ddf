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
/// nothing. `tell(plane, inner, outer)` hears of every test when it is made (of the plane that rejects, `outer` is the inner
/// distance).
template <typename Inner, typename Outer, typename Tell>
MaskedTest testPlanes(const Frustum& frustum, uint32_t mask, double margin, uint8_t& first, const Inner& inner,
                      const Outer& outer, const Tell& tell) {
    MaskedTest test{mask};
    const auto rejects = [&](uint32_t p) {
        test.distance = inner(frustum.planes[p]);
        ++test.tested;
        if (test.distance < -margin) {
            first = uint8_t(p);
            test.outside = test.byPlane = true;
            test.plane = static_cast<FrustumPlane>(p);
            tell(test.plane, test.distance, test.distance);
            return true;
        }
        const double farthest = outer(frustum.planes[p]);
        if (farthest > margin) test.planes &= ~(1u << p);
        tell(static_cast<FrustumPlane>(p), test.distance, farthest);
        return false;
    };
    uint32_t left = mask;
    if (first < kPlanes && (mask >> first & 1) != 0) {
        const uint32_t asked = first;
        if (rejects(asked)) return test;
        left &= ~(1u << asked);
    }
    for (uint32_t p = 0; p < kPlanes; ++p)
        if ((left >> p & 1) != 0 && rejects(p)) return test;
    return test;
}

class GroupWalk {
public:
    GroupWalk(const InstanceOctree& octree, FrameContext& frame, const OctreeWalkOptions& options)
        : m_octree(octree),
          m_frame(frame),
          m_scene(frame.scene()),
          m_frustum(frame.view().frustum()),
          m_eye(frame.view().eye()),
          m_recording(frame.recording()),
          m_memory(options.memory),
          m_refine(options.refine),
          m_lines(options.lines) {}

    /// Recursive, at most InstanceOctree::kMaxDepth calls deep.
    void visit(uint32_t number, uint32_t mask) {
        const InstanceOctree::Node& node = m_octree.nodes()[number];
        ++counters.nodesVisited;
        const EyeBox box = relativeToEye(node.box, m_eye);
        const double margin = marginFromEye(node.box.centre(), box.centre, glm::length(box.halfExtent), m_eye);
        const Subject subject = Subject::ofNode(number);
        uint8_t unknown = LastFailedPlanes::kNone;
        MaskedTest test = testPlanes(
            m_frustum, mask, margin, m_memory != nullptr ? m_memory->ofGroup(number) : unknown,
            [&](const Plane& plane) { return pVertexDistance(plane, box); },
            [&](const Plane& plane) { return plane.distance(box.centre) - glm::dot(glm::abs(plane.normal), box.halfExtent); },
            [&](FrustumPlane plane, double inner, double outer) {
                if (m_recording) say(m_lines.groupPlanes, planeTest(subject, plane, inner, outer, margin), node.depth);
            });
        counters.planesTested += test.tested;
        if (needsAxes(test)) {
            test.outside = separated(m_frustum, box, margin);
            if (m_recording) say(m_lines.groupAxes, axisTest(subject, test.outside, margin), node.depth);
        }
        if (test.outside)
            drop(number, node);
        else if (test.planes == 0)
            keep(number, node);
        else if (node.leaf())
            for (const uint32_t instance : m_octree.instancesOf(node)) testObject(instance, test.planes, uint8_t(node.depth + 1));
        else
            for (uint32_t child = node.firstChild; child < node.firstChild + node.childCount; ++child) visit(child, test.planes);
    }

    std::vector<KeptObject> kept;
    OctreeWalkCounters counters;

private:
    /// Whether separating axes are to be tested after the planes; counts the test.
    bool needsAxes(const MaskedTest& test) {
        if (!m_refine || test.outside || !mayBeSeparated(test.planes)) return false;
        ++counters.axesTested;
        return true;
    }

    void testObject(uint32_t instance, uint32_t mask, uint8_t depth) {
        ++counters.objectsTested;
        const EyeBounds bounds = boundsFromEye(m_scene, instance, m_eye);
        const Subject subject = Subject::ofObject(instance);
        uint8_t unknown = LastFailedPlanes::kNone;
        MaskedTest test = testPlanes(
            m_frustum, mask, bounds.margin, m_memory != nullptr ? m_memory->ofObject(instance) : unknown,
            [&](const Plane& plane) { return farthestInside(plane, bounds); },
            [&](const Plane& plane) { return farthestOutside(plane, bounds); },
            [&](FrustumPlane plane, double inner, double outer) {
                if (m_recording) say(m_lines.objectTests, planeTest(subject, plane, inner, outer, bounds.margin), depth);
            });
        counters.planesTested += test.tested;
        if (needsAxes(test)) {
            test.outside = separated(m_frustum, bounds.box, bounds.margin) || separated(m_frustum, bounds.sphere, bounds.margin);
            if (m_recording) say(m_lines.objectTests, axisTest(subject, test.outside, bounds.margin), depth);
        }
        if (!test.outside) return kept.push_back({instance, uint8_t(test.planes)});
        ++counters.objectsCulled;
        counters.trianglesCulled += m_scene.meshOf(instance).triangleCount();
        if (m_recording) say(m_lines.objectOutside, ending(subject, Decision::Outcome::Culled), depth);
    }

    void drop(uint32_t number, const InstanceOctree::Node& node) {
        counters.objectsCulled += node.count;
        counters.trianglesCulled += node.triangles;
        if (m_recording) end(number, node, Decision::Outcome::Culled);
    }

    void keep(uint32_t number, const InstanceOctree::Node& node) {
        for (const uint32_t instance : m_octree.instancesOf(node)) kept.push_back({instance, 0});
        if (m_recording) end(number, node, Decision::Outcome::Drawn);
    }

    void end(uint32_t number, const InstanceOctree::Node& node, Decision::Outcome outcome) {
        const uint8_t line = outcome == Decision::Outcome::Culled ? m_lines.groupOutside : m_lines.groupInside;
        Decision decision = atLine(line, ending(Subject::ofNode(number), outcome));
        decision.nesting = node.depth;
        m_frame.say(decision, m_octree.instancesOf(node));
    }

    void say(uint8_t line, Decision decision, uint8_t depth) {
        decision.line = line;
        decision.nesting = depth;
        m_frame.say(decision);
    }

    const InstanceOctree& m_octree;
    FrameContext& m_frame;
    const Scene& m_scene;
    const Frustum& m_frustum;
    Vec3 m_eye;
    bool m_recording;
    LastFailedPlanes* m_memory;
    bool m_refine;
    OctreeWalkLines m_lines;
};

/// What a recorded walk found for a group.
struct GroupResult {
    bool visited = false;
    Containment containment = Containment::Straddles;
    Cause cause = Cause::OutsideFrustum;
    std::optional<FrustumPlane> rejectedBy;
};

std::vector<GroupResult> groupResults(const FrameLog& log, size_t groups) {
    std::vector<GroupResult> results(groups);
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind != Subject::Kind::Node) continue;
        GroupResult& result = results[decision.subject.number];
        result.visited = true;
        if (decision.outcome == Decision::Outcome::Drawn) result.containment = Containment::Inside;
        if (decision.containment != Containment::Outside) continue;
        result.containment = Containment::Outside;
        result.cause = decision.cause;
        if (decision.plane) result.rejectedBy = decision.plane;
    }
    return results;
}

SnapshotNode groupOf(const InstanceOctree::Node& node, const GroupResult& result, const SnapshotNode* parent) {
    SnapshotNode group;
    group.instance = SnapshotNode::kGroup;
    group.objects = node.count;
    group.box = node.box;
    group.triangles = node.triangles;
    if (result.visited) {
        group.containment = result.containment;
        group.culled = result.containment == Containment::Outside;
        group.cause = result.cause;
        group.rejectedBy = result.rejectedBy;
    } else if (parent != nullptr) {
        group.containment = parent->containment;
        group.culled = parent->culled;
        group.cause = parent->cause;
        group.rejectedBy = parent->rejectedBy;
    }
    return group;
}

}  // namespace

std::vector<KeptObject> keptObjects(const InstanceOctree& octree, FrameContext& frame, OctreeWalkCounters* counters,
                                    const OctreeWalkOptions& options) {
    GroupWalk walk(octree, frame, options);
    if (!octree.nodes().empty()) walk.visit(0, kAllPlanes);
    if (counters != nullptr) {
        counters->nodesVisited += walk.counters.nodesVisited;
        counters->objectsTested += walk.counters.objectsTested;
        counters->planesTested += walk.counters.planesTested;
        counters->axesTested += walk.counters.axesTested;
        counters->objectsCulled += walk.counters.objectsCulled;
        counters->trianglesCulled += walk.counters.trianglesCulled;
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

void addGroups(StructureSnapshot& snapshot, const InstanceOctree& octree, const Scene& scene, const FrameLog& log) {
    const auto base = int32_t(snapshot.nodes.size());
    const std::vector<GroupResult> results = groupResults(log, octree.nodes().size());
    std::vector<int32_t> leafOf(scene.instances().size(), -1);
    snapshot.nodes.reserve(snapshot.nodes.size() + octree.nodes().size());
    for (size_t i = 0; i < octree.nodes().size(); ++i) {
        const InstanceOctree::Node& node = octree.nodes()[i];
        const int32_t parent = node.parent < 0 ? -1 : base + node.parent;
        snapshot.nodes.push_back(groupOf(node, results[i], parent < 0 ? nullptr : &snapshot.nodes[size_t(parent)]));
        snapshot.nodes.back().parent = parent;
        snapshot.nodes.back().number = uint32_t(i);
        if (!node.leaf()) continue;
        for (const uint32_t instance : octree.instancesOf(node)) leafOf[instance] = base + int32_t(i);
    }
    for (size_t i = 0; i < size_t(base); ++i)
        if (!snapshot.nodes[i].isGroup()) snapshot.nodes[i].parent = leafOf[snapshot.nodes[i].instance];
}

NamedParts objectsByLeaf(const InstanceOctree& octree, const Scene& scene) {
    NamedParts result;
    result.leaves = size_t(std::ranges::count_if(octree.nodes(), &InstanceOctree::Node::leaf));
    if (result.leaves > NamedParts::kMostLeaves) return result;
    for (size_t number = 0; number < octree.nodes().size(); ++number) {
        if (!octree.nodes()[number].leaf()) continue;
        for (const uint32_t instance : octree.instancesOf(octree.nodes()[number]))
            result.parts.push_back({scene.instances()[instance].name, instance, result.places.size()});
        result.places.push_back(std::to_string(number));
    }
    std::ranges::sort(result.parts, {}, &NamedParts::Part::object);
    return result;
}

}  // namespace cullscope
