#include "ui/window/statistics_dock.h"

#include <QEvent>

#include "ui/text/wording.h"

namespace cullscope::ui {

StatisticsDock::StatisticsDock(Session& session, QWidget* parent)
    : QDockWidget(parent), m_session(session), m_panel(new StatisticsPanel(this)), m_runner(new ExperimentRunner(this)) {
    setObjectName(QStringLiteral("statistics"));
    setAllowedAreas(Qt::BottomDockWidgetArea | Qt::TopDockWidgetArea);
    setWidget(m_panel);
    setWindowTitle(tr("Statistics"));
    m_panel->setSoftwareOpenGl(session.gpu() && session.gpu()->info().software);
    wire();
}

void StatisticsDock::wire() {
    connect(&m_session, &Session::sceneChanged, this, [this] {
        const OpenedScenePointer& opened = m_session.opened();
        m_panel->setScene(opened->scene, {opened->specification, m_session.sceneSource().modelFolders});
    });
    connect(&m_session, &Session::figuresChanged, this, &StatisticsDock::showLive);
    connect(&m_session, &Session::viewCountChanged, this, &StatisticsDock::showLive);
    connect(m_panel, &StatisticsPanel::startRequested, this, &StatisticsDock::start);
    connect(m_panel, &StatisticsPanel::cancelRequested, m_runner, &ExperimentRunner::cancel);
    connect(m_panel, &StatisticsPanel::poseChosen, this, &StatisticsDock::goToPose);
    connect(m_panel, &StatisticsPanel::failed, this,
            [this](const Message& message) { m_session.raise(Severity::Error, message); });
    connect(m_panel, &StatisticsPanel::exported, this, [this](const QString& path) {
        m_session.raise(Severity::Information, {QT_TRANSLATE_NOOP("core", "Saved %1."), {path.toStdString()}});
    });
    connect(m_runner, &ExperimentRunner::progressed, m_panel, &StatisticsPanel::setProgress);
    connect(m_runner, &ExperimentRunner::partial, m_panel, &StatisticsPanel::setResult);
    connect(m_runner, &ExperimentRunner::finished, this, [this](const MeasureResult& result) {
        m_panel->setResult(result);
        end();
    });
    connect(m_runner, &ExperimentRunner::cancelled, this, &StatisticsDock::end);
    connect(m_runner, &ExperimentRunner::failed, this, [this](const Message& message) {
        end();
        m_session.raise(Severity::Error, message);
    });
}

void StatisticsDock::start(const ExperimentSettings& settings) {
    if (!m_session.opened()) return;
    ExperimentRunner::Request request;
    // Hidden objects are measured too: results are of the scene that their file names.
    request.scene = m_session.opened()->scene;
    request.path = settings.path;
    request.size = settings.size;
    request.repetitions = settings.repetitions;
    for (const int view : m_session.shownViews()) {
        const StrategySlot& slot = m_session.slot(m_session.culledBy(view));
        const bool known =
            std::any_of(request.strategies.begin(), request.strategies.end(), [&](const StrategyRequest& strategy) {
                return strategy.id == slot.id() && strategy.parameters == slot.parameters();
            });
        if (!known) request.strategies.push_back({slot.id(), slot.parameters()});
    }
    m_path = settings.path;
    // What the window measures beside it would be in the experiment's times.
    m_session.setMeasuring(false);
    m_panel->setRunning(true);
    m_runner->start(request);
}

void StatisticsDock::end() {
    m_panel->setRunning(false);
    m_session.setMeasuring(true);
}

void StatisticsDock::goToPose(int pose) {
    if (pose >= 0 && size_t(pose) < m_path.poses.size()) m_session.setCamera(m_path.camera(size_t(pose)));
}

void StatisticsDock::showLive() {
    std::vector<LiveFigures> live;
    for (const int view : m_session.shownViews()) {
        const int culling = m_session.culledBy(view);
        const StrategySlot& slot = m_session.slot(culling);
        if (culling == view || !m_session.shown(culling))
            live.push_back(
                {viewLetter(view), {slot.id(), slot.parameters()}, m_session.figures(view).promise, m_session.figures(view)});
    }
    m_panel->setLive(std::move(live));
    m_panel->setCurrentSize(m_session.renderSize(m_session.activeView()));
}

void StatisticsDock::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange) setWindowTitle(tr("Statistics"));
    QDockWidget::changeEvent(event);
}

}  // namespace cullscope::ui
