#include "core/visibility/octree_walk.h"

#include <algorithm>

#include "core/geometry/separation.h"
#include "core/visibility/eye_bounds.h"

namespace cullscope {
namespace {

constexpr uint32_t kPlanes = 6;

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
    GroupWalk(const GroupTree& tree, FrameContext& frame, const OctreeWalkOptions& options)
        : m_tree(tree),
          m_frame(frame),
          m_scene(frame.scene()),
          m_frustum(frame.view().frustum()),
          m_eye(frame.view().eye()),
          m_recording(frame.recording()),
          m_memory(options.memory),
          m_refine(options.refine),
          m_lines(options.lines),
          m_options(options) {}

    /// Recursive, at most InstanceOctree::kMaxDepth calls deep.
    void visit(uint32_t number, uint32_t mask) {
        const InstanceOctree::Node& node = m_tree.nodes[number];
        ++counters.nodesVisited;
        const Box3& tested = m_tree.boxOf(number);
        const EyeBox box = relativeToEye(tested, m_eye);
        const double margin = marginFromEye(tested.centre(), box.centre, glm::length(box.halfExtent), m_eye);
        const Subject subject = subjectOf(number);
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
        else if (m_options.visited && !m_options.visited(number, test.planes))
            return;
        else if (test.planes == 0 && !m_options.visited)
            keep(number, node);
        else
            visitParts(node, test.planes);
    }

    std::vector<KeptObject> kept;
    OctreeWalkCounters counters;

private:
    void visitParts(const InstanceOctree::Node& node, uint32_t planes) {
        const auto visitPart = [&](uint32_t part) {
            if (node.leaf())
                testObject(part, planes, uint8_t(node.depth + 1));
            else
                visit(part, planes);
        };
        if (!m_options.nearestFirst) {
            for (uint32_t i = 0; i < (node.leaf() ? node.count : node.childCount); ++i) visitPart(partOf(node, i));
            return;
        }
        std::vector<std::pair<double, uint32_t>> parts;
        for (uint32_t i = 0; i < (node.leaf() ? node.count : node.childCount); ++i) {
            const uint32_t part = partOf(node, i);
            const Box3& box = node.leaf() ? m_scene.instanceBox(part) : m_tree.boxOf(part);
            const Vec3 beyond = glm::max(glm::max(box.min - m_eye, m_eye - box.max), Vec3(0.0));
            parts.emplace_back(glm::dot(beyond, beyond), part);
        }
        std::ranges::stable_sort(parts, {}, &std::pair<double, uint32_t>::first);
        for (const auto& [distance, part] : parts) visitPart(part);
    }
    /// A child of a node, or an object of a leaf.
    [[nodiscard]] uint32_t partOf(const InstanceOctree::Node& node, uint32_t i) const {
        return node.leaf() ? m_tree.instancesOf(node)[i] : node.firstChild + i;
    }

    /// Whether separating axes are to be tested after the planes; counts the test.
    bool needsAxes(const MaskedTest& test) {
        if (!m_refine || test.outside || !mayBeSeparated(test.planes)) return false;
        ++counters.axesTested;
        return true;
    }

    void testObject(uint32_t instance, uint32_t mask, uint8_t depth) {
        if (mask == 0) return keepObject(instance, 0, depth);
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
        if (!test.outside) return keepObject(instance, uint8_t(test.planes), depth);
        ++counters.objectsCulled;
        counters.trianglesCulled += m_scene.meshOf(instance).triangleCount();
        if (m_recording) say(m_lines.objectOutside, ending(subject, Decision::Outcome::Culled), depth);
    }

    void keepObject(uint32_t instance, uint8_t planes, uint8_t depth) {
        if (!m_options.keeps || m_options.keeps(instance, depth)) kept.push_back({instance, planes});
    }

    void drop(uint32_t number, const InstanceOctree::Node& node) {
        counters.objectsCulled += node.count;
        counters.trianglesCulled += node.triangles;
        if (m_recording) end(number, node, Decision::Outcome::Culled);
    }

    void keep(uint32_t number, const InstanceOctree::Node& node) {
        for (const uint32_t instance : m_tree.instancesOf(node)) kept.push_back({instance, 0});
        if (m_recording) end(number, node, Decision::Outcome::Drawn);
    }

