#include "ui/jobs/view_frames.h"

#include <algorithm>

#include "core/base/progress.h"
#include "core/frame/decided_ahead.h"
#include "core/frame/frame_steps.h"

namespace cullscope::ui {

std::vector<ViewFrames::Compared>::iterator ViewFrames::Memory::find(const FrameRequest& request) {
    std::erase_if(compared, [](const Compared& one) { return one.frame.expired(); });
    return std::ranges::find_if(compared, [&](const Compared& one) { return one.frame.lock()->request.sameFrame(request); });
}

const ViewFrames::Compared* ViewFrames::Memory::newest(const BuiltStrategyPointer& strategy) const {
    for (auto one = compared.rbegin(); one != compared.rend(); ++one) {
        const ViewFramePointer decided = one->frame.lock();
        if (decided && decided->request.strategy == strategy && follows(*one)) return &*one;
    }
    return nullptr;
}

ViewFramePointer ViewFrames::of(const FrameRequest& request, Renderer& renderer) {
    Memory& memory = m_views[request.view];
    if (memory.frame && memory.frame->request.sameFrame(request)) return memory.frame;
    if (memory.frame && memory.frame->request.laterTurnOf(request)) return memory.frame;
    if (const auto known = memory.find(request); known != memory.compared.end() && memory.follows(*known)) {
        memory.frame = known->frame.lock();
        memory.before = std::move(known->before);
        memory.after = std::move(known->after);
        memory.compared.erase(known);
        return memory.frame;
    }
    const bool goesOn = memory.frame && memory.frame->request.strategy == request.strategy;
    memory.before = goesOn ? std::move(memory.after) : request.strategy->begin();
    memory.after = memory.before->clone();
    memory.frame = nullptr;
    memory.frame = decide(request, *memory.after, renderer);
    return memory.frame;
}

ViewFramePointer ViewFrames::ofOther(const FrameRequest& request, Renderer& renderer) {
    Memory& memory = m_views[request.view];
    if (memory.frame && memory.frame->request.sameFrame(request)) return memory.frame;
    if (const auto known = memory.find(request); known != memory.compared.end()) return known->frame.lock();
    const Compared* newest = memory.newest(request.strategy);
    Compared next;
    next.follows = memory.frame;
    if (newest != nullptr)
        next.before = newest->after->clone();
    else if (memory.frame && memory.frame->request.strategy == request.strategy)
        next.before = memory.after->clone();
    else
        next.before = request.strategy->begin();
    next.after = next.before->clone();
    const ViewFramePointer frame = decide(request, *next.after, renderer);
    next.frame = frame;
    memory.compared.push_back(std::move(next));
    return frame;
}

ViewFramePointer ViewFrames::beside(const FrameRequest& request, Renderer& renderer) {
    ViewStatePointer state;
    if (const auto found = m_views.find(request.view); found != m_views.end()) {
        Memory& memory = found->second;
        if (memory.frame && memory.frame->request.sameFrame(request)) return memory.frame;
        if (const auto known = memory.find(request); known != memory.compared.end()) return known->frame.lock();
        if (memory.frame && memory.frame->request.strategy == request.strategy)
            state = memory.before->clone();
        else if (const Compared* newest = memory.newest(request.strategy))
            state = newest->before->clone();
    }
    if (!state) state = request.strategy->begin();
    return decide(request, *state, renderer, For::Beside);
}

ViewFramePointer FramesBeside::of(const FrameRequest& request, Renderer& renderer) {
    const auto known =
        std::ranges::find_if(m_known, [&](const ViewFramePointer& frame) { return frame->request.sameFrame(request); });
    return known != m_known.end() ? *known : m_known.emplace_back(m_frames->beside(request, renderer));
}

void ViewFrames::took(const FrameRequest& request, double milliseconds) {
    const auto found = m_views.find(request.view);
    if (found == m_views.end()) return;
    const Memory& memory = found->second;
    if (memory.frame && memory.after && memory.frame->request.sameFrame(request)) memory.after->frameMilliseconds = milliseconds;
}

ViewStatePointer ViewFrames::memoryBefore(const FrameRequest& request) const {
    const auto found = m_views.find(request.view);
    if (found == m_views.end() || !found->second.frame || !found->second.frame->request.sameFrame(request))
        return request.strategy->begin();
    return found->second.before->clone();
}

void ViewFrames::forget(int view, const BuiltStrategyPointer& present) {
    const auto found = m_views.find(view);
    if (found == m_views.end()) return;
    // A view that is not shown has only frames that another view's picture holds.
    const ViewFramePointer& frame = found->second.frame;
    if (frame ? frame->request.strategy != present : found->second.newest(present) == nullptr) m_views.erase(found);
}

size_t ViewFrames::decided(int view) const {
    const std::lock_guard lock(m_mutex);
    const auto found = m_decided.find(view);
    return found == m_decided.end() ? 0 : found->second;
}

ViewFramePointer ViewFrames::decide(const FrameRequest& request, ViewState& state, Renderer& renderer, For whom) {
    auto frame = std::make_shared<ViewFrame>();
    frame->request = request;
    const View culling(request.culling, request.size);
    GpuFrame context(renderer, *request.buffers, culling, true);
    const std::stop_callback closing(m_stop.get_token(), [this] { interrupt(std::nullopt); });
    const std::stop_token stop = begin(request, whom);
    context.stopBy(stop);
    try {
        // A frame that is not wanted makes no step at all.
        Progress{nullptr, stop}.check();
        request.strategy->draw(context, state);
    } catch (...) {
        end(request.view, false);
        throw;
    }
    frame->log = context.take();
    frame->unsteady = state.unsteady;
    end(request.view, true);
    return frame;
}

std::stop_token ViewFrames::begin(const FrameRequest& request, For whom) {
    const std::lock_guard lock(m_mutex);
    m_deciding = request.view;
    m_whom = whom;
    m_strategy = request.strategy;
    m_stopOfThisFrame = {};
    const auto unwanted = m_unwanted.find(request.view);
    const bool isUnwanted = unwanted != m_unwanted.end() && unwanted->second.lock() == request.strategy;
    const bool late = whom == For::View && overtaken(request.view, request.strategy);
    if (m_stop.stop_requested() || isUnwanted || late) m_stopOfThisFrame.request_stop();
    return m_stopOfThisFrame.get_token();
}

void ViewFrames::end(int view, bool decided) {
    const std::lock_guard lock(m_mutex);
    m_deciding.reset();
    if (decided) ++m_decided[view];
}

void ViewFrames::interrupt(std::optional<int> view) {
    const std::lock_guard lock(m_mutex);
    if (view) m_unwanted.erase(*view);
    if (!m_deciding || (view && m_deciding != view)) return;
    m_stopOfThisFrame.request_stop();
    if (view) m_unwanted[*view] = m_strategy;
}

void ViewFrames::want(int view, const BuiltStrategyPointer& strategy) {
    const std::lock_guard lock(m_mutex);
    m_wanted[view] = strategy;
    if (m_deciding == view && m_whom == For::View && overtaken(view, m_strategy.lock())) m_stopOfThisFrame.request_stop();
}

bool ViewFrames::overtaken(int view, const BuiltStrategyPointer& strategy) const {
    const auto wanted = m_wanted.find(view);
    return wanted != m_wanted.end() && wanted->second.lock() != strategy;
}

const std::vector<TriangleState>& ViewFrame::statesOf(const CoarseBuffersPointer& asked) const {
    if (coarse != asked) {
        coarseOnes = coarseStates(request.buffers->scene(), *asked->objects, log);
        coarse = asked;
    }
    return coarseOnes;
}

size_t entriesUpTo(const ViewFrame& frame, const LogPlace& place) {
    return entriesAtShare(place.entries, place.whole, frame.log.entries());
}

ViewFramePointer frameUpTo(const ViewFramePointer& frame, const std::optional<LogPlace>& place) {
    if (!frame || !place) return frame;
    return std::make_shared<const ViewFrame>(ViewFrame{frame->request, replayUpTo(frame->log, entriesUpTo(*frame, *place))});
}

ViewLook shownLook(const ViewFrame& frame, ViewLook look) {
    look.keepShownOf(*frame.request.strategy, frame.log);
    return look;
}

}  // namespace cullscope::ui
