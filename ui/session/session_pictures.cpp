// What the pictures of a session's views are made from.
#include "ui/session/session.h"

namespace cullscope::ui {

void Session::setViewport(int view, const Viewport& size) {
    ViewState& state = m_views[size_t(view)];
    if (state.viewport == size) return;
    state.viewport = size;
    followWindow(view);
    update();
}

void Session::setPictureUnit(int view, double unit) {
    if (unit == std::exchange(m_views[size_t(view)].unit, unit)) return;
    update();
}

void Session::setDrawStyle(const DrawStyle& style) {
    if (style == m_style) return;
    m_style = style;
    update();
}

void Session::setSection(const std::optional<Section>& section) {
    if (section == m_section) return;
    m_section = section;
    update();
    emit sectionChanged();
}

std::optional<ViewRequest> Session::viewRequest(int view) const {
    const Viewport size = renderSize(view);
    if (!shown(view) || !setup(view).panel.empty() || size.width < 1 || size.height < 1) return std::nullopt;
    const int culling = culledBy(view);
    const std::optional<MetricsSubject> subject = this->subject(culling);
    if (!subject) return std::nullopt;
    ViewRequest request;
    request.buffers = buffers(setup(view).upload);
    request.strategy = subject->strategy;
    request.culling = subject->culling;
    request.cullingSize = subject->size;
    request.culledBy = culling;
    request.turn = subject->turn;
    request.viewing = viewingCamera(view);
    request.size = size;
    request.look = setup(view).look;
    request.style = m_style;
    request.style.unit = float(m_views[size_t(view)].unit);
    request.section = m_section;
    const ViewMetrics& known = figures(view);
    if (request.look.has(Show::Kind::Verdicts) && known.states && known.subject == *subject) request.states = known.states;
    const Wipe& wipe = setup(view).wipe;
    request.wipe = wipe.mode;
    if (wipe.mode == Wipe::Mode::Loss && known.subject == *subject && request.viewing == request.culling &&
        request.size == request.cullingSize && !request.section)
        request.lost = known.lost;
    if (wipe.mode == Wipe::Mode::OtherView || wipe.mode == Wipe::Mode::Difference) {
        request.otherView = culledBy(wipe.other);
        request.other = slot(request.otherView).built();
        request.otherTurn = m_views[size_t(request.otherView)].turn;
    }
    if (request.look.inPlace()) {
        // What stands in place of the whole picture: no comparison and no other overlay.
        request.look = request.look.inPlaceAlone();
        request.states = nullptr;
        request.lost = nullptr;
        request.wipe = Wipe::Mode::None;
        request.other = nullptr;
        request.section.reset();
    }
    limitToStep(request);
    return request.complete() ? std::optional(request) : std::nullopt;
}

std::optional<ViewRequest> Session::pictureWish(int view) const {
    std::optional<ViewRequest> request = viewRequest(view);
    if (!request || request->upTo || request->unanswered || request->look.inPlace()) return request;
    request->coarse = m_moving ? m_moving->coarseFor(shownViews(), m_scene) : nullptr;
    if (!request->coarse) return request;
    // What is compared is compared with the whole picture, and what was measured is not of this one.
    request->wipe = Wipe::Mode::None;
    request->other = nullptr;
    request->states = nullptr;
    request->lost = nullptr;
    return request;
}

}  // namespace cullscope::ui
