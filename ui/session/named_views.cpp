#include "ui/session/named_views.h"

#include <QCoreApplication>

namespace cullscope::ui {

const std::vector<NamedView>& namedViews() {
    static const std::vector<NamedView> kViews{
        {QT_TRANSLATE_NOOP("core", "Front"), {0, 0, 1}},    {QT_TRANSLATE_NOOP("core", "Back"), {0, 0, -1}},
        {QT_TRANSLATE_NOOP("core", "Left"), {-1, 0, 0}},    {QT_TRANSLATE_NOOP("core", "Right"), {1, 0, 0}},
        {QT_TRANSLATE_NOOP("core", "Top"), {0, 1, 0}},      {QT_TRANSLATE_NOOP("core", "Bottom"), {0, -1, 0}},
        {QT_TRANSLATE_NOOP("core", "Isometric"), {1, 1, 1}}};
    return kViews;
}

Vec3 directionOf(const NamedView& view, UpAxis up) {
    const Vec3& from = view.fromYUp;
    return up == UpAxis::Y ? from : Vec3(from.x, -from.z, from.y);
}

void lookFrom(Session& session, const NamedView& view) {
    if (!session.opened()) return;
    const int active = session.activeView();
    const UpAxis up = session.upAxis();
    session.setViewingCamera(active, seenFrom(session.viewingCamera(active), up, directionOf(view, up)));
}

void setProjection(Session& session, ProjectionKind projection) {
    if (!session.opened()) return;
    const int active = session.activeView();
    const Camera& camera = session.viewingCamera(active);
    if (camera.projection == projection) return;
    session.setViewingCamera(active, projection == ProjectionKind::Parallel ? inParallel(camera) : inPerspective(camera));
}

}  // namespace cullscope::ui
