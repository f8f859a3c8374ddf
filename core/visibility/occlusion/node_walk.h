#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "core/base/work_check.h"
#include "core/frame/frame_context.h"
#include "core/spatial/instance_octree.h"
#include "core/visibility/occlusion/grown_box.h"
#include "core/visibility/octree_walk.h"

namespace cullscope::occlusion {

inline constexpr uint32_t kPlanes = 6;

/// How near a node is to the eye: by the nearest point of its box, then by its centre; both squared.
struct Nearness {
    double box = 0.0, centre = 0.0;

    auto operator<=>(const Nearness&) const = default;
};

/// The lines of a strategy's listing at which the decisions of every walk fall.
struct NodeWalkLines {
    uint8_t frustum = 0, outside = 0, unasked = 0, hidden = 0, parts = 0, draw = 0;
};

/// What walks have in common that ask OpenGL about the boxes of an octree's nodes: tests against the frustum, what can be asked
/// about, drawing, and the decisions, which are said while the frame records. The octree is over the frame's scene.
class NodeWalk {
protected:
    using Node = InstanceOctree::Node;
    /// A box that is drawn for its question takes as long as this many steps (work_check.h), its answer as long as these.
    static constexpr size_t kStepsOfAQuestion = 64, kStepsOfAnAnswer = 4;

    NodeWalk(const InstanceOctree& octree, FrameContext& frame, const NodeWalkLines& lines);
    ~NodeWalk() = default;
    NodeWalk(const NodeWalk&) = delete;
    NodeWalk& operator=(const NodeWalk&) = delete;

    [[nodiscard]] const Node& node(uint32_t number) const { return m_octree.nodes()[number]; }
    [[nodiscard]] FrameContext& frame() { return m_frame; }
    [[nodiscard]] bool recording() const { return m_recording; }

    /// Counts a node as visited. Throws Error(Interrupted) now and then after a stop request.
    void visited();
    /// The same after so many steps of work.
    void worked(size_t steps);
    /// Hands the number of visited nodes to the frame's counters.
    void countVisited();

    /// Tests a node's box against the planes that may cut it, and by separating axes; says what is outside, and takes planes away
    /// that it lies wholly inside. None: it is outside. Else its box, grown by boxGrowth.
    [[nodiscard]] std::optional<GrownBox> boxInFrustum(NodeEntry& entry);
    /// A box of the world relative to the eye, grown by boxGrowth.
    [[nodiscard]] GrownBox grown(const Box3& box) const { return grownBox(box, m_frame.view()); }
    [[nodiscard]] bool canBeAskedAbout(const GrownBox& box) const { return occlusion::canBeAskedAbout(box, m_frame.view()); }
    /// Whether a node is visible without asking: nothing is drawn yet that could hide it, or it cannot be asked about. Says so.
    [[nodiscard]] bool visibleUnasked(uint32_t number, const GrownBox& box);
    [[nodiscard]] Nearness nearness(uint32_t number) const;

    /// Adds the objects of a visible leaf to those that are drawn next.
    void gather(uint32_t leaf);
    /// Draws them, before the next question.
    void drawGathered();
    /// Leaves out a node with all its objects.
    void leaveOut(uint32_t number, uint8_t line, Cause cause);

    /// A test by a box.
    [[nodiscard]] static Decision result(uint32_t number, bool visible, const char* sentence,
                                         std::initializer_list<double> operands = {});
    /// Says a decision about a node, after that the parts of the nodes around it are visited, where that was not said last.
    void say(uint32_t number, Decision decision);

private:
    /// The nodes in which the decision about the next one lies. Decisions about nested subjects follow those about what contains
    /// them; a walk may go on in a node that was decided before others, which is then said again.
    struct OpenNode {
        uint32_t node = 0;
        bool parts = false;  ///< it was said that its parts are visited
    };

    [[nodiscard]] bool isOutside(NodeEntry& entry, const EyeBox& box, double margin);
    void open(uint32_t number);

    const InstanceOctree& m_octree;
    FrameContext& m_frame;
    const Frustum& m_frustum;
    Vec3 m_eye;
    bool m_recording;
    NodeWalkLines m_lines;
    Progress m_progress;
    WorkCheck m_work;
    uint64_t m_visited = 0;
    std::vector<DrawRange> m_gathered;  ///< the objects to be drawn before the next question
    bool m_anything = false;            ///< is drawn, or gathered
    std::vector<OpenNode> m_open;       ///< by depth
};

}  // namespace cullscope::occlusion
