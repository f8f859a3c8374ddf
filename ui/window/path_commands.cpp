#include "ui/window/path_commands.h"

#include <QFileDialog>
#include <QFileInfo>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

// Single poses that the user added are shown for half a second each; recorded poses are a motion.
constexpr size_t kFewPoses = 30;
constexpr double kSpeedOfFewPoses = 1.0 / 15.0;

}  // namespace

PathCommands::PathCommands(Session& session, WindowActions& actions, Experiments& experiments, QWidget* window)
    : QObject(window),
      m_session(session),
      m_actions(actions),
      m_window(window),
      m_recorder(new CameraRecorder(session, this)),
      m_player(new CameraPlayer(session, this)),
      m_experiments(experiments) {
    wire();
    refresh();
}

void PathCommands::wire() {
    connect(m_actions.record, &QAction::triggered, this, [this](bool on) { on ? m_recorder->start() : m_recorder->stop(); });
    connect(m_recorder, &CameraRecorder::changed, this, &PathCommands::offerRecorded);
    connect(m_actions.addPose, &QAction::triggered, m_recorder, &CameraRecorder::addPose);
    connect(m_actions.savePath, &QAction::triggered, this, &PathCommands::save);
    connect(m_actions.openPath, &QAction::triggered, this, &PathCommands::open);
    connect(m_actions.play, &QAction::triggered, this, &PathCommands::play);
    connect(m_actions.stop, &QAction::triggered, this, [this] {
        m_recorder->stop();
        m_player->stop();
    });
    connect(m_recorder, &CameraRecorder::changed, this, &PathCommands::refresh);
    connect(m_player, &CameraPlayer::stateChanged, this, &PathCommands::refresh);
    connect(&m_session, &Session::sceneChanged, this, &PathCommands::refresh);
}

void PathCommands::refresh() {
    const bool scene = m_session.opened() != nullptr;
    const bool path = !m_recorder->path().poses.empty() || !m_opened.poses.empty();
    m_actions.record->setEnabled(scene);
    m_actions.record->setChecked(m_recorder->recording());
    m_actions.addPose->setEnabled(scene);
    m_actions.savePath->setEnabled(!m_recorder->path().poses.empty());
    m_actions.openPath->setEnabled(scene);
    m_actions.play->setEnabled(scene && path && !m_recorder->recording());
    m_actions.play->setChecked(m_player->playing());
    m_actions.stop->setEnabled(m_recorder->recording() || m_player->active());
}

/// Offers the recorded path to experiments as soon as the recording ends.
void PathCommands::offerRecorded() {
    if (m_recorder->recording()) return;
    // From now on Play plays the newest path.
    m_opened = {};
    if (!m_player->playing()) m_player->stop();
    CameraPath path = m_recorder->path();
    m_experiments.setRecordedPath(path.poses.empty() ? std::nullopt : std::optional(std::move(path)));
    if (m_recorder->lensDiffers())
        m_session.raise(Severity::Warning,
                        {QT_TRANSLATE_NOOP("core",
                                           "The field of view changed while the path was recorded: all of it has that of its "
                                           "first pose."),
                         {}});
}

QString PathCommands::askFile(bool save) {
    const QString folder = m_settings.value(QStringLiteral("folder")).toString();
    const QString types = tr("Camera paths") + QStringLiteral(" (*.json)");
    QString file = save ? QFileDialog::getSaveFileName(m_window, tr("Save the path"), folder, types)
                        : QFileDialog::getOpenFileName(m_window, tr("Open a path"), folder, types);
    if (file.isEmpty()) return {};
    if (save && QFileInfo(file).suffix().isEmpty()) file += QStringLiteral(".json");
    m_settings.setValue(QStringLiteral("folder"), QFileInfo(file).absolutePath());
    return file;
}

void PathCommands::save() {
    const QString file = askFile(true);
    if (file.isEmpty()) return;
    try {
        m_recorder->save(file.toStdString());
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
        return;
    }
    // Name the path by its file, so that an experiment over it can be repeated.
    CameraPath path = m_recorder->path();
    path.name = QFileInfo(file).absoluteFilePath().toStdString();
    m_experiments.setRecordedPath(std::move(path));
    m_session.raise(Severity::Information, {QT_TRANSLATE_NOOP("core", "Saved %1."), {file.toStdString()}});
}

void PathCommands::open() {
    const QString file = askFile(false);
    if (file.isEmpty()) return;
    try {
        m_opened = readCameraPath(file.toStdString());
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
        return;
    }
    refresh();
    playFromStart(m_opened);
}

void PathCommands::playFromStart(const CameraPath& path) {
    m_player->setSpeed(path.poses.size() < kFewPoses ? kSpeedOfFewPoses : 1.0);
    m_player->play(path);
}

void PathCommands::play(bool on) {
    if (!on)
        m_player->pause();
    else if (m_player->active())
        m_player->resume();
    else
        playFromStart(m_opened.poses.empty() ? m_recorder->path() : m_opened);
}

}  // namespace cullscope::ui