    void end(uint32_t number, const InstanceOctree::Node& node, Decision::Outcome outcome) {
        const uint8_t line = outcome == Decision::Outcome::Culled ? m_lines.groupOutside : m_lines.groupInside;
        Decision decision = atLine(line, ending(subjectOf(number), outcome));
        decision.nesting = node.depth;
        m_frame.say(decision, m_tree.instancesOf(node));
    }

    void say(uint8_t line, Decision decision, uint8_t depth) {
        decision.line = line;
        decision.nesting = depth;
        m_frame.say(decision);
    }

    [[nodiscard]] Subject subjectOf(uint32_t node) const { return Subject::ofNode(m_tree.firstNumber + node); }

    const GroupTree& m_tree;
    FrameContext& m_frame;
    const Scene& m_scene;
    const Frustum& m_frustum;
    Vec3 m_eye;
    bool m_recording;
    LastFailedPlanes* m_memory;
    bool m_refine;
    OctreeWalkLines m_lines;
    const OctreeWalkOptions& m_options;
};

/// What a recorded walk found for a group.
struct GroupResult {
    bool visited = false;
    Containment containment = Containment::Straddles;
    Cause cause = Cause::OutsideFrustum;
    std::optional<FrustumPlane> rejectedBy;
};

std::vector<GroupResult> groupResults(const FrameLog& log, uint32_t first, size_t groups) {
    std::vector<GroupResult> results(groups);
    for (const Decision& decision : log.decisions) {
        if (decision.subject.kind != Subject::Kind::Node || decision.subject.number - first >= groups) continue;
        GroupResult& result = results[decision.subject.number - first];
        result.visited = true;
        if (decision.outcome == Decision::Outcome::Drawn) result.containment = Containment::Inside;
        if (decision.containment != Containment::Outside) continue;
        result.containment = Containment::Outside;
        result.cause = decision.cause;
        if (decision.plane) result.rejectedBy = decision.plane;
    }
    return results;
}

SnapshotNode groupOf(const InstanceOctree::Node& node, const Box3& box, const GroupResult& result, const SnapshotNode* parent) {
    SnapshotNode group;
    group.instance = SnapshotNode::kGroup;
    group.objects = node.count;
    group.box = box;
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

std::vector<KeptObject> keptObjects(const GroupTree& tree, FrameContext& frame, OctreeWalkCounters* counters,
                                    const OctreeWalkOptions& options) {
    GroupWalk walk(tree, frame, options);
    if (options.from.empty() && !tree.nodes.empty()) walk.visit(0, NodeEntry::kAllPlanes);
    for (const NodeEntry& entry : options.from) walk.visit(entry.node, entry.planes);
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

void addGroups(StructureSnapshot& snapshot, const GroupTree& tree, const Scene& scene, const FrameLog& log) {
    const size_t base = snapshot.nodes.size();
    const std::vector<GroupResult> results = groupResults(log, tree.firstNumber, tree.nodes.size());
    std::vector<int32_t> leafOf(scene.instances().size(), -1);
    snapshot.nodes.reserve(base + tree.nodes.size());
    for (size_t i = 0; i < tree.nodes.size(); ++i) {
        const InstanceOctree::Node& node = tree.nodes[i];
        const int32_t parent = node.parent < 0 ? -1 : int32_t(base) + node.parent;
        snapshot.nodes.push_back(
            groupOf(node, tree.boxOf(uint32_t(i)), results[i], parent < 0 ? nullptr : &snapshot.nodes[size_t(parent)]));
        SnapshotNode& group = snapshot.nodes.back();
        group.parent = parent;
        group.number = tree.firstNumber + uint32_t(i);
        if (parent < 0 && tree.name != nullptr) group.name = tree.name;
        if (!node.leaf()) continue;
        for (const uint32_t instance : tree.instancesOf(node)) leafOf[instance] = int32_t(base + i);
    }
    for (size_t i = 0; i < base; ++i) {
        SnapshotNode& object = snapshot.nodes[i];
        if (!object.isGroup() && leafOf[object.instance] >= 0) object.parent = leafOf[object.instance];
    }
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
