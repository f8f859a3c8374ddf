#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/commands.h"
#include "core/spatial/instance_octree.h"

namespace cullscope::occlusion {

/// What a view remembers of a node.
struct NodeHistory {
    uint64_t seen = 0;     ///< number of the last frame that found it within the frustum; 0: none did, or nothing is known of it
    uint64_t since = 0;    ///< number of the frame since which it is hidden in every frame, while it is; 0: not known
    uint64_t next = 0;     ///< number of the frame in which it is asked about again, while it is a visible leaf
    bool visible = false;  ///< in the frame `seen`, with the answers to that frame's questions
};

/// A question of a frame, which the next one gets the answers to.
struct ChcQuestion {
    BoxTicketPointer ticket;
    std::vector<uint32_t> nodes;
    std::vector<uint32_t> ends;  ///< of groups of nodes with one answer each: behind the last node
};

/// What a view remembers.
struct ChcHistory {
    uint64_t frames = 0;             ///< so many were decided
    std::vector<NodeHistory> nodes;  ///< by node; empty before the first frame
    std::vector<ChcQuestion> asked;  ///< in the last frame
};

/// When visible leaves are asked about again (Mattausch, Bittner & Wimmer 2008, section 3.2).
struct RetestOptions {
    uint64_t every = 1;   ///< frames (n_av)
    bool random = false;  ///< the first time after a random part of them, so that leaves that came into sight together spread
    bool waits = true;    ///< hidden nodes are asked about, and the answers waited for, in the frame that visits them
};

/// The history of a view during one frame. `octree` is the one that the history is of, in every frame.
class ChcFrameHistory {
public:
    ChcFrameHistory(const InstanceOctree& octree, const ChcHistory& before, const RetestOptions& options);

    /// The frame's number, from 1.
    [[nodiscard]] uint64_t now() const { return m_history.frames; }
    /// The questions of the frame before, once.
    [[nodiscard]] std::vector<ChcQuestion> takeAsked();
    /// Takes an answer of the frame before: the numbers of the groups that show; none: it was not got. Of several nodes of which
    /// something shows, and without an answer, nothing is known.
    void answer(const ChcQuestion& question, const std::optional<std::vector<uint32_t>>& hits);
    /// After all answers: a node of which all parts became hidden is hidden. Where hidden nodes are not asked about in the same
    /// frame, parts outside the frustum count as visible, because they may come into sight.
    void pullDown();

    /// A node is visited within the frustum. Returns what was known of it before; `seen` is 0 where that is nothing.
    NodeHistory visit(uint32_t number);
    /// A visited leaf is visible; `before`: it was so in the frame before.
    void leafShows(uint32_t leaf, bool before);
    /// The parts of a visited node are visited next: it is visible if one of them is.
    void partsAreVisited(uint32_t number);
    /// The node and those around it are visible.
    void shows(uint32_t number);
    /// A visited node turned out to be hidden.
    void hides(uint32_t number);
    /// A visited node lies outside the frustum.
    void isOutside(uint32_t number);
    /// For how many frames a node has been hidden without a break.
    [[nodiscard]] uint64_t framesHidden(uint32_t number) const;
    /// Keeps a question for the next frame.
    void ask(ChcQuestion question) { m_history.asked.push_back(std::move(question)); }

    /// What the view remembers after the frame.
    [[nodiscard]] ChcHistory take() { return std::move(m_history); }

private:
    [[nodiscard]] uint64_t firstRetest(uint32_t leaf) const;
    [[nodiscard]] bool allPartsHidden(const InstanceOctree::Node& node) const;
    void becomesHidden(uint32_t number, uint64_t frame);
    void showAround(uint32_t number);

    const InstanceOctree& m_octree;
    RetestOptions m_options;
    ChcHistory m_history;
    std::vector<uint32_t> m_changed;  ///< nodes that the answers of the frame before hid
};

}  // namespace cullscope::occlusion
