#include "ui/session/path_desk.h"

#include <algorithm>

#include "core/base/error.h"
#include "core/scene/camera_path_edits.h"

namespace cullscope::ui {

namespace {

// Single poses that the user added are shown for half a second each; recorded poses are a motion.
constexpr size_t kFewPoses = 30;
constexpr double kSpeedOfFewPoses = 1.0 / 15.0;

}  // namespace

PathDesk::PathDesk(Session& session, QObject* parent)
    : QObject(parent),
      m_session(session),
      m_recorder(new CameraRecorder(session, this)),
      m_player(new CameraPlayer(session, this)) {
    connect(m_recorder, &CameraRecorder::changed, this, &PathDesk::takeRecorded);
    connect(m_player, &CameraPlayer::stateChanged, this, &PathDesk::changed);
    connect(m_player, &CameraPlayer::poseChanged, this, &PathDesk::changed);
    connect(&session, &Session::sceneChanged, this, [this] {
        // A built-in path is the former scene's.
        m_background.cancel();
        m_making.clear();
        if (!m_own) m_path = {};
        emit changed();
    });
}

void PathDesk::take(CameraPath path, bool own) {
    m_path = std::move(path);
    m_own = own;
    if (own) {
        m_recorder->replace(m_path);
        emit ownPathChanged(m_path);
    }
    emit changed();
}

void PathDesk::takeRecorded() {
    if (m_recorder->recording()) {
        m_recording = true;
        emit changed();
        return;
    }
    const bool ended = std::exchange(m_recording, false);
    // From now on the newest path is played.
    if (!m_player->playing()) m_player->stop();
    const bool lensDiffers = m_recorder->lensDiffers();
    take(m_recorder->path(), true);
    // Now it can be trimmed, smoothed and named, from where the camera stands.
    if (ended) go(int(m_path.poses.size()) - 1);
    if (lensDiffers)
        m_session.raise(Severity::Warning,
                        {QT_TRANSLATE_NOOP("core",
                                           "The field of view changed while the path was recorded: all of it has that of its "
                                           "first pose."),
                         {}});
}

void PathDesk::makeBuiltIn(const QString& name) {
    if (!m_session.opened()) return;
    m_recorder->stop();
    m_making = name;
    emit changed();
    const ScenePointer scene = m_session.opened()->scene;
    m_background.start(
        [this, scene, name](const std::stop_token& stop) -> Background::Delivery {
            CameraPath path = cameraPath(name.toStdString(), *scene, {nullptr, stop});
            return [this, path = std::move(path)] {
                m_making.clear();
                take(path, false);
                m_player->open(m_path);
            };
        },
        [this](const std::exception& failure) -> Background::Delivery {
            const auto* error = dynamic_cast<const Error*>(&failure);
            const Message message = error ? error->message() : Message{failure.what(), {}};
            return [this, message] {
                m_making.clear();
                m_session.raise(Severity::Error, message);
                emit changed();
            };
        });
}

void PathDesk::open(const std::filesystem::path& file) {
    CameraPath path = readCameraPath(file);
    path.name = file.string();
    m_recorder->stop();
    take(std::move(path), false);
    playFromStart();
}

void PathDesk::save(const std::filesystem::path& file) {
    if (m_path.poses.empty())
        throwUsage(QT_TRANSLATE_NOOP("core", "No camera path was recorded yet: record one, or add the present camera to it."));
    writeCameraPath(file, m_path);
    // Named by its file, so that an experiment over it can be repeated.
    CameraPath saved = m_path;
    saved.name = file.string();
    take(std::move(saved), true);
}

void PathDesk::playFromStart() {
    m_player->setSpeed(m_path.poses.size() < kFewPoses ? kSpeedOfFewPoses : 1.0);
    m_player->play(m_path);
}

void PathDesk::play() {
    if (m_player->active())
        m_player->resume();
    else
        playFromStart();
}

void PathDesk::go(int pose) {
    if (m_path.poses.empty()) return;
    if (!m_player->active()) m_player->open(m_path);
    m_player->go(pose);
}

void PathDesk::step(int by) { go(m_player->active() ? m_player->pose() + by : 0); }

void PathDesk::stop() {
    m_recorder->stop();
    m_background.cancel();
    m_making.clear();
    m_player->stop();
    emit changed();
}

void PathDesk::edit(CameraPath path, int pose) {
    // Another path than the one of its name.
    if (!m_own) path.name.clear();
    m_player->stop();
    take(std::move(path), true);
    m_player->open(m_path);
    m_player->go(pose);
}

void PathDesk::beginHere() {
    if (!m_player->active()) return;
    edit(trimmed(m_path, size_t(m_player->pose()), m_path.poses.size() - 1), 0);
}

void PathDesk::endHere() {
    if (!m_player->active()) return;
    const int pose = m_player->pose();
    edit(trimmed(m_path, 0, size_t(pose)), pose);
}

void PathDesk::smooth() {
    if (m_path.poses.empty()) return;
    edit(smoothed(m_path), m_player->active() ? m_player->pose() : 0);
}

void PathDesk::rename(const QString& name) {
    if (m_path.poses.empty() || name.toStdString() == m_path.name) return;
    CameraPath renamed = m_path;
    renamed.name = name.toStdString();
    take(std::move(renamed), true);
}

}  // namespace cullscope::ui
