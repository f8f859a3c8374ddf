#include "ui/jobs/experiment_runner.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/base/error.h"
#include "core/visibility/registry.h"

namespace cullscope::ui {

namespace {

constexpr int kInterval = 100;  // ms

MeasureRequest measureRequest(const ExperimentRunner::Request& request) {
    MeasureRequest measured;
    measured.scene = request.scene;
    measured.strategies = request.strategies;
    // The time bars and the table show every strategy beside the baselines.
    for (const char* baseline : {"all", "backface"}) {
        const bool present = std::any_of(request.strategies.begin(), request.strategies.end(),
                                         [&](const StrategyRequest& strategy) { return strategy.id == baseline; });
        if (!present) measured.strategies.push_back({baseline, ParameterSet(findStrategy(baseline).info.parameters)});
    }
    measured.path = request.path;
    measured.size = request.size;
    measured.windows = request.windows;
    measured.upload = request.upload;
    measured.timing.fixedRepetitions = request.repetitions;
    measured.accuracy = request.accuracy;
    measured.leaveOutUnavailable = request.leaveOutUnavailable;
    return measured;
}

Message experimentLoss() {
    return {QT_TRANSLATE_NOOP("core",
                              "OpenGL lost its context (the graphics driver was reset), which ended the experiment. What was "
                              "measured before is kept; start it again for the rest."),
            {}};
}

bool stoppedByUser(const std::exception& exception) {
    const auto* error = dynamic_cast<const Error*>(&exception);
    return error != nullptr && error->kind() == ErrorKind::Interrupted;
}

}  // namespace

Message experimentFailure(const std::exception& failure) {
    return sentenceOf(failure, QT_TRANSLATE_NOOP("core", "The experiment cannot be run: %1"),
                      QT_TRANSLATE_NOOP("core", "There is not enough memory for this experiment. Choose a smaller scene."));
}

ExperimentRunner::ExperimentRunner(QObject* parent, GpuThread::Options gpu) : QObject(parent), m_gpuOptions(std::move(gpu)) {
    m_poll.setInterval(kInterval);
    connect(&m_poll, &QTimer::timeout, this, &ExperimentRunner::showBoard);
}

ExperimentRunner::~ExperimentRunner() { m_stop.request_stop(); }

void ExperimentRunner::start(const Request& request) {
    m_stop.request_stop();
    m_jobs.cancel();
    try {
        if (!m_gpu) m_gpu = std::make_unique<GpuThread>(m_gpuOptions);
    } catch (const Error& error) {
        m_running = false;
        m_poll.stop();
        emit failed(error.message());
        return;
    }
    m_stop = std::stop_source();
    m_board = std::make_shared<Board>();
    m_running = true;
    m_jobs.start(*m_gpu, [this, &gpu = *m_gpu, measured = measureRequest(request), stop = m_stop.get_token(),
                          board = m_board](GpuJobs::Step& step) {
        step.deliver([this, outcome = run(measured, gpu, stop, *board)] { deliver(outcome); });
    });
    m_poll.start();
    emit started();
}

void ExperimentRunner::cancel() {
    if (!m_running) return;
    m_stop.request_stop();
    m_running = false;
    m_poll.stop();
    emit cancelled();
}

ExperimentRunner::Outcome ExperimentRunner::run(const MeasureRequest& request, GpuThread& gpu, const std::stop_token& stop,
                                                Board& board) {
    Progress progress;
    progress.stop = stop;
    progress.report = [&](double share, std::string_view stage) {
        const std::lock_guard lock(board.mutex);
        board.share = share;
        board.stage = stage;
    };
    std::optional<MeasureResult> known;
    const PoseObserver afterPose = [&](const std::function<MeasureResult()>& resultSoFar) {
        // A loss cannot be dated to a frame, so the pose just measured is dropped; the result without it is kept.
        if (gpu.lost()) throw Error(ErrorKind::OpenGl, experimentLoss());
        {
            // The timer has not yet taken the last snapshot: do not make another one.
            const std::lock_guard lock(board.mutex);
            if (board.snapshot) return;
        }
        known = resultSoFar();
        const std::lock_guard lock(board.mutex);
        board.snapshot = known;
    };
    MeasureResult nothing;
    nothing.request = request;
    nothing.interrupted = true;
    try {
        if (stop.stop_requested()) return {nothing, {}};
        return {measure(request, progress, afterPose), {}};
    } catch (const std::exception& error) {
        if (gpu.lost()) return {known, experimentLoss()};
        return stoppedByUser(error) ? Outcome{nothing, {}} : Outcome{std::nullopt, experimentFailure(error)};
    }
}

void ExperimentRunner::showBoard() {
    const std::shared_ptr<Board> board = m_board;
    double share = 0.0;
    QString stage;
    std::optional<MeasureResult> snapshot;
    {
        const std::lock_guard lock(board->mutex);
        share = board->share;
        stage = QString::fromStdString(board->stage);
        snapshot.swap(board->snapshot);
    }
    emit progressed(share, stage);
    // A slot connected to `progressed` may have cancelled the experiment or started another one.
    if (snapshot && m_running && board == m_board) emit partial(*snapshot);
}

void ExperimentRunner::deliver(const Outcome& outcome) {
    // The thread has nothing left to do: joining it takes no time, and its memory is free again.
    m_gpu.reset();
    m_running = false;
    m_poll.stop();
    if (outcome.result) emit finished(*outcome.result);
    // Whoever heard of the result may have started another.
    if (!outcome.failure.empty() && !m_running) emit failed(outcome.failure);
}

}  // namespace cullscope::ui
