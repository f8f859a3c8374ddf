#include "ui/session/camera_recorder.h"

#include <QCoreApplication>
#include <algorithm>
#include <cassert>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

constexpr int kPause = 34;  // ms: at most 30 poses a second

bool samePlace(const CameraPath::Pose& pose, const Camera& camera) {
    return pose.eye == camera.eye && pose.target == camera.target && pose.up == camera.up;
}

}  // namespace

CameraRecorder::CameraRecorder(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    m_pause.setTimerType(Qt::PreciseTimer);
    connect(&m_pause, &QTimer::timeout, this, [this] {
        if (!samePlace(m_path.poses.back(), m_last)) cameraMoved();
    });
    connect(&session, &Session::cameraChanged, this, [this] {
        // The session moves its camera for a new scene before it emits sceneChanged: that camera is not part of the recording.
        if (m_session.opened() != m_scene) return end();
        if (!m_recording || m_session.camera() == m_last) return;
        m_last = m_session.camera();
        if (!m_pause.isActive()) cameraMoved();
    });
}

void CameraRecorder::start() {
    if (!m_session.opened()) return;
    clear();
    m_recording = true;
    m_scene = m_session.opened();
    m_last = m_session.camera();
    cameraMoved();
}

void CameraRecorder::stop() {
    if (!m_recording) return;
    m_last = m_session.camera();
    end();
}

void CameraRecorder::end() {
    m_pause.stop();
    if (!std::exchange(m_recording, false)) return;
    if (!samePlace(m_path.poses.back(), m_last)) add(m_last);
    emit changed();
}

void CameraRecorder::cameraMoved() {
    add(m_last);
    m_pause.start();
}

void CameraRecorder::addPose() {
    if (m_session.opened()) add(m_session.camera());
}

void CameraRecorder::clear() {
    m_recording = false;
    m_pause.stop();
    m_path = {};
    m_lensDiffers = false;
    emit changed();
}

void CameraRecorder::replace(CameraPath path) {
    assert(!m_recording);
    m_path = std::move(path);
    m_lensDiffers = false;
}

void CameraRecorder::add(const Camera& camera) {
    if (m_path.poses.empty()) {
        m_path.fovy = camera.fovy;
        m_path.nearDistance = camera.nearDistance;
        m_path.farDistance = camera.farDistance;
        m_path.projection = camera.projection;
        m_path.height = camera.height;
    }
    m_lensDiffers =
        m_lensDiffers || camera.fovy != m_path.fovy || camera.projection != m_path.projection || camera.height != m_path.height;
    m_path.nearDistance = std::min(m_path.nearDistance, camera.nearDistance);
    m_path.farDistance = std::max(m_path.farDistance, camera.farDistance);
    m_path.poses.push_back({camera.eye, camera.target, camera.up});
    emit changed();
}

void CameraRecorder::save(const std::filesystem::path& file) const {
    if (m_path.poses.empty())
        throwUsage(QT_TRANSLATE_NOOP("core", "No camera path was recorded yet: record one, or add the present camera to it."));
    writeCameraPath(file, m_path);
}

}  // namespace cullscope::ui
