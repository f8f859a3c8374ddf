#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>

#include "core/base/message.h"
#include "core/experiments/store/recorder.h"
#include "core/measure/meter.h"
#include "core/visibility/structure_store.h"
#include "ui/jobs/background.h"
#include "ui/jobs/gpu_jobs.h"

namespace cullscope::ui {

/// What the user is told of an experiment that cannot be run.
[[nodiscard]] Message experimentFailure(const std::exception& failure);

/// Measures strategies over a camera path on the GPU thread, in small steps, so that pictures are drawn in between; structures
/// are built beside it. The scene's buffers are those that the views draw. One experiment at a time, a newer one takes the place
/// of an older one. Used on the window's thread.
class ExperimentRunner : public QObject {
    Q_OBJECT

public:
    /// `gpu` outlives this object; null: nothing can be measured, and nothing is started.
    ExperimentRunner(GpuThread* gpu, std::shared_ptr<StructureStore> structures, QObject* parent = nullptr);
    /// Waits for the frame that is being drawn.
    ~ExperimentRunner() override;

    /// `uploaded`: with the scene's meshes, uploaded as the request says; null, or otherwise: the experiment uploads them.
    /// `recorder`: puts every pose into a store once it is measured; null: none does.
    void start(const MeasureRequest& request, const SceneBuffersPointer& uploaded = {},
               const std::shared_ptr<store::Recorder>& recorder = {});
    /// Requests the experiment to stop and emits `cancelled` at once. The frames measured so far arrive as `finished` when the
    /// current frame is done, unless another experiment was started in between.
    void cancel();
    /// Whether an experiment runs that was not cancelled.
    [[nodiscard]] bool running() const { return m_running; }
    /// Leaves the structures that experiments built. Until then those of the newest scene stay for the next one.
    void leaveStructures();

signals:
    void started();
    /// `share` in [0, 1]; `stage` is one of core's English names. At most 10 times a second.
    void progressed(double share, const QString& stage);
    /// The poses measured so far. At most 10 times a second.
    void partial(const cullscope::MeasureResult& result);
    void finished(const cullscope::MeasureResult& result);
    /// Emitted after `finished` if some poses were measured before the failure.
    void failed(const cullscope::Message& message);
    void cancelled();

private:
    /// Filled by the measuring thread, emptied by the timer on the window's thread.
    struct Board {
        std::mutex mutex;
        double share = 0.0;
        std::string stage;
        std::optional<MeasureResult> snapshot;
    };
    /// The end of an experiment: a result, or a message, or (after a context loss) the earlier poses and a message.
    struct Outcome {
        std::optional<MeasureResult> result;
        Message failure;
    };

    /// What lives on the GPU thread.
    struct Bench;
    /// An experiment that is ready to be measured.
    struct Ready {
        MeasureRequest request;
        Contestants contestants;
        GlInfo gl;
        SceneBuffersPointer uploaded;
        std::stop_token stop;
        std::shared_ptr<Board> board;
        std::shared_ptr<store::Recorder> recorder;
    };

    void measure(const std::shared_ptr<Ready>& ready);
    void keepStructures(const Ready& ready);
    void showBoard();
    void deliver(const Outcome& outcome);

    GpuThread* m_gpu;
    std::shared_ptr<StructureStore> m_structures;
    ScenePointer m_scene;  ///< of `m_kept`
    std::set<StructurePointer> m_kept;
    std::shared_ptr<Bench> m_bench;
    bool m_running = false;
    std::stop_source m_stop;
    std::shared_ptr<Board> m_board;
    QTimer m_poll;
    Background m_building;
    GpuJobs m_jobs;
};

}  // namespace cullscope::ui
