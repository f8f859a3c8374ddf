#include "ui/window/experiments.h"

#include <algorithm>
#include <filesystem>

#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "ui/statistics/comparison_dialog.h"
#include "ui/statistics/history_store.h"
#include "ui/text/wording.h"

namespace cullscope::ui {

namespace {

constexpr size_t kMostShown = 200;  // experiments; the store keeps all

}  // namespace

Experiments::Experiments(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_runner(new SceneExperiment(session.gpu(), session.structures(), this)) {
    wire();
    readHistory();
}

void Experiments::readHistory() {
    try {
        std::error_code failure;  // where the folder cannot be made, opening says so
        std::filesystem::create_directories(historyStore().parent_path(), failure);
        const store::ResultStore opened(historyStore());
        try {
            takeOldHistory(historyStore().parent_path() / "experiments.json", opened);
        } catch (const Error& other) {
            m_session.raise(Severity::Warning, other.message());
        }
        m_history = pastExperiments(opened, kMostShown);
    } catch (const Error& failure) {
        m_session.raise(Severity::Warning, failure.message());
    }
    for (StatisticsPanel* panel : m_panels) panel->setHistory(m_history);
}

std::shared_ptr<store::Recorder> Experiments::recorder() {
    try {
        return std::make_shared<store::Recorder>(historyStore(), store::Origin{"desktop", {}});
    } catch (const Error& failure) {
        m_session.raise(Severity::Warning, failure.message());
        return nullptr;
    }
}

void Experiments::compare(qint64 a, qint64 b, QWidget* parent) {
    try {
        const store::ResultStore opened(historyStore());
        ComparisonDialog(opened.read(a), opened.read(b), parent).exec();
    } catch (const Error& failure) {
        m_session.raise(Severity::Warning, failure.message());
    }
}

void Experiments::exportPast(const std::vector<qint64>& numbers, const QString& path) {
    try {
        const store::ResultStore opened(historyStore());
        std::vector<store::Stored> all;
        for (const qint64 number : numbers) all.push_back(opened.read(number));
        const bool csv = path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive);
        const std::string text = csv               ? store::storedCsv(all)
                                 : all.size() == 1 ? store::storedJson(all.front())
                                                   : store::storedJson(all);
        writeFileAtomically(path.toStdString(), [&](std::ostream& out) { out << text; });
        m_session.tellSaved(path);
    } catch (const Error& failure) {
        m_session.raise(Severity::Error, failure.message());
    }
}

void Experiments::wire() {
    const auto live = [this] {
        for (StatisticsPanel* panel : m_panels) showLive(*panel);
    };
    connect(&m_session, &Session::sceneChanged, this, [this] {
        m_result.reset();
        for (StatisticsPanel* panel : m_panels) showScene(*panel);
    });
    connect(&m_session, &Session::metricsChanged, this, live);
    connect(&m_session, &Session::viewCountChanged, this, live);
    connect(m_runner, &SceneExperiment::progressed, this, [this](double share, const QString& stage) {
        for (StatisticsPanel* panel : m_panels) panel->setProgress(share, stage);
    });
    connect(m_runner, &SceneExperiment::measured, this, &Experiments::show);
    connect(m_runner, &SceneExperiment::ended, this, &Experiments::end);
    connect(m_runner, &SceneExperiment::failed, this,
            [this](const Message& message) { m_session.raise(Severity::Error, message); });
}

StatisticsPanel* Experiments::makePanel(QWidget* parent) {
    auto* panel = new StatisticsPanel(parent);
    m_panels.push_back(panel);
    connect(panel, &QObject::destroyed, this, [this, panel] { std::erase(m_panels, panel); });
    connect(panel, &StatisticsPanel::startRequested, this, &Experiments::start);
    connect(panel, &StatisticsPanel::cancelRequested, m_runner, &SceneExperiment::cancel);
    connect(panel, &StatisticsPanel::poseChosen, this, &Experiments::goToPose);
    connect(panel, &StatisticsPanel::strategyChosen, this, &Experiments::showStrategy);
    connect(panel, &StatisticsPanel::failed, this, [this](const Message& message) { m_session.raise(Severity::Error, message); });
    connect(panel, &StatisticsPanel::exported, this, [this](const QString& path) { m_session.tellSaved(path); });
    connect(panel, &StatisticsPanel::compareRequested, this, [this, panel](qint64 a, qint64 b) { compare(a, b, panel); });
    connect(panel, &StatisticsPanel::pastExportRequested, this, &Experiments::exportPast);
    panel->setSoftwareOpenGl(m_session.gpu() && m_session.gpu()->info().software);
    panel->setScenePicture([this] {
        const ViewPicturePointer shown = m_session.picture(m_session.activeView());
        return shown ? shown->colour : QImage();
    });
    panel->setRecordedPath(m_recorded);
    if (m_session.opened()) showScene(*panel);
    showLive(*panel);
    panel->setRunning(m_running);
    panel->setHistory(m_history);
    if (m_result) panel->setResult(m_table, *m_result);
    return panel;
}

void Experiments::setRecordedPath(const std::optional<CameraPath>& path) {
    m_recorded = path;
    for (StatisticsPanel* panel : m_panels) panel->setRecordedPath(path);
}

void Experiments::show(const ResultTable& table, const MeasureResult& result) {
    m_table = table;
    m_result = result;
    for (StatisticsPanel* panel : m_panels) panel->setResult(table, result);
    // Of an experiment that was stopped the last pose arrives after its end.
    if (!m_running) readHistory();
}

void Experiments::showScene(StatisticsPanel& panel) const {
    const OpenedScenePointer& opened = m_session.opened();
    panel.setScene(opened->scene, {opened->specification, m_session.sceneSource().modelFolders});
}

void Experiments::start(const ExperimentSettings& settings) {
    if (!m_session.opened() || !m_session.gpu()) return;
    std::vector<std::string> beside;
    if (settings.sweeps.empty())
        for (const StrategyRequest& strategy : shownStrategies()) beside.push_back(strategyText(strategy));
    Experiment experiment = sweepExperiment(settings.sweeps, beside);
    Setting& setting = experiment.settings.front();
    // Hidden objects are measured too: the result names the scene's file, so it must be of the whole scene.
    setting.scene = m_session.opened()->specification;
    setting.path = settings.path;
    if (settings.poses) setting.views = [poses = *settings.poses](const Scene&) { return poses; };
    setting.size = settings.size;
    // The time bars and the table show every strategy beside the baselines.
    setting.baselinesToo = true;
    setting.limitToo = true;
    for (const StrategyRequest& strategy : requestsOf(setting))
        if (const std::optional<Message> why = m_session.unavailable(findStrategy(strategy.id).info))
            return m_session.raise(Severity::Error, *why);
    // Stop measuring for the views: it would add to the times of the experiment.
    m_session.setMeasuring(false);
    m_running = true;
    m_result.reset();
    for (StatisticsPanel* panel : m_panels) panel->setRunning(true);
    m_recorder = recorder();
    m_runner->start(experiment, m_session.opened()->scene, settings.repetitions, m_session.buffers(setting.upload), m_recorder);
}

std::vector<StrategyRequest> Experiments::shownStrategies() const {
    std::vector<StrategyRequest> shown;
    for (const int view : m_session.measuredViews()) {
        const StrategySlot& slot = m_session.slot(view);
        const bool known = std::any_of(shown.begin(), shown.end(), [&](const StrategyRequest& strategy) {
            return strategy.id == slot.id() && strategy.parameters == slot.parameters();
        });
        if (!known) shown.push_back({slot.id(), slot.parameters()});
    }
    return shown;
}

void Experiments::end() {
    m_running = false;
    readHistory();
    if (m_recorder && m_recorder->failure()) m_session.raise(Severity::Warning, m_recorder->failure()->message());
    for (StatisticsPanel* panel : m_panels) panel->setRunning(false);
    m_session.setMeasuring(true);
}

void Experiments::goToPose(int pose) {
    if (!m_result || pose < 0) return;
    const CameraPath& path = m_result->request.path;
    if (size_t(pose) >= path.poses.size()) return;
    // Figures of another size would be others.
    m_session.setPictureSize(m_session.shownViews(), m_result->request.size);
    m_session.setCamera(path.camera(size_t(pose)));
}

void Experiments::showStrategy(const StrategyRequest& strategy) {
    StrategySlot& slot = m_session.slot(m_session.culledBy(m_session.activeView()));
    slot.choose(strategy.id, strategy.parameters);
}

void Experiments::showLive(StatisticsPanel& panel) const {
    std::vector<LiveFigures> live;
    for (const int view : m_session.measuredViews()) {
        const StrategySlot& slot = m_session.slot(view);
        const ViewMetrics& figures = m_session.figures(view);
        live.push_back({viewLetter(view), {slot.id(), slot.parameters()}, figures.promise, figures});
    }
    panel.setLive(std::move(live));
    panel.setCurrentSize(m_session.renderSize(m_session.activeView()));
}

}  // namespace cullscope::ui
