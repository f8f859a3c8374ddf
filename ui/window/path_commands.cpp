#include "ui/window/path_commands.h"

#include <QFileDialog>

#include "core/base/error.h"

namespace cullscope::ui {

PathCommands::PathCommands(Session& session, WindowActions& actions, QWidget* window)
    : QObject(window),
      m_session(session),
      m_actions(actions),
      m_window(window),
      m_recorder(new CameraRecorder(session, this)),
      m_player(new CameraPlayer(session, this)) {
    wire();
    refresh();
}

void PathCommands::wire() {
    connect(m_actions.record, &QAction::triggered, this, [this](bool on) { on ? m_recorder->start() : m_recorder->stop(); });
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

void PathCommands::save() {
    const QString file =
        QFileDialog::getSaveFileName(m_window, tr("Save the path"), {}, tr("Camera paths") + QStringLiteral(" (*.json)"));
    if (file.isEmpty()) return;
    try {
        m_recorder->save(file.toStdString());
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
    }
}

void PathCommands::open() {
    const QString file =
        QFileDialog::getOpenFileName(m_window, tr("Open a path"), {}, tr("Camera paths") + QStringLiteral(" (*.json)"));
    if (file.isEmpty()) return;
    try {
        m_opened = readCameraPath(file.toStdString());
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
        return;
    }
    refresh();
    m_player->play(m_opened);
}

void PathCommands::play(bool on) {
    if (!on)
        m_player->pause();
    else if (m_player->active())
        m_player->resume();
    else
        m_player->play(m_opened.poses.empty() ? m_recorder->path() : m_opened);
}

}  // namespace cullscope::ui
