// Shows the steps of lessons in a session.
#include <QCoreApplication>

#include "core/base/error.h"
#include "core/scene/camera_moves.h"
#include "core/scene/camera_path_pose.h"
#include "ui/session/lesson.h"

namespace cullscope::ui {

namespace {

Camera cameraOf(const CameraChoice& choice, const Scene& scene) {
    const CameraPath path = cameraPathAt(choice.path, choice.pose, scene);
    if (choice.pose >= path.poses.size())
        throwUsage(QT_TRANSLATE_NOOP("core", "The camera path %1 has no pose %2 here: its last one is %3."),
                   {choice.path, std::to_string(choice.pose), std::to_string(path.poses.size() - 1)});
    return withClipPlanes(path.camera(choice.pose), scene.boundingSphere(), std::nullopt);
}

void resolve(const CameraChoice& choice, const Scene& scene, Camera& camera, const Camera& usual) {
    if (choice.kind == CameraChoice::Kind::Pose) camera = cameraOf(choice, scene);
    if (choice.kind == CameraChoice::Kind::Usual) camera = usual;
}

}  // namespace

std::string sceneOf(const LessonStep& step, const SceneSourceOptions& options) {
    return step.defaultScene ? defaultSceneSpecification(options) : withAbsoluteFiles(step.state.scene);
}

void applyStep(Session& session, const LessonStep& step) {
    const Scene& scene = *session.opened()->scene;
    SessionState state = step.state;
    if (!step.saysUp) state.up = session.upAxis();
    resolve(step.camera, scene, state.camera, session.camera());
    for (size_t view = 0; view < state.views.size(); ++view) {
        ViewSetup& setup = state.views[view].setup;
        resolve(step.culling[view], scene, setup.culling, setup.role == Role::Frozen ? state.camera : setup.culling);
        resolve(step.viewing[view], scene, setup.viewing, setup.role == Role::Frozen ? setup.culling : setup.viewing);
    }
    // Views that come into sight later have strategies of their own (Session::setViewCount).
    for (int view = 0; view < Session::kMostViews; ++view)
        if (!isSeen(state, view)) state.views[size_t(view)].strategy.clear();
    session.setPick(std::nullopt);
    session.setQuestion(std::nullopt);
    applyState(session, state);
    if (state.style) session.setDrawStyle(*state.style);
    if (step.camera.kind == CameraChoice::Kind::Usual) {
        session.goHome();
        session.setChosenNear(state.chosenNear);
    }
    // After the cameras that they watch.
    for (int view = 0; view < Session::kMostViews; ++view) {
        if (session.setup(view).role != Role::Observer) continue;
        if (step.viewing[size_t(view)].kind == CameraChoice::Kind::Usual)
            session.observe(view, session.setup(view).observed);
        else
            session.setViewingCamera(view, state.views[size_t(view)].setup.viewing);
    }
}

}  // namespace cullscope::ui
