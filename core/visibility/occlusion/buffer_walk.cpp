#include "core/visibility/occlusion/buffer_walk.h"

#include <algorithm>

namespace cullscope::occlusion {
namespace {

class BufferWalk {
public:
    BufferWalk(const GroupTree& tree, const Occluders& occluders, const PartBoxes& parts, FrameContext& frame,
               const BufferOptions& options, OcclusionBuffer& buffer, BufferCounters& counters)
        : m_tree(tree),
          m_occluders(occluders),
          m_parts(parts),
          m_frame(frame),
          m_options(options),
          m_buffer(buffer),
          m_counters(counters),
          m_askedOf(frame.scene().instances().size(), 0) {}

    std::vector<KeptObject> run(LastFailedPlanes& memory) {
        m_buffer.begin(m_frame.view());
        OctreeWalkOptions options{true, &memory, m_options.lines.walk};
        options.nearestFirst = true;
        options.visited = [this](uint32_t node, uint32_t /*planes*/) { return visits(node); };
        options.keeps = [this](uint32_t instance, uint8_t nesting) { return keeps(instance, nesting); };
        std::vector<KeptObject> kept = keptObjects(m_tree, m_frame, &m_counters.walk, options);
        std::erase_if(kept, [this](const KeptObject& object) { return hidesNow(object.instance); });
        sortNearestFirst(kept, m_frame.scene(), m_frame.view().eye());
        return kept;
    }

private:
    bool visits(uint32_t number) {
        const InstanceOctree::Node& node = m_tree.nodes[number];
        // The box of a node with one object is the object's, about which the buffer is asked next.
        const Subject subject = Subject::ofNode(m_tree.firstNumber + number);
        if (node.count == 1 || !hides(subject, m_tree.boxOf(number), m_options.lines.group, node.depth)) return true;
        ++m_counters.hiddenNodes;
        m_counters.hiddenTriangles += node.triangles;
        if (m_frame.recording()) {
            Decision decision = atLine(m_options.lines.hidden, ending(subject, Decision::Outcome::Culled, Cause::Hidden));
            decision.nesting = node.depth;
            m_frame.say(decision, m_tree.instancesOf(node));
        }
        return false;
    }

    bool keeps(uint32_t instance, uint8_t nesting) {
        const bool hidden = asksAndLeavesOut(instance, m_options.lines.object, nesting);
        if (!hidden) occlude(instance, nesting);
        return !hidden;
    }

    /// The last question about an object that was kept: only where occluders came after it.
    bool hidesNow(uint32_t instance) {
        return m_askedOf[instance] < m_counters.occluders && asksAndLeavesOut(instance, m_options.lines.again, 0);
    }

    bool asksAndLeavesOut(uint32_t instance, uint8_t line, uint8_t nesting) {
        const Subject subject = Subject::ofObject(instance);
        if (!hides(subject, m_frame.scene().instanceBox(instance), line, nesting) && !hidesParts(instance, line, nesting))
            return false;
        ++m_counters.hiddenObjects;
        m_counters.hiddenTriangles += m_frame.scene().meshOf(instance).triangleCount();
        if (m_frame.recording()) {
            Decision decision = atLine(m_options.lines.hidden, ending(subject, Decision::Outcome::Culled, Cause::Hidden));
            decision.nesting = nesting;
            m_frame.say(decision);
        }
        return true;
    }

