#include "ui/session/object_pick.h"

namespace cullscope::ui {

std::optional<Pick> pickOfObject(const Scene& opened, uint32_t object) {
    const TriangleMesh& mesh = opened.meshOf(object);
    if (mesh.triangleCount() == 0) return std::nullopt;
    const auto corners = mesh.indices().first(3);
    const Vec3 centroid = (mesh.position(corners[0]) + mesh.position(corners[1]) + mesh.position(corners[2])) / 3.0;
    const Vec3 point(opened.instances()[object].worldFromMesh * Vec4(centroid, 1.0));
    return Pick{object, opened.firstTriangle(object), point};
}

void pickObject(Session& session, uint32_t object) {
    if (session.pick() && session.pick()->object == object) return;
    if (const std::optional<Pick> pick = pickOfObject(*session.opened()->scene, object)) session.setPick(pick);
}

void frameObject(Session& session, uint32_t object) { session.frame(session.opened()->scene->instanceSphere(object)); }

}  // namespace cullscope::ui
