#pragma once

#include <QObject>
#include <memory>

#include "core/experiments/experiment.h"
#include "ui/jobs/answer.h"
#include "ui/jobs/background.h"
#include "ui/jobs/experiment_runner.h"

namespace cullscope::ui {

/// Runs an experiment of one setting over a scene that is open: core's `runExperiment`, on a thread of its own, while an
/// ExperimentRunner measures between the pictures. A newer run takes the place of an older one. Used on the window's thread.
class SceneExperiment : public QObject {
    Q_OBJECT

public:
    /// As of ExperimentRunner.
    SceneExperiment(GpuThread* gpu, std::shared_ptr<StructureStore> structures, QObject* parent = nullptr);

    /// Starts a run over the scene. `repetitions` of each frame; 0: until the median is steady. `uploaded` and
    /// `recorder`: as of ExperimentRunner::start.
    void start(const Experiment& experiment, const ScenePointer& scene, int repetitions, const SceneBuffersPointer& uploaded = {},
               const std::shared_ptr<store::Recorder>& recorder = {});
    /// Emits `ended` at once. What was measured so far arrives as `measured` when the current frame is done, unless another run
    /// was started in between.
    void cancel();
    [[nodiscard]] bool running() const { return m_running; }

signals:
    /// `share` in [0, 1]; `stage` is one of core's English names. At most 10 times a second.
    void progressed(double share, const QString& stage);
    /// The experiment's table, and the frames behind it: so far, or all. At most 10 times a second, and at the end.
    void measured(const cullscope::ResultTable& table, const cullscope::MeasureResult& result);
    void failed(const cullscope::Message& message);
    /// Nothing runs any more.
    void ended();

private:
    using Due = std::shared_ptr<Answer<MeasureResult>>;

    [[nodiscard]] Background::Delivery run(const Experiment& experiment, const ScenePointer& scene, int repetitions,
                                           const std::stop_token& stop);
    void measure(const MeasureRequest& request, Due due, const std::stop_token& stop);
    /// Nothing runs any more: tells it once, and leaves the structures.
    void end();

    ExperimentRunner m_runner;
    std::shared_ptr<const Experiment> m_experiment;  ///< the newest one
    SceneBuffersPointer m_uploaded;
    std::shared_ptr<store::Recorder> m_recorder;
    bool m_running = false;
    Due m_due;                ///< the experiment's thread waits for it; null: for none
    MeasureResult m_result;   ///< the newest one
    Background m_background;  ///< the experiment's thread
};

}  // namespace cullscope::ui
