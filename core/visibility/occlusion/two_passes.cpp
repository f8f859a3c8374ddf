#include "core/visibility/occlusion/two_passes.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/message.h"
#include "core/visibility/object_nodes.h"
#include "core/visibility/occlusion/occluders.h"

namespace cullscope::occlusion {
namespace {

using Part = DrawnParts::Part;

/// Where batches of `count` parts end, each with about twice as many as the one before.
std::vector<size_t> batchEnds(size_t count, size_t rounds) {
    std::vector<size_t> ends;
    const double whole = std::exp2(double(rounds)) - 1.0;
    for (size_t round = 1; round <= rounds; ++round) {
        const auto end = size_t(std::ceil(double(count) * (std::exp2(double(round)) - 1.0) / whole));
        if (end > (ends.empty() ? 0 : ends.back())) ends.push_back(std::min(end, count));
    }
    return ends;
}

class TwoPasses final : private SecondPass {
public:
    TwoPasses(FrameContext& frame, const DrawnParts& parts, const TwoPassOptions& options, const LastVisible& before)
        : m_frame(frame), m_parts(parts), m_options(options), m_lines(options.lines), m_visible(before.visible(frame)) {}

    void run() {
        firstPass();
        if (m_options.others) {
            m_options.others(*this);
            firstPass();
        }
        secondPass(m_options.rounds);
    }

    /// What the next frame remembers.
    [[nodiscard]] LastVisible last() {
        LastVisible next;
        std::vector<const Part*> asked;
        // Nothing else is there to hide a part that is alone.
        const bool alone = m_parts.parts().size() == 1;
        for (const Part& part : m_parts.parts()) {
            if (part.askable && !alone)
                asked.push_back(&part);
            else
                next.unasked.push_back(part.key);
        }
        std::ranges::sort(asked, {}, &Part::key);
        std::ranges::sort(next.unasked);
        for (const Part* part : asked) next.asked.push_back(part->key);
        if (asked.empty()) return next;
        next.ticket = ask(m_parts, asked);
        if (m_frame.recording()) sayLast(asked, *next.ticket);
        return next;
    }

    [[nodiscard]] const TwoPassCounters& counters() const { return m_counters; }

private:
    /// Of the parts that were added since.
    void firstPass() {
        DrawList list = m_options.like;
        for (; m_begun < m_parts.parts().size(); ++m_begun) {
            const Part& part = m_parts.parts()[m_begun];
            const bool visible = std::ranges::binary_search(m_visible, part.key);
            if (part.askable && !visible) {
                m_rest.push_back(&part);
                continue;
            }
            ++m_counters.first;
            list.ranges.push_back(part.range);
            if (!m_frame.recording()) continue;
            const char* sentence =
                part.askable
                    ? CULLSCOPE_TR("It was visible at the end of the frame before: it is drawn first, without a test.")
                    : CULLSCOPE_TR("Its box, grown by %1, reaches before the near plane: it counts as visible without asking.");
            say(part, m_lines.first, test(false, sentence, {part.growth}));
            sayEnd(part, m_lines.first, true);
        }
        draw(std::move(list));
    }

    void secondPass(size_t rounds) {
        const std::vector<const Part*> rest = nearestFirst(std::exchange(m_rest, {}));
        size_t first = 0;
        for (const size_t end : batchEnds(rest.size(), rounds)) {
            const std::span<const Part* const> batch = std::span(rest).subspan(first, end - first);
            if (m_anything)
                drawUnhidden(batch);
            else
                drawUntested(batch);
            first = end;
        }
    }
    [[nodiscard]] static std::vector<const Part*> nearestFirst(std::vector<const Part*> parts) {
        std::ranges::stable_sort(parts, {}, &Part::distance);
        return parts;
    }

    void draw() override {
        firstPass();
        secondPass(1);
    }

