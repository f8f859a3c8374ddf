#include "core/gpu/gpu_frame.h"

#include <algorithm>
#include <utility>

namespace cullscope {

GpuFrame::GpuFrame(Renderer& renderer, const SceneBuffers& buffers, const View& culling, Framebuffer& target,
                   const DrawStyle& style, bool recording)
    : FrameContext(buffers.scene(), culling, recording),
      m_renderer(renderer),
      m_buffers(buffers),
      m_style(style),
      m_target(&target) {}

GpuFrame::GpuFrame(Renderer& renderer, const SceneBuffers& buffers, const View& culling, bool recording)
    : FrameContext(buffers.scene(), culling, recording), m_renderer(renderer), m_buffers(buffers) {}

void GpuFrame::execute(const Command& command) {
    m_reduction = 0;
    if (m_target != nullptr) m_renderer.execute(m_buffers, view(), command, *m_target, m_style, clearsNow());
}

void GpuFrame::executeChoice(const GpuChoice& choice, size_t command) {
    Renderer::Choice chosen = m_renderer.choose(m_buffers, choice);
    if (drawsIndirectly())
        executeIndirectly(std::move(chosen), command);
    else
        executeKnown(chosen.chosen(), command);
}

void GpuFrame::executeVisible(BoxTicket& ticket, const DrawList& candidates, size_t command) {
    if (drawsIndirectly())
        if (std::optional<Renderer::Choice> chosen = m_renderer.choose(m_buffers, ticket, candidates))
            return executeIndirectly(std::move(*chosen), command);
    DrawList visible = candidates;
    if (const std::optional<std::vector<uint32_t>> answer = m_renderer.answer(ticket)) {
        visible.ranges.clear();
        for (const uint32_t number : *answer) visible.ranges.push_back(candidates.ranges[number]);
    }
    executeKnown(std::move(visible), command);
}

void GpuFrame::executeIndirectly(Renderer::Choice choice, size_t command) {
    m_reduction = 0;
    m_renderer.execute(view(), choice, *m_target, m_style, clearsNow());
    m_choices.push_back({command, std::move(choice), {}});
}

void GpuFrame::executeKnown(DrawList list, size_t command) {
    m_reduction = 0;
    m_choices.push_back({command, std::nullopt, std::move(list)});
    if (m_target != nullptr) m_renderer.execute(m_buffers, view(), m_choices.back().known, *m_target, m_style, clearsNow());
}

void GpuFrame::readBack(FrameLog& log) {
    // A frame that draws nothing shows the background.
    if (m_target != nullptr && clearsNow()) m_renderer.clear(view(), *m_target, m_style);
    for (const PendingChoice& pending : m_choices) log.commands[pending.command] = pending.chosen();
    m_choices.clear();
}

SelectedBoxes GpuFrame::answerSelection(std::span<const EyeBox> boxes, size_t bufferWords) {
    return m_renderer.selectBoxes(view(), boxes, bufferWords);
}

std::vector<uint32_t> GpuFrame::answerQuestion(std::span<const EyeBox> boxes, std::span<const uint32_t> ends,
                                               BoxQuestion question) {
    if (question == BoxQuestion::Pyramid) return *m_renderer.answer(*putQuestion(boxes, ends, question));
    if (question == BoxQuestion::DepthSoFar) return m_renderer.queryBoxes(view(), boxes, drawn(), ends);
    return m_renderer.queryBoxes(view(), boxes, ends);
}

BoxTicketPointer GpuFrame::putQuestion(std::span<const EyeBox> boxes, std::span<const uint32_t> ends, BoxQuestion question) {
    if (question == BoxQuestion::Pyramid) {
        BoxTicketPointer ticket = m_renderer.askPyramid(view(), boxes, drawn(), ends, m_reduction);
        if (!boxes.empty()) m_reduction = m_renderer.reductions();
        return ticket;
    }
    if (question == BoxQuestion::DepthSoFar) return m_renderer.askBoxes(view(), boxes, drawn(), ends);
    return m_renderer.askBoxes(view(), boxes, ends);
}

std::optional<std::vector<uint32_t>> GpuFrame::fetchAnswer(BoxTicket& ticket) { return m_renderer.answer(ticket); }

std::vector<PyramidReading> GpuFrame::fetchReadings(BoxTicket& ticket) { return m_renderer.readings(ticket); }

std::vector<uint32_t> GpuFrame::findVisible() {
    const Renderer::ItemBuffer items = m_renderer.drawItemBuffer(m_buffers, view(), everything(scene(), facing()));
    std::vector<uint32_t> triangles;
    for (const uint32_t item : items.triangle)
        if (item != 0) triangles.push_back(item - 1);
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

Framebuffer& GpuFrame::drawn() {
    if (m_target != nullptr) {
        if (clearsNow()) m_renderer.clear(view(), *m_target, m_style);
        return *m_target;
    }
    m_own = std::make_unique<Framebuffer>(view().viewport());
    m_target = m_own.get();
    m_renderer.clear(view(), *m_target, m_style);
    m_cleared = true;
    size_t command = 0;
    for (const Command& logged : log().commands) {
        const auto isThis = [&](const PendingChoice& pending) { return pending.command == command; };
        const auto pending = std::ranges::find_if(m_choices, isThis);
        if (pending == m_choices.end())
            m_renderer.execute(m_buffers, view(), logged, *m_target, m_style);
        else
            m_renderer.execute(m_buffers, view(), pending->chosen(), *m_target, m_style);
        ++command;
    }
    return *m_target;
}

}  // namespace cullscope
