#include "core/frame/frame_context.h"

#include <algorithm>
#include <map>

#include "core/base/error.h"

namespace cullscope {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

[[noreturn]] void throwNoContext() {
    throwOpenGl(CULLSCOPE_TR("This strategy asks OpenGL what is visible, and there is no OpenGL context here."));
}

/// `ends`: behind the last box of each group (AskedBoxes).
void requireGroups(size_t boxes, std::span<const uint32_t> ends) {
    if (ends.empty()) return;
    uint32_t end = 0;
    for (const uint32_t next : ends) {
        if (next <= end) throwUsage(CULLSCOPE_TR("OpenGL cannot be asked about a group of no boxes."));
        end = next;
    }
    if (end != boxes)
        throwUsage(CULLSCOPE_TR("OpenGL is asked about %1 boxes, and their groups have %2 boxes: each box belongs to one group."),
                   {std::to_string(boxes), std::to_string(end)});
}

}  // namespace

FrameContext::FrameContext(const Scene& scene, const View& culling, bool recording) : m_scene(scene), m_view(culling) {
    m_log.camera = culling.camera();
    m_log.size = culling.viewport();
    m_log.recorded = recording;
}

void FrameContext::add(Command command) {
    // Its entry in the log belongs to its execution, as a draw call's state does: what remains is the strategy's own time.
    const Clock::time_point start = Clock::now();
    m_log.commands.push_back(std::move(command));
    execute(m_log.commands.back());
    m_drawingMilliseconds += millisecondsSince(start);
}

void FrameContext::draw(DrawList list) { add(std::move(list)); }

void FrameContext::draw(OwnTrianglesPointer triangles) { add(std::move(triangles)); }

void FrameContext::show(FinishedPicturePointer picture) {
    if (!(picture->size == m_view.viewport()))
        throwUsage(CULLSCOPE_TR("A strategy made a picture of %1 × %2 pixels for a view of %3 × %4."),
                   {std::to_string(picture->size.width), std::to_string(picture->size.height),
                    std::to_string(m_view.viewport().width), std::to_string(m_view.viewport().height)});
    add(std::move(picture));
}

size_t FrameContext::addChosen(const DrawList& candidates, const std::function<void(size_t)>& execute) {
    const Clock::time_point start = Clock::now();
    const size_t command = m_log.commands.size();
    m_log.commands.emplace_back(DrawList{candidates.facing, {}, candidates.order, candidates.depth, candidates.grain});
    execute(command);
    m_drawingMilliseconds += millisecondsSince(start);
    return command;
}

void FrameContext::drawChosen(const GpuChoice& choice) {
    const size_t list = addChosen(choice.candidates, [&](size_t command) { executeChoice(choice, command); });
    m_choices.push_back({list, choice.candidates.ranges, choice.leftOut});
}

void FrameContext::drawVisible(BoxTicket& ticket, const DrawList& candidates) {
    if (ticket.answers() != candidates.ranges.size())
        throwUsage(CULLSCOPE_TR("A strategy draws %1 ranges by the answers to a question that has %2: each range needs one."),
                   {std::to_string(candidates.ranges.size()), std::to_string(ticket.answers())});
    const size_t list = addChosen(candidates, [&](size_t command) { executeVisible(ticket, candidates, command); });
    m_asked.push_back({list, candidates.triangleCount()});
}

SelectedBoxes FrameContext::selectBoxes(std::vector<EyeBox> boxes, size_t bufferWords) {
    SelectedBoxes selected = answerSelection(boxes, bufferWords);
    m_log.commands.emplace_back(AskedBoxes{BoxQuestion::Selection, std::move(boxes), selected.hits, true, selected.distances,
                                           selected.bufferWords, selected.overflows});
    return selected;
}