    [[nodiscard]] std::optional<std::vector<uint32_t>> shown(const DrawnParts& groups) override {
        if (!m_anything) return std::nullopt;
        std::vector<const Part*> asked;
        for (const Part& group : groups.parts()) asked.push_back(&group);
        m_counters.groups += asked.size();
        const BoxTicketPointer ticket = ask(groups, asked);
        std::vector<uint32_t> visible = m_frame.answer(*ticket).value_or(allOf(asked));
        if (m_frame.recording()) {
            const std::vector<PyramidReading> readings = m_frame.readings(*ticket);
            for (uint32_t i = 0; i < asked.size(); ++i)
                say(*asked[i], m_lines.test, tested(*asked[i], !std::ranges::binary_search(visible, i), readings[i]));
        }
        return visible;
    }
    [[nodiscard]] static std::vector<uint32_t> allOf(std::span<const Part* const> parts) {
        std::vector<uint32_t> numbers(parts.size());
        std::iota(numbers.begin(), numbers.end(), 0U);
        return numbers;
    }

    void draw(DrawList list) {
        if (list.ranges.empty()) return;
        m_anything = m_changed = true;
        m_frame.draw(std::move(list));
    }

    /// Parts that nothing can hide yet.
    void drawUntested(std::span<const Part* const> batch) {
        for (const Part* part : batch) {
            if (!m_frame.recording()) continue;
            say(*part, m_lines.test,
                test(false, CULLSCOPE_TR("Nothing is drawn yet that could hide its box: it counts as visible without asking."),
                     {}));
            sayEnd(*part, m_lines.draw, true);
        }
        draw(listOf(batch));
    }

    void drawUnhidden(std::span<const Part* const> batch) {
        m_counters.tested += batch.size();
        const BoxTicketPointer ticket = ask(m_parts, batch);
        if (m_frame.recording()) sayTests(batch, *ticket);
        m_frame.drawVisible(*ticket, listOf(batch));
        m_changed = true;
    }

    [[nodiscard]] DrawList listOf(std::span<const Part* const> batch) const {
        DrawList list = m_options.like;
        list.ranges.reserve(batch.size());
        for (const Part* part : batch) list.ranges.push_back(part->range);
        return list;
    }

    [[nodiscard]] BoxTicketPointer ask(const DrawnParts& all, std::span<const Part* const> parts) {
        std::vector<EyeBox> boxes;
        std::vector<uint32_t> ends;
        for (const Part* part : parts) {
            const std::span<const EyeBox> own = all.boxesOf(*part);
            boxes.insert(boxes.end(), own.begin(), own.end());
            ends.push_back(uint32_t(boxes.size()));
        }
        m_counters.boxes += boxes.size();
        if (m_changed) {
            ++m_counters.pyramids;
            if (m_frame.recording()) sayReduction();
        }
        m_changed = false;
        if (boxes.size() == ends.size()) ends.clear();
        return m_frame.ask(std::move(boxes), BoxQuestion::Pyramid, std::move(ends));
    }

    // ---- Decisions

    [[nodiscard]] static Decision test(bool hidden, const char* sentence, std::initializer_list<double> operands) {
        return hidingTest(hidden, sentence, operands);
    }

    /// Says a test, or an end.
    void say(const Part& part, uint8_t line, Decision decision) {
        if (!m_options.tests && decision.outcome == Decision::Outcome::Open) return;
        decision.subject = part.subject;
        decision.places = part.places;
        decision.nesting = part.nesting;
        m_frame.say(atLine(line, decision));
    }

    void sayEnd(const Part& part, uint8_t line, bool drawn) {
        if (!drawn) m_counters.hidden.push_back(&part);
        const auto outcome = drawn ? Decision::Outcome::Drawn : Decision::Outcome::Culled;
        say(part, line, ending(part.subject, outcome, Cause::Hidden));
    }

    void sayReduction() {
        const Viewport size = m_frame.view().viewport();
        double levels = 1.0;
        for (int side = std::max(size.width, size.height); side > 1; side = (side + 1) / 2) ++levels;
        sayBegin(m_frame, m_lines.reduce,
                 CULLSCOPE_TR(
                     "The depth of what is drawn so far is reduced to a pyramid: levels %1; a texel has the farthest depth of "
                     "the pixels below it."),
                 {levels});
    }

    void sayTests(std::span<const Part* const> batch, BoxTicket& ticket) {
        const std::vector<uint32_t> visible = m_frame.answer(ticket).value_or(std::vector<uint32_t>{});
        const std::vector<PyramidReading> readings = m_frame.readings(ticket);
        size_t box = 0;
        for (uint32_t i = 0; i < batch.size(); ++i) {
            const bool hidden = !std::ranges::binary_search(visible, i);
            say(*batch[i], m_lines.test, tested(*batch[i], hidden, readings[box]));
            sayEnd(*batch[i], hidden ? m_lines.hidden : m_lines.draw, !hidden);
            box += batch[i]->boxCount;
        }
    }

