#include "ui/jobs/experiment_runner.h"

#include <QCoreApplication>
#include <QElapsedTimer>

#include "core/base/error.h"

namespace cullscope::ui {

namespace {

constexpr int kInterval = 100;     // ms
constexpr qint64 kStep = 20;       // ms after which waiting pictures are drawn
constexpr qint64 kRest = 10;       // between two results in the middle, times what one takes
constexpr double kBuilding = 0.1;  // share of the progress

Message experimentLoss() {
    return {QT_TRANSLATE_NOOP("core",
                              "OpenGL lost its context (the graphics driver was reset), which ended the experiment. What was "
                              "measured before is kept; start it again for the rest."),
            {}};
}

MeasureResult nothingOf(const MeasureRequest& request) {
    MeasureResult nothing;
    nothing.request = request;
    nothing.interrupted = true;
    return nothing;
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

/// The measurement under way, all of it on the GPU thread.
struct ExperimentRunner::Bench {
    std::shared_ptr<const Ready> ready;  ///< the experiment that the meter is of
    SceneBuffersPointer buffers;
    std::unique_ptr<Meter> meter;        ///< null with `ready`: the context that it was in is lost
    std::optional<MeasureResult> known;  ///< the newest result of poses measured before a loss

    QElapsedTimer sinceKept;  ///< since the making of `known`
    qint64 rest = 0;          ///< ms from there until another one is made

    void letGo() {
        meter.reset();
        buffers.reset();
    }
    void end() {
        if (ready && ready->recorder) ready->recorder->end(!meter || !meter->complete());
        letGo();
        ready.reset();
        known.reset();
        sinceKept.invalidate();
        rest = 0;
    }

    void begin(const std::shared_ptr<const Ready>& next, GpuThread& gpu) {
        end();
        ready = next;
        const MeasureRequest& request = next->request;
        const bool shared = next->uploaded && gpu.holds(next->uploaded) && next->uploaded->upload() == request.upload &&
                            next->uploaded->scene().meshes() == request.scene->meshes();
        buffers = shared ? gpu.share(request.scene, *next->uploaded) : gpu.upload(request.scene, request.upload);
        meter = std::make_unique<Meter>(request, next->contestants, next->gl, buffers);
    }

    void tellBoard() const {
        const std::lock_guard lock(ready->board->mutex);
        ready->board->share = kBuilding + (1.0 - kBuilding) * double(meter->poses()) / double(ready->request.path.poses.size());
        ready->board->stage = CULLSCOPE_TR("measuring");
    }

    void keepResult() {
        {
            // The timer has not yet taken the last snapshot: do not make another one.
            const std::lock_guard lock(ready->board->mutex);
            if (ready->board->snapshot || (rest > 0 && !sinceKept.hasExpired(rest))) return;
        }
        sinceKept.start();
        known = meter->resultSoFar();
        rest = kRest * sinceKept.elapsed();
        const std::lock_guard lock(ready->board->mutex);
        ready->board->snapshot = known;
    }

    /// Measures for a moment; returns how the experiment ended, if it did.
    std::optional<Outcome> step(GpuThread& gpu) {
        QElapsedTimer clock;
        clock.start();
        while (meter && !meter->complete() && !ready->stop.stop_requested() && clock.elapsed() < kStep) {
            tellBoard();
            const size_t before = meter->poses();
            try {
                meter->step(ready->stop);
            } catch (const Error& error) {
                if (error.kind() != ErrorKind::Interrupted) throw;
            }
            if (meter->poses() == before) continue;
            // A loss cannot be dated to a frame, so the pose just measured is dropped; the result without it is kept.
            if (gpu.lost()) return Outcome{known, experimentLoss()};
            if (ready->recorder) ready->recorder->afterPose(*meter);
            // The whole result is told once, as the outcome: listeners take a complete one for the end.
            if (!meter->complete()) keepResult();
        }
        if (!meter || gpu.lost()) return Outcome{known, experimentLoss()};
        if (meter->complete() || ready->stop.stop_requested()) return Outcome{meter->resultSoFar(), {}};
        return std::nullopt;
    }
};

ExperimentRunner::ExperimentRunner(GpuThread* gpu, std::shared_ptr<StructureStore> structures, QObject* parent)
    : QObject(parent), m_gpu(gpu), m_structures(std::move(structures)), m_bench(std::make_shared<Bench>()) {
    m_poll.setInterval(kInterval);
    connect(&m_poll, &QTimer::timeout, this, &ExperimentRunner::showBoard);
    if (m_gpu)
        connect(
            m_gpu, &GpuThread::contextGoing, this, [bench = m_bench] { bench->letGo(); }, Qt::DirectConnection);
}

ExperimentRunner::~ExperimentRunner() {
    m_stop.request_stop();
    m_jobs.cancel();
    // What lives on the GPU thread ends there.
    if (m_gpu) m_gpu->run([this] { m_bench->end(); });
}

void ExperimentRunner::start(const MeasureRequest& request, const SceneBuffersPointer& uploaded,
                             const std::shared_ptr<store::Recorder>& recorder) {
    if (!m_gpu) return;
    m_stop.request_stop();
    m_jobs.cancel();
    m_gpu->post([bench = m_bench] { bench->end(); });
    m_stop = std::stop_source();
    m_board = std::make_shared<Board>();
    m_running = true;
    const auto ready =
        std::make_shared<Ready>(Ready{request, {}, m_gpu->info(), uploaded, m_stop.get_token(), m_board, recorder});
    const auto build = [this, ready, structures = m_structures](const std::stop_token&) -> Background::Delivery {
        Progress progress;
        progress.stop = ready->stop;
        progress.report = [&](double share, std::string_view stage) {
            const std::lock_guard lock(ready->board->mutex);
            ready->board->share = kBuilding * share;
            ready->board->stage = stage;
        };
        ready->contestants = buildContestants(ready->request, ready->gl, *structures, progress);
        return [this, ready] { measure(ready); };
    };
    m_building.start(build, [this, ready](const std::exception& error) -> Background::Delivery {
        const Outcome outcome =
            stoppedByUser(error) ? Outcome{nothingOf(ready->request), {}} : Outcome{std::nullopt, experimentFailure(error)};
        return [this, outcome] { deliver(outcome); };
    });
    m_poll.start();
    emit started();
}

void ExperimentRunner::leaveStructures() {
    m_kept.clear();
    m_scene = nullptr;
}

void ExperimentRunner::keepStructures(const Ready& ready) {
    if (m_scene != ready.request.scene) leaveStructures();
    m_scene = ready.request.scene;
    for (const Contestant& contestant : ready.contestants.strategies) m_kept.insert(contestant.strategy->structure());
}

void ExperimentRunner::measure(const std::shared_ptr<Ready>& ready) {
    keepStructures(*ready);
    m_jobs.start(*m_gpu, [this, &gpu = *m_gpu, bench = m_bench, ready](GpuJobs::Step& step) {
        std::optional<Outcome> outcome;
        try {
            if (bench->ready != ready && ready->stop.stop_requested()) outcome = Outcome{nothingOf(ready->request), {}};
            if (!outcome && bench->ready != ready) bench->begin(ready, gpu);
            if (!outcome) outcome = bench->step(gpu);
        } catch (const std::exception& error) {
            outcome = gpu.lost() ? Outcome{bench->known, experimentLoss()} : Outcome{std::nullopt, experimentFailure(error)};
        }
        if (!outcome) return step.again();
        bench->end();
        // The structures are not held by the job, which this thread keeps for a moment after the result has been delivered.
        ready->contestants = {};
        step.deliver([this, ended = *outcome] { deliver(ended); });
    });
}

void ExperimentRunner::cancel() {
    if (!m_running) return;
    m_stop.request_stop();
    m_running = false;
    m_poll.stop();
    emit cancelled();
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
    m_running = false;
    m_poll.stop();
    if (outcome.result) emit finished(*outcome.result);
    // A receiver of the result may have started another experiment.
    if (!outcome.failure.empty() && !m_running) emit failed(outcome.failure);
}

}  // namespace cullscope::ui
