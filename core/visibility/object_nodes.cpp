#include "core/visibility/object_nodes.h"

#include <algorithm>
#include <map>

namespace cullscope {
namespace {

class ObjectNodes {
public:
    ObjectNodes(const FrameLog& log, const Scene& scene) : m_log(log), m_scene(scene), m_places(scene.instances().size(), -1) {}

    void add(const Decision& decision) {
        if (decision.subject.kind == Subject::Kind::Object)
            addTo(nodeOf(decision.subject.number), decision);
        else if (decision.subject.kind == Subject::Kind::Node)
            addGroup(decision);
    }

    [[nodiscard]] StructureSnapshot take() { return std::move(m_result); }

private:
    SnapshotNode& nodeOf(uint32_t instance) {
        if (m_places[instance] < 0) {
            m_places[instance] = int64_t(m_result.nodes.size());
            SnapshotNode node;
            node.instance = instance;
            node.box = m_scene.instanceBox(instance);
            node.triangles = m_scene.meshOf(instance).triangleCount();
            node.containment = Containment::Inside;
            m_result.nodes.push_back(node);
            m_tests.emplace_back();
        }
        return m_result.nodes[size_t(m_places[instance])];
    }

    /// What the tests of one object found: planes as bits.
    struct Tests {
        uint8_t inside = 0, cutting = 0;
        bool cutOtherwise = false;  ///< by a test that is none of a plane
    };

    void addTo(SnapshotNode& node, const Decision& decision) {
        if (decision.outcome == Decision::Outcome::Culled) {
            node.culled = true;
            node.cause = decision.cause;
        }
        if (decision.outcome == Decision::Outcome::Open) addTest(node, decision);
    }

    /// An object may have several bounds that are tested against a plane one after the other, such as a sphere and a box: it is
    /// inside the plane where one of them is. Of several planes that it lies outside of, the first in their order counts.
    void addTest(SnapshotNode& node, const Decision& decision) {
        if (decision.containment == Containment::Outside) {
            const bool first = !node.rejectedBy || (decision.plane && *decision.plane < *node.rejectedBy);
            if (first) node.rejectedBy = decision.plane;
            node.containment = Containment::Outside;
            return;
        }
        Tests& tests = m_tests[size_t(m_places[node.instance])];
        const bool inside = decision.containment == Containment::Inside;
        if (decision.plane)
            (inside ? tests.inside : tests.cutting) |= uint8_t(1U << size_t(*decision.plane));
        else
            tests.cutOtherwise = tests.cutOtherwise || !inside;
        if (node.containment == Containment::Outside) return;
        const bool cut = tests.cutOtherwise || (tests.cutting & ~tests.inside) != 0;
        node.containment = cut ? Containment::Straddles : Containment::Inside;
    }

    void addGroup(const Decision& decision) {
        if (decision.outcome == Decision::Outcome::Open) {
            if (decision.containment == Containment::Outside) m_rejectedBy[decision.subject.number] = decision.plane;
            return;
        }
        for (const uint32_t instance : m_log.objectsOf(decision)) {
            if (m_scene.meshOf(instance).triangleCount() == 0) continue;
            SnapshotNode& node = nodeOf(instance);
            if (decision.outcome != Decision::Outcome::Culled) continue;
            node.culled = true;
            node.cause = decision.cause;
            node.containment = Containment::Outside;
            node.rejectedBy = m_rejectedBy[decision.subject.number];
        }
    }

    const FrameLog& m_log;
    const Scene& m_scene;
    std::vector<int64_t> m_places;                                 ///< by instance: its node; -1: none yet
    std::vector<Tests> m_tests;                                    ///< by node
    std::map<uint32_t, std::optional<FrustumPlane>> m_rejectedBy;  ///< by group: the plane that it lies outside of
    StructureSnapshot m_result;
};

}  // namespace

StructureSnapshot objectNodes(const FrameLog& log, const Scene& scene) {
    ObjectNodes nodes(log, scene);
    for (const Decision& decision : log.decisions) nodes.add(decision);
    return nodes.take();
}

void sayBegin(FrameContext& frame, uint8_t line, const char* sentence, std::initializer_list<double> operands) {
    if (!frame.recording()) return;
    Decision begin;
    begin.subject = Subject::ofNode(0);
    begin.sentence = sentence;
    std::ranges::copy(operands, begin.operands.begin());
    begin.operandCount = uint8_t(operands.size());
    frame.say(atLine(line, begin));
}

void sayObjectsAreDrawn(FrameContext& frame) {
    for (uint32_t i = 0; i < frame.scene().instances().size(); ++i)
        if (frame.scene().meshOf(i).triangleCount() > 0) frame.say(ending(Subject::ofObject(i), Decision::Outcome::Drawn));
}

}  // namespace cullscope
