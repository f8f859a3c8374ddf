#include "ui/window/path_commands.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include "core/base/error.h"

namespace cullscope::ui {

PathCommands::PathCommands(Session& session, WindowActions& actions, Experiments& experiments, QWidget* window)
    : QObject(window), m_session(session), m_actions(actions), m_window(window), m_desk(new PathDesk(session, this)) {
    connect(m_desk, &PathDesk::ownPathChanged, &experiments, [&experiments](const CameraPath& path) {
        experiments.setRecordedPath(path.poses.empty() ? std::nullopt : std::optional(path));
    });
    wire();
    refresh();
}

void PathCommands::wire() {
    connect(m_actions.record, &QAction::triggered, this, [this](bool on) { on ? recorder().start() : recorder().stop(); });
    connect(m_actions.addPose, &QAction::triggered, this, [this] { recorder().addPose(); });
    connect(m_actions.savePath, &QAction::triggered, this, &PathCommands::save);
    connect(m_actions.openPath, &QAction::triggered, this, &PathCommands::open);
    connect(m_actions.play, &QAction::triggered, this, &PathCommands::play);
    connect(m_actions.stop, &QAction::triggered, m_desk, &PathDesk::stop);
    connect(m_actions.poseOn, &QAction::triggered, m_desk, [this] { m_desk->step(1); });
    connect(m_actions.poseBack, &QAction::triggered, m_desk, [this] { m_desk->step(-1); });
    connect(&m_actions, &WindowActions::builtInPathChosen, m_desk, &PathDesk::makeBuiltIn);
    connect(m_desk, &PathDesk::changed, this, &PathCommands::refresh);
    connect(&m_session, &Session::sceneChanged, this, &PathCommands::refresh);
}

void PathCommands::refresh() {
    const bool scene = m_session.opened() != nullptr;
    const bool path = !m_desk->path().poses.empty(), recording = recorder().recording();
    m_actions.record->setEnabled(scene);
    m_actions.record->setChecked(recording);
    m_actions.addPose->setEnabled(scene);
    m_actions.builtInPaths->setEnabled(scene);
    m_actions.savePath->setEnabled(path && !recording);
    m_actions.openPath->setEnabled(scene);
    m_actions.play->setEnabled(scene && path && !recording);
    m_actions.play->setChecked(player().playing());
    for (QAction* step : {m_actions.poseOn, m_actions.poseBack}) step->setEnabled(scene && path && !recording);
    m_actions.stop->setEnabled(recording || player().active() || !m_desk->making().isEmpty());
}

QString PathCommands::askFile(bool save) {
    const QString folder = m_settings.value(QStringLiteral("folder"), QDir::homePath()).toString();
    const QString types = tr("Camera paths") + QStringLiteral(" (*.json)");
    // As the path is called, without what a file's name cannot have.
    QString name = QFileInfo(QString::fromStdString(m_desk->path().name)).completeBaseName();
    name.replace(QLatin1Char(':'), QLatin1Char('-'));
    const QString proposed = name.isEmpty() ? folder : folder + QLatin1Char('/') + name + QStringLiteral(".json");
    QString file = save ? QFileDialog::getSaveFileName(m_window, tr("Save the path"), proposed, types)
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
        m_desk->save(QFileInfo(file).absoluteFilePath().toStdString());
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
        return;
    }
    m_session.tellSaved(file);
}

void PathCommands::open() {
    const QString file = askFile(false);
    if (file.isEmpty()) return;
    try {
        m_desk->open(QFileInfo(file).absoluteFilePath().toStdString());
    } catch (const Error& error) {
        m_session.raise(Severity::Error, error.message());
    }
}

void PathCommands::play(bool on) { on ? m_desk->play() : player().pause(); }

}  // namespace cullscope::ui
