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
    // The name is the place's: a camera that is stored anew keeps it.
    std::optional<CameraBookmark>& bookmark = places.at(size_t(place));
    bookmark = CameraBookmark(session.viewingCamera(session.activeView()), bookmark ? bookmark->name : std::string());
    setPlaces(places);
}

void CameraBookmarks::name(int place, const std::string& name) {
    Places places = m_places;
    if (!places.at(size_t(place))) return;
    places[size_t(place)]->name = name;
    setPlaces(places);
}

bool CameraBookmarks::recall(int place, Session& session) const {
    const std::optional<CameraBookmark>& camera = m_places.at(size_t(place));
    if (!camera || !session.opened()) return false;
    session.setViewingCamera(session.activeView(), *camera);
    return true;
}

}  // namespace cullscope::ui
