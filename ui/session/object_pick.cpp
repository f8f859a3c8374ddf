#include "ui/session/object_pick.h"

#include <algorithm>

namespace cullscope::ui {

namespace {

/// The triangle, numbered within the object, whose state represents the object.
uint64_t tellingTriangle(const Session& session, uint32_t object, uint64_t count) {
    const ViewMetrics& figures = session.figures(session.activeView());
    const std::optional<uint32_t> instance = session.instanceOf(object);
    const bool known = figures.state == ViewMetrics::State::Ready && figures.states && figures.subject.buffers &&
                       figures.subject.buffers->scenePointer() == session.scene();
    if (!known || !instance) return 0;
    const auto begin = figures.states->states.begin() + int64_t(session.scene()->firstTriangle(*instance));
    for (const TriangleState state : {TriangleState::WronglyCulled, TriangleState::Visible, TriangleState::InVain})
        if (const auto place = std::find(begin, begin + int64_t(count), state); place != begin + int64_t(count))
            return uint64_t(place - begin);
    return 0;
}

}  // namespace

std::optional<Pick> pickOfObject(const Session& session, uint32_t object) {
    const TriangleMesh& mesh = session.opened()->scene->meshOf(object);
    if (mesh.triangleCount() == 0) return std::nullopt;
    return pickOfTriangle(session, object, tellingTriangle(session, object, mesh.triangleCount()));
}

Pick pickOfTriangle(const Session& session, uint32_t object, uint64_t triangle) {
    const Scene& opened = *session.opened()->scene;
    const TriangleMesh& mesh = opened.meshOf(object);
    const auto corners = mesh.indices().subspan(3 * triangle, 3);
    const Vec3 centroid = (mesh.position(corners[0]) + mesh.position(corners[1]) + mesh.position(corners[2])) / 3.0;
    const Vec3 point(opened.instances()[object].worldFromMesh * Vec4(centroid, 1.0));
    return Pick{object, opened.firstTriangle(object) + triangle, point};
}

void pickObject(Session& session, uint32_t object) {
    if (session.pick() && session.pick()->object == object) return;
    pickLoss(session, object);
}

void pickLoss(Session& session, uint32_t object) {
    if (const std::optional<Pick> pick = pickOfObject(session, object)) session.setPick(pick);
}

void setObjectsHidden(Session& session, const std::vector<uint32_t>& objects, bool hidden) {
    std::vector<bool> flags = session.hidden();
    for (const uint32_t object : objects) flags[object] = hidden;
    session.setHidden(flags);
}

void isolateObjects(Session& session, const std::vector<uint32_t>& objects) {
    if (objects.empty()) return;
    std::vector<bool> flags(session.hidden().size(), true);
    for (const uint32_t object : objects) flags[object] = false;
    session.setHidden(flags);
}

void showAllObjects(Session& session) { session.setHidden(std::vector<bool>(session.hidden().size(), false)); }

void frameObject(Session& session, uint32_t object) { session.frame(session.opened()->scene->instanceSphere(object)); }

}  // namespace cullscope::ui