    void occlude(uint32_t instance, uint8_t nesting) {
        const Scene& scene = m_frame.scene();
        const OccluderMesh& mesh = m_occluders.meshes[scene.instances()[instance].mesh];
        const uint64_t left = m_options.triangles - std::min(m_options.triangles, m_buffer.counts().given);
        const auto count = std::min<size_t>(m_occluders.countFrom(scene, instance, m_frame.view(), m_options.pixels), left);
        // Its own triangles lie within its box: they do not hide it.
        m_askedOf[instance] = m_counters.occluders + (count > 0 ? 1 : 0);
        if (count == 0) return;
        ++m_counters.occluders;
        m_buffer.draw(scene, instance, m_frame.facing(), std::span(mesh.positions).first(mesh.vertices[count - 1]),
                      std::span(mesh.indices).first(3 * count));
        if (!m_frame.recording()) return;
        Decision decision;
        decision.subject = Subject::ofObject(instance);
        decision.sentence = CULLSCOPE_TR(
            "Its %1 largest triangles go into the buffer: facing the eye at its nearest point they have at least %2 pixels on "
            "average.");
        decision.operands = {double(count), m_options.pixels};
        decision.operandCount = 2;
        decision.nesting = nesting;
        m_frame.say(atLine(m_options.lines.occlude, decision));
    }

    /// Asks the buffer about a box.
    bool hides(const Subject& subject, const Box3& box, uint8_t line, uint8_t nesting) {
        if (m_buffer.empty()) {
            if (m_frame.recording())
                say(subject, line, nesting, false,
                    CULLSCOPE_TR("Nothing is in the buffer yet that could hide its box: it counts as visible."), {});
            return false;
        }
        ++m_counters.questions;
        const AskedBox asked = askedBox(m_buffer, box, m_frame.view());
        const bool hidden = asked.place && asked.place->pixels() > 0 && m_buffer.hides(*asked.place);
        if (m_frame.recording()) sayAsked(subject, line, nesting, hidden, asked);
        return hidden;
    }

    /// Asks about the boxes of an object's parts: all have to be hidden, or to lie beside the picture.
    bool hidesParts(uint32_t instance, uint8_t line, uint8_t nesting) {
        const std::span<const Box3> parts = m_parts.of(instance);
        if (parts.empty() || m_buffer.empty()) return false;
        const bool hidden = std::ranges::all_of(parts, [this](const Box3& part) {
            ++m_counters.questions;
            const AskedBox asked = askedBox(m_buffer, part, m_frame.view());
            return asked.place && (asked.place->pixels() == 0 || m_buffer.hides(*asked.place));
        });
        if (m_frame.recording())
            say(Subject::ofObject(instance), line, nesting, hidden,
                hidden ? CULLSCOPE_TR("Its triangles lie in %1 smaller boxes, and occluders hide each of them.")
                       : CULLSCOPE_TR("Its triangles lie in %1 smaller boxes, and occluders do not hide all of them."),
                {double(parts.size())});
        return hidden;
    }

    void sayAsked(const Subject& subject, uint8_t line, uint8_t nesting, bool hidden, const AskedBox& asked) {
        Decision decision = askedDecision(m_buffer, asked, hidden, m_frame.view());
        decision.subject = subject;
        decision.nesting = nesting;
        m_frame.say(atLine(line, decision));
    }

    void say(const Subject& subject, uint8_t line, uint8_t nesting, bool hidden, const char* sentence,
             std::initializer_list<double> operands) {
        Decision decision = hidingTest(hidden, sentence, operands);
        decision.subject = subject;
        decision.nesting = nesting;
        m_frame.say(atLine(line, decision));
    }

    const GroupTree& m_tree;
    const Occluders& m_occluders;
    const PartBoxes& m_parts;
    FrameContext& m_frame;
    const BufferOptions& m_options;
    OcclusionBuffer& m_buffer;
    BufferCounters& m_counters;
    std::vector<uint64_t> m_askedOf;  ///< by instance: of how many occluders it is known that they do not hide it
};

}  // namespace

std::vector<KeptObject> walkWithBuffer(const GroupTree& tree, const Occluders& occluders, const PartBoxes& parts,
                                       FrameContext& frame, const BufferOptions& options, LastFailedPlanes& memory,
                                       OcclusionBuffer& buffer, BufferCounters& counters) {
    return BufferWalk(tree, occluders, parts, frame, options, buffer, counters).run(memory);
}

}  // namespace cullscope::occlusion