    /// The test of a part; `reading`: of its first box.
    [[nodiscard]] Decision tested(const Part& part, bool hidden, const PyramidReading& reading) const {
        if (part.boxCount > 1)
            return test(
                hidden,
                hidden
                    ? CULLSCOPE_TR("Its triangles lie in %1 smaller boxes, and each lies behind all texels of the pyramid that "
                                   "it may cover.")
                    : CULLSCOPE_TR("Its triangles lie in %1 smaller boxes, and not all lie behind the texels of the pyramid that "
                                   "they may cover: it counts as visible."),
                {double(part.boxCount)});
        const double begins = m_frame.view().distanceFromDepth(reading.nearest);
        if (!(reading.farthest > 0.0f))
            return test(
                hidden,
                CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead. Of the texels that it may cover on level %3 of the pyramid, "
                             "%4, one has pixels that show nothing yet: it counts as visible."),
                {part.growth, begins, double(reading.level), double(reading.texels)});
        return test(
            hidden,
            hidden
                ? CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead. It lies behind all texels that it may cover on level %3 "
                               "of the pyramid: %4; the farthest is %5 ahead.")
                : CULLSCOPE_TR("Its box, grown by %1, begins %2 ahead. Of the texels that it may cover on level %3 of the "
                               "pyramid, %4, the farthest is %5 ahead: it counts as visible."),
            {part.growth, begins, double(reading.level), double(reading.texels),
             m_frame.view().distanceFromDepth(reading.farthest)});
    }

    void sayLast(std::span<const Part* const> asked, BoxTicket& ticket) {
        const std::vector<uint32_t> visible = m_frame.answer(ticket).value_or(std::vector<uint32_t>{});
        for (uint32_t i = 0; i < asked.size(); ++i) {
            const bool shows = std::ranges::binary_search(visible, i);
            // It tells of the next frame, and nothing of what this one draws: no test that has it outside.
            say(*asked[i], shows ? m_lines.next : m_lines.again,
                test(false,
                     shows ? CULLSCOPE_TR("At the end of the frame it is not hidden: the next frame draws it first.")
                           : CULLSCOPE_TR("At the end of the frame it is hidden: the next frame does not draw it first."),
                     {}));
        }
    }

    FrameContext& m_frame;
    const DrawnParts& m_parts;
    const TwoPassOptions& m_options;
    TwoPassLines m_lines;
    std::vector<uint64_t> m_visible;  ///< keys of what was visible before
    std::vector<const Part*> m_rest;  ///< of the second pass
    size_t m_begun = 0;               ///< parts that are drawn first, or in the rest
    bool m_anything = false;          ///< is drawn
    bool m_changed = true;            ///< the depth, since it was reduced
    TwoPassCounters m_counters;
};

}  // namespace

std::vector<uint64_t> LastVisible::visible(FrameContext& frame) const {
    std::vector<uint64_t> keys;
    if (ticket != nullptr)
        if (const std::optional<std::vector<uint32_t>> answer = frame.answer(*ticket))
            for (const uint32_t number : *answer) keys.push_back(asked[number]);
    const auto middle = std::ptrdiff_t(keys.size());
    keys.insert(keys.end(), unasked.begin(), unasked.end());
    std::inplace_merge(keys.begin(), keys.begin() + middle, keys.end());
    return keys;
}

DrawnParts::Part& DrawnParts::add(uint64_t key, const Subject& subject, const DrawRange& range) {
    return m_parts.emplace_back(Part{key, subject, range, uint32_t(m_boxes.size())});
}

void DrawnParts::addBox(const GrownBox& box) {
    Part& part = m_parts.back();
    part.askable = part.askable && canBeAskedAbout(box, m_view);
    part.growth = std::max(part.growth, box.growth);
    ++part.boxCount;
    m_boxes.push_back(box.box);
}

TwoPassCounters drawInTwoPasses(FrameContext& frame, const DrawnParts& parts, const TwoPassOptions& options,
                                LastVisible& memory) {
    TwoPasses passes(frame, parts, options, memory);
    passes.run();
    memory = passes.last();
    return passes.counters();
}

}  // namespace cullscope::occlusion
