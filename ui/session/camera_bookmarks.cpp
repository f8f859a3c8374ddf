#include "ui/session/camera_bookmarks.h"

namespace cullscope::ui {

void CameraBookmarks::setPlaces(const Places& places) {
    if (places == m_places) return;
    m_places = places;
    emit changed();
}

void CameraBookmarks::store(int place, const Session& session) {
    if (!session.opened()) return;
    Places places = m_places;
    places.at(size_t(place)) = session.viewingCamera(session.activeView());
    setPlaces(places);
}

bool CameraBookmarks::recall(int place, Session& session) const {
    const std::optional<Camera>& camera = m_places.at(size_t(place));
    if (!camera || !session.opened()) return false;
    session.setViewingCamera(session.activeView(), *camera);
    return true;
}

}  // namespace cullscope::ui
