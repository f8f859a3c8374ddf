#include "ui/session/paper_runner.h"

#include <algorithm>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

constexpr int kShownInterval = 50;  // ms
const QString kMeasuring = QStringLiteral("measuring");

}  // namespace

PaperRunner::PaperRunner(Session& session, QObject* parent)
    : QObject(parent), m_session(session), m_runner(session.gpu(), session.structures()) {
    m_shownCheck.setInterval(kShownInterval);
    connect(&m_shownCheck, &QTimer::timeout, this, &PaperRunner::answerWhenShown);
    connect(&m_runner, &ExperimentRunner::progressed, this, [this](double share, const QString& stage) {
        if (!m_resultDue) return;
        // The building of a strategy reports fractions too: only those of the measuring stage are positions on the path.
        const double measured = stage == kMeasuring ? share : 0.0;
        showPose(measured);
        m_measuring.tell(measured, stage.toStdString());
    });
    connect(&m_runner, &ExperimentRunner::partial, this, [this](const MeasureResult& soFar) {
        if (!running() || !m_experiment->plotFrames) return;
        m_experiment->plotFrames(m_table, setting(), soFar);
        emit plotsChanged();
    });
    connect(&m_runner, &ExperimentRunner::finished, this, [this](const MeasureResult& result) {
        if (const auto due = std::exchange(m_measured, nullptr)) due->give(result);
    });
    connect(&m_runner, &ExperimentRunner::failed, this, [this](const Message& message) {
        if (const auto due = std::exchange(m_measured, nullptr))
            return due->fail(std::make_exception_ptr(Error(ErrorKind::OpenGl, message)));
        // After a context loss the poses measured before arrived as a result, which ends the run.
        m_session.raise(Severity::Error, message);
    });
    connect(&session, &Session::sceneChanged, this, [this] {
        if (!running() || m_showing) return;
        m_before.reset();
        cancel();
    });
}

void PaperRunner::start(const Experiment& experiment, int repetitions) {
    if (running()) return;
    m_experiment = std::make_shared<const Experiment>(experiment);
    m_setting = 0;
    m_share = 0.0;
    m_table = emptyTable(experiment);
    m_openedBefore = m_session.opened();
    m_before = captureState(m_session);
    m_pickBefore = m_session.pick();
    // Stop measuring for the views: it would add to the times of the experiment.
    m_session.setMeasuring(false);
    m_recorder = m_makeRecorder ? m_makeRecorder() : nullptr;
    if (m_recorder) m_recorder->setExperiment(experiment.id);
    emit tableChanged();
    m_background.start(
        [this, number = ++m_run, kept = m_experiment, options = ExperimentOptions{m_session.sceneSource(), repetitions}](
            const std::stop_token& stop) { return run(number, *kept, options, stop); },
        [this](const std::exception& error) -> Background::Delivery {
            return [this, message = experimentFailure(error)] { fail(message); };
        });
}

void PaperRunner::cancel() {
    if (!running()) return;
    m_table.interrupted = true;
    // The runner delivers the poses measured so far as a result.
    if (m_resultDue) return m_runner.cancel();
    end();
}

// ---- On the experiment's thread

Background::Delivery PaperRunner::run(uint64_t number, const Experiment& experiment, const ExperimentOptions& options,
                                      const std::stop_token& stop) {
    ExperimentStage stage;
    stage.scene = [&, opened = OpenedScenePointer(), known = std::string()](size_t at, const Progress& progress) mutable {
        const std::string& wanted = experiment.settings[at].scene;
        if (wanted != known) opened = std::make_shared<const OpenedScene>(openScene(wanted, options.sceneSource, progress));
        known = wanted;
        const auto shown = std::make_shared<Answer<ScenePointer>>();
        post(number, [this, at, opened, shown] { show(at, opened, shown); });
        return shown->wait(stop);
    };
    stage.measure = [&](const MeasureRequest& request, const Progress& progress) {
        const auto measured = std::make_shared<Answer<MeasureResult>>();
        post(number, [this, request, progress, measured] { measure(request, progress, measured); });
        return measured->wait(stop);
    };
    const auto afterSetting = [&](const ResultTable& soFar) {
        post(number, [this, soFar] {
            m_resultDue = false;
            const bool stopped = m_table.interrupted;
            m_table = soFar;
            m_table.interrupted = m_table.interrupted || stopped;
            emit tableChanged();
        });
    };
    (void)runExperiment(experiment, options, progressOf(number, stop), afterSetting, stage);
    return [this] { end(); };
}