std::vector<uint32_t> FrameContext::visibleBoxes(std::vector<EyeBox> boxes, BoxQuestion question, std::vector<uint32_t> ends) {
    requireGroups(boxes.size(), ends);
    std::vector<uint32_t> hits = answerQuestion(boxes, ends, question);
    m_log.commands.emplace_back(AskedBoxes{question, std::move(boxes), hits, true, {}, 0, 0, std::move(ends)});
    return hits;
}

std::vector<uint32_t> FrameContext::visibleTriangles() {
    std::vector<uint32_t> triangles;
    workOutUntimed([&] { triangles = findVisible(); });
    return triangles;
}

void FrameContext::workOutUntimed(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    m_untimedMilliseconds += millisecondsSince(start);
}

BoxTicketPointer FrameContext::ask(std::vector<EyeBox> boxes, BoxQuestion question, std::vector<uint32_t> ends) {
    requireGroups(boxes.size(), ends);
    BoxTicketPointer ticket = putQuestion(boxes, ends, question);
    m_log.commands.emplace_back(AskedBoxes{question, std::move(boxes), {}, false, {}, 0, 0, std::move(ends)});
    return ticket;
}

std::optional<std::vector<uint32_t>> FrameContext::answer(BoxTicket& ticket) { return fetchAnswer(ticket); }

std::vector<PyramidReading> FrameContext::readings(BoxTicket& ticket) { return fetchReadings(ticket); }

void FrameContext::say(Decision decision) {
    decision.commands = uint32_t(m_log.commands.size());
    m_log.decisions.push_back(decision);
}

void FrameContext::say(Decision decision, std::span<const uint32_t> objects) {
    decision.firstObject = uint32_t(m_log.objects.size());
    decision.objectCount = uint32_t(objects.size());
    m_log.objects.insert(m_log.objects.end(), objects.begin(), objects.end());
    say(decision);
}

void FrameContext::attach(std::shared_ptr<const DecisionDetail> detail, const Subject& subject, size_t since) {
    size_t number = m_log.decisions.size();
    while (number > since && m_log.decisions[number - 1].subject != subject) --number;
    if (number == since) number = m_log.decisions.size();
    const auto place = std::ranges::upper_bound(m_log.details, number - 1, {}, &LoggedDetail::decision);
    m_log.details.insert(place, {number - 1, std::move(detail)});
}

void FrameContext::attach(std::shared_ptr<const DecisionDetail> detail) {
    m_log.details.push_back({m_log.decisions.size() - 1, std::move(detail)});
}

FrameLog FrameContext::take() {
    readBack(m_log);
    for (const Candidates& candidates : m_choices) endChoice(candidates);
    m_choices.clear();
    for (const Asked& asked : m_asked)
        m_log.counters.culledTriangles[size_t(Cause::Hidden)] +=
            asked.triangles - std::get<DrawList>(m_log.commands[asked.command]).triangleCount();
    m_asked.clear();
    return std::move(m_log);
}

void FrameContext::endChoice(const Candidates& candidates) {
    struct Triangles {
        uint64_t given = 0, chosen = 0;
    };
    std::map<uint32_t, Triangles> objects;
    for (const DrawRange& range : candidates.ranges) objects[range.instance].given += range.indexCount / 3;
    for (const DrawRange& range : std::get<DrawList>(m_log.commands[candidates.command]).ranges)
        objects[range.instance].chosen += range.indexCount / 3;
    for (const auto& [instance, triangles] : objects) {
        m_log.counters.culledTriangles[size_t(candidates.leftOut)] += triangles.given - triangles.chosen;
        if (!recording()) continue;
        const auto outcome = triangles.chosen == 0                ? Decision::Outcome::Culled
                             : triangles.chosen < triangles.given ? Decision::Outcome::PartlyDrawn
                                                                  : Decision::Outcome::Drawn;
        say(ending(Subject::ofObject(instance), outcome, candidates.leftOut));
    }
}

