#include "core/visibility/occlusion/node_walk.h"

#include <algorithm>
#include <array>

#include "core/geometry/separation.h"
#include "core/visibility/eye_bounds.h"
#include "core/visibility/occlusion/occluders.h"

namespace cullscope::occlusion {

NodeWalk::NodeWalk(const InstanceOctree& octree, FrameContext& frame, const NodeWalkLines& lines)
    : m_octree(octree),
      m_frame(frame),
      m_frustum(frame.view().frustum()),
      m_eye(frame.view().eye()),
      m_recording(frame.recording()),
      m_lines(lines),
      m_progress{nullptr, frame.stop()},
      m_work(m_progress) {}

void NodeWalk::visited() {
    ++m_visited;
    m_work.step();
}

void NodeWalk::worked(size_t steps) {
    for (size_t step = 0; step < steps; ++step) m_work.step();
}

void NodeWalk::countVisited() {
    m_frame.counters().nodesVisited = m_visited;
    m_frame.counters().bytesTouched = m_visited * sizeof(Node);
}

std::optional<GrownBox> NodeWalk::boxInFrustum(NodeEntry& entry) {
    const Box3& world = node(entry.node).box;
    const EyeBox box = relativeToEye(world, m_eye);
    const double margin = marginFromEye(world.centre(), box.centre, glm::length(box.halfExtent), m_eye);
    if (isOutside(entry, box, margin)) {
        leaveOut(entry.node, m_lines.outside, Cause::OutsideFrustum);
        return std::nullopt;
    }
    return grown(world);
}

bool NodeWalk::isOutside(NodeEntry& entry, const EyeBox& box, double margin) {
    const Subject subject = Subject::ofNode(entry.node);
    bool outside = false;
    const uint32_t planes = entry.planes;
    for (uint32_t p = 0; p < kPlanes && !outside; ++p) {
        if ((planes >> p & 1) == 0) continue;
        const Plane& plane = m_frustum.planes[p];
        const double inner = pVertexDistance(plane, box);
        const double outer = plane.distance(box.centre) - glm::dot(glm::abs(plane.normal), box.halfExtent);
        outside = inner < -margin;
        if (outer > margin) entry.planes &= ~(1u << p);
        if (m_recording)
            say(entry.node, atLine(m_lines.frustum, planeTest(subject, FrustumPlane(p), inner, outside ? inner : outer, margin)));
    }
    if (!outside && mayBeSeparated(entry.planes)) {
        outside = separated(m_frustum, box, margin);
        if (m_recording) say(entry.node, atLine(m_lines.frustum, axisTest(subject, outside, margin)));
    }
    return outside;
}

bool NodeWalk::visibleUnasked(uint32_t number, const GrownBox& box) {
    if (m_anything && canBeAskedAbout(box)) return false;
    const char* reason =
        m_anything ? CULLSCOPE_TR("Its box, grown by %1, reaches before the near plane: it counts as visible without asking.")
                   : CULLSCOPE_TR("Nothing is drawn yet that could hide its box: it counts as visible without asking.");
    if (m_recording) say(number, atLine(m_lines.unasked, result(number, true, reason, {box.growth})));
    return true;
}

Nearness NodeWalk::nearness(uint32_t number) const {
    const EyeBox box = relativeToEye(node(number).box, m_eye);
    const Vec3 beyond = glm::max(glm::abs(box.centre) - box.halfExtent, Vec3(0.0));
    return {glm::dot(beyond, beyond), glm::dot(box.centre, box.centre)};
}

void NodeWalk::gather(uint32_t leaf) {
    for (const uint32_t instance : m_octree.instancesOf(node(leaf))) {
        m_work.step();
        m_gathered.push_back({instance, 0, uint32_t(m_frame.scene().meshOf(instance).indices().size())});
        if (!m_recording) continue;
        Decision drawn = atLine(m_lines.draw, ending(Subject::ofObject(instance), Decision::Outcome::Drawn));
        drawn.nesting = uint8_t(node(leaf).depth + 1);
        m_frame.say(drawn);
    }
    m_anything = true;
}

void NodeWalk::drawGathered() {
    if (m_gathered.empty()) return;
    m_frame.draw({m_frame.facing(), std::move(m_gathered)});
    m_gathered.clear();
}

void NodeWalk::leaveOut(uint32_t number, uint8_t line, Cause cause) {
    m_frame.counters().culledTriangles[size_t(cause)] += node(number).triangles;
    if (!m_recording) return;
    Decision decision = atLine(line, ending(Subject::ofNode(number), Decision::Outcome::Culled, cause));
    open(number);
    decision.nesting = node(number).depth;
    m_frame.say(decision, m_octree.instancesOf(node(number)));
}

Decision NodeWalk::result(uint32_t number, bool visible, const char* sentence, std::initializer_list<double> operands) {
    Decision decision = hidingTest(!visible, sentence, operands);
    decision.subject = Subject::ofNode(number);
    return decision;
}

void NodeWalk::say(uint32_t number, Decision decision) {
    open(number);
    decision.nesting = node(number).depth;
    m_frame.say(decision);
}

void NodeWalk::open(uint32_t number) {
    std::array<uint32_t, InstanceOctree::kMaxDepth + 1> around{};
    const size_t depth = node(number).depth;
    uint32_t outer = number;
    for (size_t level = depth; level > 0; --level) around[level - 1] = outer = uint32_t(node(outer).parent);
    for (size_t level = 0; level < depth; ++level) {
        if (level < m_open.size() && m_open[level].node == around[level] && m_open[level].parts) continue;
        Decision parts =
            atLine(m_lines.parts,
                   result(around[level], true, CULLSCOPE_TR("The box counts as visible: its parts are visited, nearest first.")));
        parts.nesting = uint8_t(level);
        m_frame.say(parts);
        m_open.resize(level);
        m_open.push_back({around[level], true});
    }
    m_open.resize(depth);
    m_open.push_back({number, false});
}

}  // namespace cullscope::occlusion
