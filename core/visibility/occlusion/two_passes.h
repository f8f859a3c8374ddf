#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/frame_context.h"
#include "core/visibility/occlusion/grown_box.h"

namespace cullscope::occlusion {

/// What a view remembers: the question at the end of its last frame, whose answer is what was visible in it.
struct LastVisible {
    BoxTicketPointer ticket;        ///< null: the view has no past
    std::vector<uint64_t> asked;    ///< by answer: the keys of the parts, ascending
    std::vector<uint64_t> unasked;  ///< keys of parts that were visible without a question, ascending

    /// The keys of what was visible, ascending; waits for the answer. Of another OpenGL context's question nothing is known.
    [[nodiscard]] std::vector<uint64_t> visible(FrameContext& frame) const;
};

/// Parts of a scene that are drawn or left out as a whole, in the order in which they are drawn, with the boxes that hold them.
class DrawnParts {
public:
    struct Part {
        uint64_t key = 0;  ///< the same in every frame; different for every part
        Subject subject;
        DrawRange range;
        uint32_t firstBox = 0, boxCount = 0;
        double growth = 0.0;    ///< of its boxes, the largest
        double distance = 0.0;  ///< from the eye, by which those that are tested are sorted
        PlaceRun places{};      ///< of a cell
        uint8_t nesting = 0;    ///< of its decisions
        bool askable = true;    ///< its boxes lie beyond the near plane
    };

    explicit DrawnParts(const View& view) : m_view(view) {}
    /// Adds a part without boxes; then boxes to it.
    Part& add(uint64_t key, const Subject& subject, const DrawRange& range);
    void addBox(const GrownBox& box);

    [[nodiscard]] const std::deque<Part>& parts() const { return m_parts; }
    [[nodiscard]] std::span<const EyeBox> boxesOf(const Part& part) const {
        return std::span(m_boxes).subspan(part.firstBox, part.boxCount);
    }
    [[nodiscard]] size_t boxCount() const { return m_boxes.size(); }

private:
    const View& m_view;
    std::deque<Part> m_parts;  ///< which stay where they are when others are added
    std::vector<EyeBox> m_boxes;
};

/// What is still to be drawn after the first pass, while its parts are found.
class SecondPass {
public:
    virtual ~SecondPass() = default;
    /// Tests the parts that were added so far and draws those that are not hidden.
    virtual void draw() = 0;
    /// Tests groups of parts, whose ranges are not drawn, by what is drawn so far, and waits for the answer: the numbers of those
    /// that are not hidden, ascending. None: nothing is drawn yet that could hide one.
    [[nodiscard]] virtual std::optional<std::vector<uint32_t>> shown(const DrawnParts& groups) = 0;
};

/// The lines of a strategy's listing at which the decisions of both passes fall.
struct TwoPassLines {
    uint8_t first = 0;             ///< drawn in the first pass
    uint8_t reduce = 0, test = 0;  ///< the pyramid, and a part's test against it
    uint8_t hidden = 0, draw = 0;  ///< what becomes of it
    uint8_t again = 0, next = 0;   ///< hidden at the end of the frame, or drawn first in the next one
};

struct TwoPassOptions {
    size_t rounds = 1;  ///< in which the second pass is made
    TwoPassLines lines{};
    DrawList like{};    ///< facing and order of what is drawn
    bool tests = true;  ///< whether tests are said, or what becomes of the parts alone
    /// Adds further parts after the first pass. Empty: all parts are known before.
    std::function<void(SecondPass& pass)> others{};
};

struct TwoPassCounters {
    uint64_t first = 0;   ///< parts of the first pass
    uint64_t tested = 0;  ///< of the second
    uint64_t boxes = 0;   ///< by which they were tested
    uint64_t groups = 0;  ///< tested
    uint64_t pyramids = 0;
    std::vector<const DrawnParts::Part*> hidden;  ///< only while the frame records
};

/// Draws the parts that are not hidden, in two passes (two-pass occlusion culling with a hierarchical depth buffer; Greene, Kass
/// & Miller 1993; Haar & Aaltonen 2015).
/// - First pass: parts that were visible at the end of the last frame, and those that cannot be asked about. They are drawn
///   without a test.
/// - Then `options.others` may add further parts, for which it may test groups by what is drawn.
/// - Second pass: the depth of what is drawn so far is reduced to a pyramid, and OpenGL tests the boxes of the others against it.
///   A part is hidden where all its boxes are. The others are drawn in the same frame. With several rounds the parts are parted
///   into as many batches, the nearest first, else in their order, each with twice as many as the one before, and what one round
///   draws hides what the next one tests. What comes before anything is drawn is drawn without a test.
/// - At the end all parts are tested against the pyramid of the finished picture, for the next frame. A part that is alone is
///   not: nothing hides it.
/// Nothing visible is left out, whatever `memory` holds: what is left out is hidden by what this frame has drawn. Parts that are
/// left out count as hidden when the frame ends.
TwoPassCounters drawInTwoPasses(FrameContext& frame, const DrawnParts& parts, const TwoPassOptions& options, LastVisible& memory);

}  // namespace cullscope::occlusion