void FrameContext::executeChoice(const GpuChoice& /*choice*/, size_t /*command*/) { throwNoContext(); }
void FrameContext::executeVisible(BoxTicket& /*ticket*/, const DrawList& /*candidates*/, size_t /*command*/) { throwNoContext(); }
SelectedBoxes FrameContext::answerSelection(std::span<const EyeBox> /*boxes*/, size_t /*bufferWords*/) { throwNoContext(); }
std::vector<uint32_t> FrameContext::answerQuestion(std::span<const EyeBox> /*boxes*/, std::span<const uint32_t> /*ends*/,
                                                   BoxQuestion /*question*/) {
    throwNoContext();
}
BoxTicketPointer FrameContext::putQuestion(std::span<const EyeBox> /*boxes*/, std::span<const uint32_t> /*ends*/,
                                           BoxQuestion /*question*/) {
    throwNoContext();
}
std::vector<uint32_t> FrameContext::findVisible() { throwNoContext(); }
std::optional<std::vector<uint32_t>> FrameContext::fetchAnswer(BoxTicket& /*ticket*/) { throwNoContext(); }
std::vector<PyramidReading> FrameContext::fetchReadings(BoxTicket& /*ticket*/) { throwNoContext(); }

StageTimer::StageTimer(FrameContext& frame, const char* name)
    : m_frame(frame), m_name(name), m_drawingBefore(frame.drawingMilliseconds()), m_untimedBefore(frame.untimedMilliseconds()) {}

StageTimer::~StageTimer() {
    m_frame.addStage(m_name, millisecondsSince(m_start) - (m_frame.drawingMilliseconds() - m_drawingBefore) -
                                 (m_frame.untimedMilliseconds() - m_untimedBefore));
}

Decision outsideTest(const Subject& subject, FrustumPlane plane, double inner, double margin) {
    Decision decision;
    decision.subject = subject;
    decision.plane = plane;
    decision.operands = {inner, margin};
    decision.operandCount = 2;
    // %1 is the plane, %2 the distance of the farthest point inside, %3 the margin.
    if (inner < -margin) {
        decision.containment = Containment::Outside;
        decision.sentence = CULLSCOPE_TR(
            "Tested against the %1: even the nearest point of the bounds lies %2 outside, more than the bound of %3.");
    } else if (inner < 0.0) {
        decision.sentence =
            CULLSCOPE_TR("Tested against the %1: the bounds lie %2 outside, within the bound of %3, and count as inside.");
    } else {
        decision.sentence = CULLSCOPE_TR("Tested against the %1: the bounds reach %2 to the inside.");
    }
    return decision;
}

Decision planeTest(const Subject& subject, FrustumPlane plane, double inner, double outer, double margin) {
    Decision decision = outsideTest(subject, plane, inner, margin);
    decision.operands[2] = outer;
    decision.operandCount = 3;
    if (decision.containment != Containment::Outside && outer > margin) {
        decision.containment = Containment::Inside;
        decision.sentence = CULLSCOPE_TR("Tested against the %1: all of the bounds lie inside, the farthest point by %2.");
    }
    return decision;
}

Decision axisTest(const Subject& subject, bool outside, double margin) {
    Decision decision;
    decision.subject = subject;
    decision.containment = outside ? Containment::Outside : Containment::Straddles;
    decision.operands[1] = margin;
    decision.sentence =
        outside ? CULLSCOPE_TR(
                      "No single plane has the bounds outside, but an axis parts them from the frustum: they lie beside "
                      "one of its edges or corners.")
                : CULLSCOPE_TR("Tested by separating axes, for several planes cut the bounds: none parts them from the frustum.");
    return decision;
}

Decision ending(const Subject& subject, Decision::Outcome outcome, Cause cause) {
    Decision decision;
    decision.subject = subject;
    decision.outcome = outcome;
    decision.cause = cause;
    decision.containment = outcome == Decision::Outcome::Culled ? Containment::Outside : Containment::Straddles;
    return decision;
}

}  // namespace cullscope
