// What is picked in the session's views.
#include "ui/session/session.h"

namespace cullscope::ui {

void Session::setPick(const std::optional<Pick>& pick) {
    if (m_pictures) m_pictures->cancelPick();
    setGroup(std::nullopt);
    if (pick == m_pick) return;
    m_pointBefore = pick && m_pick ? std::optional(m_pick->point) : std::nullopt;
    m_pick = pick;
    emit pickChanged();
}

void Session::pickAt(int view, int x, int y) {
    if (const std::optional<ViewRequest> request = viewRequest(view)) pickIn(view, *request, x, y);
}

std::optional<uint32_t> Session::objectAt(int view, int x, int y) {
    const std::optional<ViewRequest> request = viewRequest(view);
    if (!request || m_question) return std::nullopt;
    const std::optional<ViewPictureDrawer::Picked> picked = m_pictures->pickNow(*request, x, y);
    if (!picked || m_scene != request->buffers->scenePointer()) return std::nullopt;
    return objectOf(uint32_t(m_scene->instanceOf(picked->triangle)));
}

void Session::pickLostAt(int view, int x, int y) {
    std::optional<ViewRequest> request = viewRequest(view);
    if (!request || m_question) return;
    request->wipe = Wipe::Mode::Loss;
    // Nothing is measured from what was clicked before to a loss that was not clicked.
    setPick(std::nullopt);
    pickIn(view, *request, x, y);
}

void Session::pickIn(int view, const ViewRequest& request, int x, int y) {
    m_pictures->pick(request, x, y, [this, view, request](const std::optional<ViewPictureDrawer::Picked>& picked) {
        // A scene that changed meanwhile numbers its triangles in another way.
        if (m_scene != request.buffers->scenePointer()) return;
        if (m_question) return picked ? nameInQuestion(picked->triangle, picked->point) : void();
        if (!picked) return setPick(std::nullopt);
        const auto instance = uint32_t(m_scene->instanceOf(picked->triangle));
        const uint32_t object = objectOf(instance);
        const uint64_t within = picked->triangle - m_scene->firstTriangle(instance);
        setPick(Pick{object, m_opened->scene->firstTriangle(object) + within, picked->point});
        emit pickedInPicture(view);
    });
}

}  // namespace cullscope::ui
