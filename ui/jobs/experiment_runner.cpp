#include "ui/jobs/experiment_runner.h"

#include <QCoreApplication>
#include <algorithm>
#include <new>

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

/// Returns an empty message if the user stopped the experiment.
Message sentenceOf(const std::exception& exception) {
    if (const auto* error = dynamic_cast<const Error*>(&exception))
        return error->kind() == ErrorKind::Interrupted ? Message() : error->message();
    if (dynamic_cast<const std::bad_alloc*>(&exception) != nullptr)
        return {QT_TRANSLATE_NOOP("core", "There is not enough memory for this experiment. Choose a smaller scene."), {}};
    return {QT_TRANSLATE_NOOP("core", "The experiment cannot be run: %1"), {exception.what()}};
}

}  // namespace

ExperimentRunner::ExperimentRunner(QObject* parent, GpuThread::Options gpu) : QObject(parent), m_gpuOptions(std::move(gpu)) {
    m_poll.setInterval(kInterval);
    connect(&m_poll, &QTimer::timeout, this, &ExperimentRunner::showBoard);
}

ExperimentRunner::~ExperimentRunner() {
    m_stop.request_stop();
    m_jobs.invalidate();
    m_gpu.reset();
}

void ExperimentRunner::start(const Request& request) {
    m_stop.request_stop();
    const uint64_t job = m_jobs.begin();
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
    ++m_underWay;
    m_gpu->post([this, job, &gpu = *m_gpu, measured = measureRequest(request), stop = m_stop.get_token(), board = m_board] {
        Outcome outcome = run(measured, gpu, stop, *board);
        QMetaObject::invokeMethod(
            this, [this, job, outcome = std::move(outcome)] { deliver(job, outcome); }, Qt::QueuedConnection);
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
        const Message failure = sentenceOf(error);
        return failure.empty() ? Outcome{nothing, {}} : Outcome{std::nullopt, failure};
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

void ExperimentRunner::deliver(uint64_t job, const Outcome& outcome) {
    // The thread has no work left: joining it takes no time and frees its memory.
    if (--m_underWay == 0) m_gpu.reset();
    if (!m_jobs.isCurrent(job)) return;
    m_running = false;
    m_poll.stop();
    if (outcome.result) emit finished(*outcome.result);
    // A slot connected to `finished` may have started another experiment.
    if (!outcome.failure.empty() && m_jobs.isCurrent(job)) emit failed(outcome.failure);
}

}  // namespace cullscope::ui
