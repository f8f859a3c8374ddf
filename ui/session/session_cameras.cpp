// The session's cameras: that of the linked views, and those of observers and frozen views.
#include "ui/session/session.h"

#include <algorithm>

#include "ui/session/view_sizes.h"

namespace cullscope::ui {

double Session::aspect(int view) const {
    const Viewport size = renderSize(view);
    return size.width > 0 && size.height > 0 ? double(size.width) / size.height : 4.0 / 3.0;
}

void Session::setCamera(const Camera& camera) {
    if (!m_opened) return;
    const Camera complete = withClipPlanes(camera, m_opened->scene->boundingSphere(), m_chosenNear);
    if (complete == m_camera) return;
    m_camera = complete;
    emit cameraChanged();
    update();
}

void Session::setUpAxis(UpAxis up) {
    // What a scene says of itself, or what is guessed of it, is no choice for the next one.
    if (!m_opened || m_opened->scene->upAxis() != up)
        m_chosenUp = up;
    else if (!m_opened->scene->remarks().up)
        m_chosenUp.reset();
    if (up == m_up) return;
    m_up = up;
    goHome();
    emit cameraChanged();
}

int Session::homeView() const {
    // An observer has a camera of its own.
    const int culling = culledBy(m_activeView);
    return setup(culling).role == Role::Linked ? culling : m_activeView;
}

void Session::goHome() {
    m_chosenNear.reset();
    if (!m_opened) return;
    setCamera(homeCamera(*m_opened->scene, m_up, aspect(homeView())));
    m_home = m_camera;
    placeObservers(observers());
}

std::vector<int> Session::observers() const {
    std::vector<int> views;
    for (int view = 0; view < kMostViews; ++view)
        if (setup(view).role == Role::Observer) views.push_back(view);
    return views;
}

void Session::placeObservers(const std::vector<int>& views) {
    for (const int view : views) observe(view, setup(view).observed);
}

/// While the user has not moved a camera, adapts it to the window, so that the scene keeps filling it.
void Session::followWindow(int view) {
    if (!m_opened || setup(view).size) return;
    std::vector<int> following;
    for (const int observer : observers())
        if (setup(observer).viewing == m_views[size_t(observer)].firstWatch) following.push_back(observer);
    if (m_camera == m_home && view == homeView()) {
        setCamera(homeCamera(*m_opened->scene, m_up, aspect(view)));
        m_home = m_camera;
    } else {
        std::erase_if(following, [view](int observer) { return observer != view; });
        if (following.empty()) return;
    }
    placeObservers(following);
    emit camerasFollowedWindow();
}

void Session::frameScene() {
    if (m_scene) frame(m_scene->boundingSphere());
}

void Session::frame(const Sphere& sphere) {
    if (m_opened) setViewingCamera(m_activeView, framed(viewingCamera(m_activeView), m_up, sphere, aspect(m_activeView)));
}

void Session::setChosenNear(const std::optional<double>& distance) {
    m_chosenNear = distance;
    setCamera(m_camera);
}

Camera Session::withClipPlanesFor(int view, const Camera& camera) const {
    Sphere scene = m_opened->scene->boundingSphere();
    if (setup(view).role == Role::Linked) return withClipPlanes(camera, scene, m_chosenNear);
    // The clip planes must also take in the culling camera's eye, so that its frustum is visible.
    scene.radius = std::max(scene.radius, glm::length(cullingCamera(view).eye - scene.centre));
    return withClipPlanes(camera, scene, std::nullopt);
}

void Session::setLinked(int view) {
    ViewSetup changed = setup(view);
    changed.role = Role::Linked;
    changeSetup(view, changed);
}

View Session::cullingView(int view) const {
    constexpr Viewport kUntilItIsShown{4, 3};
    const Viewport size =
        setup(view).role == Role::Frozen ? setup(view).cullingSize.value_or(renderSize(view)) : renderSize(view);
    return View(cullingCamera(view), size.width > 0 && size.height > 0 ? size : kUntilItIsShown);
}

void Session::observe(int view, int observed) {
    observed = culledBy(observed);
    if (observed == view) return;
    ViewSetup changed = setup(view);
    changed.role = Role::Observer;
    changed.observed = observed;
    if (m_opened) changed.viewing = observerCamera(cullingView(observed), m_opened->scene->boundingSphere(), m_up, aspect(view));
    changeSetup(view, changed);
    if (m_opened) setViewingCamera(view, changed.viewing);
    m_views[size_t(view)].firstWatch = setup(view).viewing;
}

void Session::setFrozen(int view, bool frozen) {
    if (!m_opened || frozen == (setup(view).role == Role::Frozen)) return;
    ViewSetup changed = setup(view);
    changed.culling = cullingCamera(view);
    changed.viewing = viewingCamera(view);
    changed.cullingSize.reset();
    // The frustum depends on the picture's aspect ratio: keep the size, so that a resized window does not change what is culled.
    if (frozen && renderSize(view).width > 0) changed.cullingSize = renderSize(view);
    changed.role = frozen ? Role::Frozen : Role::Linked;
    changeSetup(view, changed);
}

void Session::setPictureSize(const std::vector<int>& views, const std::optional<Viewport>& size) {
    std::vector<ViewSetup> setups;
    for (int view = 0; view < kMostViews; ++view) setups.push_back(setup(view));
    const uint64_t before = pixelsAskedFor(setups);
    for (const int view : views) setups[size_t(view)].size = size;
    // A session file may ask for more than the user: what makes it less is always possible.
    if (const auto why = tooManyPixels(setups, std::max(before, kMostPixelsAskedFor))) return raise(Severity::Warning, *why);
    for (const int view : views) setSetup(view, setups[size_t(view)]);
}

int Session::culledBy(int view) const { return setup(view).role == Role::Observer ? setup(view).observed : view; }

const Camera& Session::cullingCamera(int view) const {
    const ViewSetup& culling = setup(culledBy(view));
    return culling.role == Role::Frozen ? culling.culling : m_camera;
}

const Camera& Session::viewingCamera(int view) const { return setup(view).role == Role::Linked ? m_camera : setup(view).viewing; }

void Session::moveViewingCamera(int view, const Camera& camera) {
    if (m_moving) m_moving->move();
    setViewingCamera(view, camera);
}

void Session::setViewingCamera(int view, const Camera& camera) {
    if (setup(view).role == Role::Linked) {
        setCamera(camera);
        return;
    }
    if (!m_opened) return;
    const Camera complete = withClipPlanesFor(view, camera);
    if (complete == setup(view).viewing) return;
    m_views[size_t(view)].setup.viewing = complete;
    emit cameraChanged();
    update();
}

}  // namespace cullscope::ui
