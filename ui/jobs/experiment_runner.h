#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>

#include "core/base/message.h"
#include "core/measure/meter.h"
#include "ui/jobs/gpu_jobs.h"

namespace cullscope::ui {

/// What the user is told of an experiment that cannot be run.
[[nodiscard]] Message experimentFailure(const std::exception& failure);

/// Measures strategies over a camera path beside the window, on an OpenGL thread of its own that lives as long as it has work:
/// one experiment at a time, a newer one takes the place of an older one. Used on the window's thread.
class ExperimentRunner : public QObject {
    Q_OBJECT

public:
    struct Request {
        ScenePointer scene;
        std::vector<StrategyRequest> strategies;  ///< the baselines `all` and `backface` are added where they are missing
        CameraPath path;
        Viewport size;
        int windows = 1;
        Upload upload = Upload::Vbo;
        int repetitions = 0;  ///< of each frame; 0: until the median is steady
        bool accuracy = true;
        bool leaveOutUnavailable = false;  ///< MeasureRequest::leaveOutUnavailable
    };

    explicit ExperimentRunner(QObject* parent = nullptr, GpuThread::Options gpu = GpuThread::Options());
    /// Waits for the frame under way.
    ~ExperimentRunner() override;

    void start(const Request& request);
    /// Tells the experiment to stop and emits `cancelled` at once. What was measured comes as `finished` as soon as the frame
    /// under way is done, unless another experiment was started before.
    void cancel();
    /// Whether an experiment is under way that was not cancelled.
    [[nodiscard]] bool running() const { return m_running; }

signals:
    void started();
    /// `share` in [0, 1]; `stage` is one of core's English names. At most 10 times a second.
    void progressed(double share, const QString& stage);
    /// The poses measured so far. At most 10 times a second.
    void partial(const cullscope::MeasureResult& result);
    void finished(const cullscope::MeasureResult& result);
    /// After `finished` where something was measured before.
    void failed(const cullscope::Message& message);
    void cancelled();

private:
    /// Where the measuring thread leaves what the timer picks up.
    struct Board {
        std::mutex mutex;
        double share = 0.0;
        std::string stage;
        std::optional<MeasureResult> snapshot;
    };
    /// What came of an experiment: a result, or a message, or (where the context was lost) the poses before and a message.
    struct Outcome {
        std::optional<MeasureResult> result;
        Message failure;
    };

    [[nodiscard]] static Outcome run(const MeasureRequest& request, GpuThread& gpu, const std::stop_token& stop, Board& board);
    void showBoard();
    void deliver(const Outcome& outcome);

    bool m_running = false;
    std::stop_source m_stop;
    std::shared_ptr<Board> m_board;
    QTimer m_poll;
    GpuThread::Options m_gpuOptions;
    std::unique_ptr<GpuThread> m_gpu;
    GpuJobs m_jobs;
};

}  // namespace cullscope::ui