void PaperRunner::post(uint64_t number, std::function<void()> work) {
    QMetaObject::invokeMethod(
        this,
        [this, number, work = std::move(work)] {
            if (running() && number == m_run) work();
        },
        Qt::QueuedConnection);
}

/// Reports in steps of at least 1 %, and every new stage.
Progress PaperRunner::progressOf(uint64_t number, const std::stop_token& stop) {
    return {[this, number, told = -1.0, toldStage = std::string()](double share, std::string_view stage) mutable {
                if (share < told + 0.01 && stage == toldStage) return;
                told = share;
                toldStage = stage;
                post(number, [this, share, words = QString::fromStdString(toldStage)] {
                    m_share = std::max(m_share, share);
                    emit progressed(m_share, words);
                });
            },
            stop};
}

// ---- On the window's thread

void PaperRunner::show(size_t setting, const OpenedScenePointer& opened, std::shared_ptr<Answer<ScenePointer>> shown) {
    if (m_table.interrupted) return end();
    m_setting = setting;
    const Setting& now = this->setting();
    if (opened && m_session.opened() != opened) {
        m_showing = true;
        m_session.show(opened);
        m_showing = false;
    }
    m_session.setActiveView(0);
    m_session.setViewCount(now.windows);
    ViewSetup setup;
    setup.upload = now.upload;
    if (now.size.width > 0) setup.size = now.size;
    try {
        for (int view = 0; view < now.windows; ++view) {
            m_session.setSetup(view, setup);
            if (!now.shown.empty()) m_session.slot(view).choose(now.shown);
        }
        m_path = now.timed() ? pathOf(now, *opened->scene) : CameraPath();
    } catch (...) {
        return shown->fail(std::current_exception());
    }
    showPose(0.0);
    m_shown = std::move(shown);
    m_shownCheck.start();
}

void PaperRunner::answerWhenShown() {
    for (const int view : m_session.shownViews())
        if (m_session.slot(view).building()) return;
    const OpenedScenePointer opened = setting().scene.empty() ? nullptr : m_session.opened();
    if (opened && m_session.gpu() && m_session.uploadFailure().empty() && !m_session.buffers(setting().upload)) return;
    m_shownCheck.stop();
    std::exchange(m_shown, nullptr)->give(opened ? opened->scene : nullptr);
}

void PaperRunner::measure(const MeasureRequest& request, const Progress& progress,
                          std::shared_ptr<Answer<MeasureResult>> measured) {
    if (m_table.interrupted) return end();
    m_resultDue = true;
    m_measuring = progress;
    m_measured = std::move(measured);
    m_runner.start(request, m_session.buffers(request.upload), m_recorder);
}

void PaperRunner::showPose(double share) {
    if (m_path.poses.empty()) return;
    const size_t pose = std::min(size_t(share * double(m_path.poses.size()) + 0.5), m_path.poses.size() - 1);
    m_session.setCamera(m_path.camera(pose));
}

void PaperRunner::fail(const Message& message) {
    m_session.raise(Severity::Error, message);
    m_table.interrupted = true;
    end();
}

void PaperRunner::end() {
    m_background.cancel();
    m_shownCheck.stop();
    m_shown = nullptr;
    m_resultDue = false;
    m_experiment = nullptr;
    m_runner.leaveStructures();
    restoreSession();
    if (m_recorder && m_recorder->failure()) m_session.raise(Severity::Warning, m_recorder->failure()->message());
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

}  // namespace cullscope::ui
