#include "ui/session/camera_player.h"

#include <QApplication>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

namespace cullscope::ui {

namespace {

constexpr double kPosesPerSecond = 30.0;
constexpr double kSlowest = 0.01, kFastest = 100.0;

}  // namespace

CameraPlayer::CameraPlayer(Session& session, QObject* parent) : QObject(parent), m_session(session) {
    m_pause.setSingleShot(true);
    m_pause.setTimerType(Qt::PreciseTimer);
    setSpeed(1.0);
    connect(&m_pause, &QTimer::timeout, this, &CameraPlayer::advance);
    // The wait for the pictures may also end with one of these signals.
    connect(&session, &Session::pictureChanged, this, &CameraPlayer::advance);
    connect(&session, &Session::viewCountChanged, this, &CameraPlayer::advance);
    connect(&session, &Session::buffersChanged, this, &CameraPlayer::advance);
    connect(&session, &Session::strategyBuilt, this, &CameraPlayer::advance);
    connect(&session, &Session::messageRaised, this, &CameraPlayer::advance, Qt::QueuedConnection);
    connect(&session, &Session::cameraChanged, this, [this] {
        if (!m_moving && !(m_session.camera() == m_given)) pause();
    });
    connect(&session, &Session::sceneChanged, this, &CameraPlayer::stop);
}

void CameraPlayer::play(CameraPath path) { begin(std::move(path), true); }

void CameraPlayer::open(CameraPath path) { begin(std::move(path), false); }

void CameraPlayer::begin(CameraPath path, bool playing) {
    if (path.poses.empty() || !m_session.opened()) return;
    m_path = std::move(path);
    QCoreApplication::instance()->installEventFilter(this);
    m_pause.stop();
    m_playing = false;
    // What appears now may take room from the views, whose first camera depends on their size: that is no move of the user.
    emit stateChanged();
    m_playing = playing;
    show(0);
    emit stateChanged();
}

void CameraPlayer::go(int pose) {
    if (!active()) return;
    setPlaying(false);
    show(std::clamp(pose, 0, int(m_path.poses.size()) - 1));
}

void CameraPlayer::pause() { setPlaying(false); }

void CameraPlayer::resume() {
    if (!active() || m_playing) return;
    setPlaying(true);
    show(m_pose + 1 == int(m_path.poses.size()) ? 0 : m_pose);
}

void CameraPlayer::stop() {
    if (!active()) return;
    QCoreApplication::instance()->removeEventFilter(this);
    m_pause.stop();
    m_playing = false;
    m_path = {};
    m_pose = 0;
    emit stateChanged();
}

void CameraPlayer::setSpeed(double speed) {
    m_speed = std::clamp(speed, kSlowest, kFastest);
    m_pause.setInterval(int(std::ceil(1000.0 / (kPosesPerSecond * m_speed))));
}

void CameraPlayer::setPlaying(bool playing) {
    if (playing == m_playing) return;
    m_playing = playing;
    if (!playing) m_pause.stop();
    emit stateChanged();
}

void CameraPlayer::show(int pose) {
    m_pose = pose;
    m_moving = true;
    m_session.setCamera(m_path.camera(size_t(pose)));
    m_moving = false;
    m_given = m_session.camera();
    if (m_playing) m_pause.start();
    emit poseChanged(pose);
}

bool CameraPlayer::shown() const {
    const PictureMaker* pictures = m_session.pictures();
    if (pictures == nullptr) return true;
    for (const int view : m_session.shownViews()) {
        const bool uploading = !m_session.buffers(m_session.setup(view).upload) && m_session.uploadFailure().empty();
        const StrategySlot& slot = m_session.slot(m_session.culledBy(view));
        if (uploading || (!slot.built() && slot.building())) return false;
    }
    // False while requested pictures are drawn. A view that cannot be drawn has no open request, so it does not stop the player.
    return !pictures->busy();
}

void CameraPlayer::advance() {
    if (!m_playing || m_pause.isActive() || !shown()) return;
    if (m_pose + 1 < int(m_path.poses.size())) return show(m_pose + 1);
    setPlaying(false);
    emit finished();
}

bool CameraPlayer::eventFilter(QObject* watched, QEvent* event) {
    const bool press = event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride;
    // An open menu or dialog takes the Esc key first.
    if (press && QApplication::activePopupWidget() == nullptr && QApplication::activeModalWidget() == nullptr) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->key() == Qt::Key_Escape && key->modifiers() == Qt::NoModifier) {
            event->accept();
            if (event->type() == QEvent::KeyPress) stop();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

}  // namespace cullscope::ui
