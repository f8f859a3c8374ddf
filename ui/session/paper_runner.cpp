#include "ui/session/paper_runner.h"

#include <algorithm>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

constexpr int kShownInterval = 50;  // ms
constexpr double kOpened = 0.05;    // part of a setting's progress that the opening of its scene takes
const QString kMeasuring = QStringLiteral("measuring");

}  // namespace

PaperRunner::PaperRunner(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_runner(session.gpu(), session.structures()) {
    m_shownCheck.setInterval(kShownInterval);
    connect(&m_shownCheck, &QTimer::timeout, this, &PaperRunner::measureWhenShown);
    connect(&m_runner, &ExperimentRunner::progressed, this, [this](double share, const QString& stage) {
        if (!running()) return;
        // The building of a strategy reports fractions too: only those of the measuring stage are positions on the path.
        const double measured = stage == kMeasuring ? share : 0.0;
        showPose(measured);
        tellProgress(kOpened + (1.0 - kOpened) * measured, stage);
    });
    connect(&m_runner, &ExperimentRunner::partial, this, [this](const MeasureResult& soFar) {
        if (!running() || !m_experiment->plotFrames) return;
        m_experiment->plotFrames(m_table, setting(), soFar);
        emit plotsChanged();
    });
    connect(&m_runner, &ExperimentRunner::finished, this, [this](const MeasureResult& result) {
        if (!running()) return;
        addRows([result, setting = &setting(), experiment = m_experiment](ResultTable& table, const Progress&) {
            addRuns(table, *experiment, *setting, result);
        });
    });
    connect(&m_runner, &ExperimentRunner::failed, this, &PaperRunner::fail);
    connect(&session, &Session::sceneChanged, this, [this] {
        if (!running() || m_showing) return;
        m_before.reset();
        cancel();
    });
}

void PaperRunner::start(const Experiment& experiment, int repetitions) {
    if (running()) return;
    m_experiment = &experiment;
    m_repetitions = repetitions;
    m_setting = 0;
    m_share = 0.0;
    m_specification.clear();
    m_table = emptyTable(experiment);
    m_openedBefore = m_session.opened();
    m_before = captureState(m_session);
    m_pickBefore = m_session.pick();
    // Stop measuring for the views: it would add to the times of the experiment.
    m_session.setMeasuring(false);
    emit tableChanged();
    nextSetting();
}

void PaperRunner::cancel() {
    if (!running()) return;
    m_table.interrupted = true;
    m_shownCheck.stop();
    // The runner delivers the poses measured so far as a result.
    if (m_resultDue) return m_runner.cancel();
    m_background.cancel();
    end();
}

void PaperRunner::nextSetting() {
    if (m_table.interrupted || m_setting == m_experiment->settings.size()) return end();
    if (m_specification == setting().scene) return showSetting();
    openScene();
}

void PaperRunner::openScene() {
    tellProgress(0.0, QString());
    m_background.start([this, specification = setting().scene,
                        source = m_session.sceneSource()](const std::stop_token& stop) -> Background::Delivery {
        try {
            auto opened = std::make_shared<const OpenedScene>(
                cullscope::openScene(specification, source, progressOn(stop).part(0.0, kOpened)));
            return [this, opened] {
                m_showing = true;
                m_session.show(opened);
                m_showing = false;
                m_specification = setting().scene;
                showSetting();
            };
        } catch (const std::exception& error) {
            return [this, message = experimentFailure(error)] { fail(message); };
        }
    });
}

void PaperRunner::showSetting() {
    const Setting& shown = setting();
    m_session.setActiveView(0);
    m_session.setViewCount(shown.windows);
    ViewSetup setup;
    setup.upload = shown.upload;
    if (shown.size.width > 0) setup.size = shown.size;
    try {
        for (int view = 0; view < shown.windows; ++view) {
            m_session.setSetup(view, setup);
            if (!shown.shown.empty()) m_session.slot(view).choose(shown.shown);
        }
        m_path = shown.timed() ? cameraPath(shown.path, *m_session.opened()->scene) : CameraPath();
    } catch (const Error& error) {
        return fail(error.message());
    }
    showPose(0.0);
    m_shownCheck.start();
}

void PaperRunner::measureWhenShown() {
    for (const int view : m_session.shownViews())
        if (m_session.slot(view).building()) return;
    if (m_session.gpu() && m_session.uploadFailure().empty() && !m_session.buffers(setting().upload)) return;
    m_shownCheck.stop();
    setting().timed() ? measureSetting() : buildSetting();
}

void PaperRunner::measureSetting() {
    const MeasureRequest request = measureRequest(setting(), m_session.opened()->scene, m_repetitions);
    ExperimentRunner::Request asked;
    asked.scene = request.scene;
    asked.strategies = request.strategies;
    asked.path = request.path;
    asked.size = request.size;
    asked.windows = request.windows;
    asked.upload = request.upload;
    asked.uploaded = m_session.buffers(request.upload);
    asked.repetitions = m_repetitions;
    asked.leaveOutUnavailable = request.leaveOutUnavailable;
    m_resultDue = true;
    m_runner.start(asked);
}

void PaperRunner::buildSetting() {
    addRows([setting = &setting(), experiment = m_experiment, scene = m_session.opened()->scene](
                ResultTable& table, const Progress& progress) { addMeasured(table, *experiment, *setting, scene, progress); });
}

/// Runs in the background: hashing the scene and counting what is in view take time.
void PaperRunner::addRows(std::function<void(ResultTable& table, const Progress& progress)> add) {
    m_background.start(
        [this, add = std::move(add), table = m_table](const std::stop_token& stop) mutable -> Background::Delivery {
            try {
                add(table, progressOn(stop).part(kOpened, 1.0));
                return [this, table = std::move(table)] {
                    const bool stopped = m_table.interrupted;
                    m_table = table;
                    m_table.interrupted = m_table.interrupted || stopped;
                    settingDone();
                };
            } catch (const std::exception& error) {
                return [this, message = experimentFailure(error)] { fail(message); };
            }
        });
}

void PaperRunner::showPose(double share) {
    if (m_path.poses.empty()) return;
    const size_t pose = std::min(size_t(share * double(m_path.poses.size()) + 0.5), m_path.poses.size() - 1);
    m_session.setCamera(m_path.camera(pose));
}

void PaperRunner::settingDone() {
    m_resultDue = false;
    ++m_setting;
    emit tableChanged();
    // A slot connected to `tableChanged` may have cancelled the run.
    if (running()) nextSetting();
}

void PaperRunner::fail(const Message& message) {
    m_session.raise(Severity::Error, message);
    // After a context loss the poses measured before arrived as a result, which ended the run.
    if (!running()) return;
    m_table.interrupted = true;
    end();
}

void PaperRunner::end() {
    m_shownCheck.stop();
    m_resultDue = false;
    m_experiment = nullptr;
    restoreSession();
    m_session.setMeasuring(true);
    emit ended();
}

void PaperRunner::restoreSession() {
    const std::optional<SessionState> before = std::exchange(m_before, std::nullopt);
    const OpenedScenePointer opened = std::exchange(m_openedBefore, nullptr);
    // If no scene was open before, the experiment's scene stays.
    if (!before || !opened) return;
    if (m_session.opened() != opened) m_session.show(opened);
    applyState(m_session, *before);
    m_session.setPick(m_pickBefore);
}

/// Progress for work on another thread: reported on this object's thread, in steps of at least 1 %.
Progress PaperRunner::progressOn(const std::stop_token& stop) {
    return {
        [this, told = -1.0](double share, std::string_view stage) mutable {
            if (share < told + 0.01) return;
            told = share;
            QMetaObject::invokeMethod(
                this,
                [this, share, words = QString::fromUtf8(stage.data(), qsizetype(stage.size()))] { tellProgress(share, words); },
                Qt::QueuedConnection);
        },
        stop};
}

void PaperRunner::tellProgress(double share, const QString& stage) {
    if (!running()) return;
    const double all = double(m_experiment->settings.size());
    m_share = std::max(m_share, (double(m_setting) + share) / all);
    emit progressed(m_share, stage);
}

}  // namespace cullscope::ui
