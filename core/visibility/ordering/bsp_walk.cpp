#include "core/visibility/ordering/bsp_walk.h"

#include <algorithm>
#include <cmath>

#include "core/base/work_check.h"
#include "core/visibility/facing.h"
#include "core/visibility/ordering/ordering.h"
#include "core/visibility/why.h"

namespace cullscope::ordering {
namespace {

/// Collects a frame's triangles in the order of the walk.
class BspFrame {
public:
    BspFrame(FrameContext& frame, const BspTree& tree, bool nearFirst)
        : m_frame(frame), m_tree(tree), m_nearFirst(nearFirst), m_progress{nullptr, frame.stop()}, m_work(m_progress) {
        m_own->facing = frame.facing();
        m_own->depth = nearFirst ? DepthRule::Nearest : DepthRule::InOrder;
        const size_t triangles = tree.drawn().triangles.size();
        m_own->positions.reserve(3 * triangles);
        m_own->normals.reserve(3 * triangles);
        m_own->triangles.reserve(triangles);
    }

    OwnTrianglesPointer walk() {
        for (const BspTree::Part& part : m_tree.flatParts()) add(part);
        m_tree.walk(
            m_frame.view().eye(), m_nearFirst, [&](uint32_t node, int side) { visit(node, side); },
            [&](uint32_t node) { show(node); });
        endRun();
        if (m_frame.recording() && m_tree.nodes().size() > kRecordedNodes)
            m_frame.sayCoarser({CULLSCOPE_TR("the first %1 nodes alone"), {std::to_string(kRecordedNodes)}});
        return m_own;
    }

private:
    [[nodiscard]] bool records(uint32_t node) const { return m_frame.recording() && node < kRecordedNodes; }

    /// Very deep nodes count as siblings: then they are left out where a listing is about one triangle.
    static Decision withNumbers(Decision decision, uint32_t depth, std::initializer_list<double> operands) {
        std::ranges::copy(operands, decision.operands.begin());
        decision.operandCount = uint8_t(operands.size());
        decision.nesting = uint8_t(std::min(depth, 255u));
        return decision;
    }

    void visit(uint32_t number, int side) {
        m_work.step();
        ++m_frame.counters().nodesVisited;
        if (!records(number)) return;
        const BspTree::Node& node = m_tree.nodes()[number];
        if (node.parent != BspTree::kNone) arrive(number, uint32_t(node.parent));
        if (node.leaf) return;
        Decision test = withNumbers(ending(Subject::ofNode(number), Decision::Outcome::Open), node.depth,
                                    {std::abs(node.plane.distance(m_frame.view().eye())), double(number)});
        test.containment = side > 0 ? Containment::Inside : side < 0 ? Containment::Outside : Containment::Straddles;
        test.sentence = CULLSCOPE_TR("The eye lies in the plane of node %2, at %1: its sides may come in any order.");
        if (side > 0) test.sentence = CULLSCOPE_TR("The eye lies %1 before the plane of node %2.");
        if (side < 0) test.sentence = CULLSCOPE_TR("The eye lies %1 behind the plane of node %2.");
        m_frame.say(atLine(BspLine::Side, test));
    }

    /// The walk goes on with a child.
    void arrive(uint32_t number, uint32_t above) {
        const BspTree::Node& parent = m_tree.nodes()[above];
        const bool front = parent.front == int32_t(number);
        const bool near = (BspTree::sideOf(parent, m_frame.view().eye()) >= 0) == front;
        Decision goesOn = withNumbers(ending(Subject::ofNode(number), Decision::Outcome::Open), m_tree.nodes()[number].depth,
                                      {double(number), double(above)});
        goesOn.sentence = near ? CULLSCOPE_TR("The walk comes to node %1, on the eye's side of the plane of node %2.")
                               : CULLSCOPE_TR("The walk comes to node %1, beyond the plane of node %2.");
        m_frame.say(atLine(near == m_nearFirst ? BspLine::FirstChild : BspLine::LastChild, goesOn));
    }

    void show(uint32_t number) {
        const BspTree::Node& node = m_tree.nodes()[number];
        const std::span<const BspTree::Part> parts = m_tree.partsOf(node);
        // What lies in one plane: in the end the lowest number is on top, as in the item buffer.
        for (size_t i = 0; i < parts.size(); ++i) {
            const BspTree::Part& part = m_nearFirst ? parts[parts.size() - 1 - i] : parts[i];
            const auto first = uint32_t(m_own->triangles.size());
            add(part);
            if (!records(number)) continue;
            Decision drawn = ending({Subject::Kind::Fragment, part.triangle, uint32_t(m_instance)}, Decision::Outcome::Drawn);
            drawn = withNumbers(drawn, node.depth + 1, {part.share, double(part.triangle), double(number)});
            drawn.sentence = part.share < 1.0 ? CULLSCOPE_TR("A part with %1 of the area of triangle %2 is drawn, with node %3.")
                                              : CULLSCOPE_TR("Triangle %2 is drawn, with node %3.");
            drawn.places = {first, part.count};
            m_frame.say(atLine(BspLine::OnPlane, drawn));
        }
    }

    void add(const BspTree::Part& part) {
        m_work.step();
        const Scene& scene = m_frame.scene();
        if (part.triangle < m_begin || part.triangle >= m_end) {
            endRun();
            m_instance = scene.instanceOf(part.triangle);
            m_begin = scene.firstTriangle(m_instance);
            m_end = m_begin + scene.meshOf(m_instance).triangleCount();
        }
        const OwnTriangles& from = m_tree.drawn();
        const auto append = [&](auto& values, const auto& source, size_t each) {
            const auto begin = source.begin() + std::ptrdiff_t(each * part.first);
            values.insert(values.end(), begin, begin + std::ptrdiff_t(each * part.count));
        };
        append(m_own->positions, from.positions, 3);
        append(m_own->normals, from.normals, 3);
        append(m_own->triangles, from.triangles, 1);
    }

    void endRun() {
        const auto end = uint32_t(m_own->triangles.size());
        if (end > m_runBegin) m_own->runs.push_back({uint32_t(m_instance), m_runBegin, end - m_runBegin});
        m_runBegin = end;
    }

    FrameContext& m_frame;
    const BspTree& m_tree;
    bool m_nearFirst;
    Progress m_progress;
    WorkCheck m_work;
    std::shared_ptr<OwnTriangles> m_own = std::make_shared<OwnTriangles>();
    size_t m_instance = 0;
    uint64_t m_begin = 0, m_end = 0;  ///< the scene triangle numbers of that instance
    uint32_t m_runBegin = 0;
};

}  // namespace

OwnTrianglesPointer walkOfFrame(FrameContext& frame, const BspTree& tree, bool nearFirst) {
    return BspFrame(frame, tree, nearFirst).walk();
}

OperandRole roleInBspWalk(const Decision& decision, size_t operand) {
    if (decision.subject.kind == Subject::Kind::Fragment)
        return operand == kNodeOfFragment ? OperandRole::Node : operand == 1 ? OperandRole::Triangle : OperandRole::Number;
    const bool goesOn = decision.line == uint8_t(BspLine::FirstChild) || decision.line == uint8_t(BspLine::LastChild);
    const bool node = goesOn || (decision.line == uint8_t(BspLine::Side) && operand == 1);
    return node ? OperandRole::Node : OperandRole::Number;
}

}  // namespace cullscope::ordering
