#include "ui/session/named_views.h"

#include <QCoreApplication>
#include <cmath>

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

bool isAlmostParallel(const Camera& camera) { return camera.fovy.degrees() <= kAlmostParallelDegrees * 1.001; }

void setAlmostParallel(Session& session, bool parallel) {
    if (!session.opened()) return;
    const int active = session.activeView();
    Camera camera = session.viewingCamera(active);
    const Angle fovy = parallel ? Angle::fromDegrees(kAlmostParallelDegrees) : session.defaultFovy();
    // The height of the picture at the target is 2 distance tan(fovy / 2).
    const double farther = std::tan(camera.fovy.radians() / 2.0) / std::tan(fovy.radians() / 2.0);
    camera.eye = camera.target + farther * (camera.eye - camera.target);
    camera.fovy = fovy;
    session.setViewingCamera(active, camera);
}

}  // namespace cullscope::ui
