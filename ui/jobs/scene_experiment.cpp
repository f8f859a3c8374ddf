#include "ui/jobs/scene_experiment.h"

#include <QMetaObject>

#include "core/base/error.h"

namespace cullscope::ui {

SceneExperiment::SceneExperiment(GpuThread* gpu, std::shared_ptr<StructureStore> structures, QObject* parent)
    : QObject(parent), m_runner(gpu, std::move(structures)) {
    connect(&m_runner, &ExperimentRunner::progressed, this, &SceneExperiment::progressed);
    connect(&m_runner, &ExperimentRunner::partial, this, [this](const MeasureResult& soFar) {
        ResultTable table = emptyTable(*m_experiment);
        addRuns(table, *m_experiment, m_experiment->settings.front(), soFar);
        emit measured(table, soFar);
    });
    connect(&m_runner, &ExperimentRunner::finished, this, [this](const MeasureResult& result) {
        m_result = result;
        if (const Due due = std::exchange(m_due, nullptr)) due->give(result);
    });
    connect(&m_runner, &ExperimentRunner::failed, this, [this](const Message& message) {
        // After a loss of the context the poses measured before have arrived as a result, which ends the run.
        const Due due = std::exchange(m_due, nullptr);
        if (due) due->fail(std::make_exception_ptr(Error(ErrorKind::Interrupted, message)));
        emit failed(message);
        if (due) end();
    });
}

void SceneExperiment::start(const Experiment& experiment, const ScenePointer& scene, int repetitions,
                            const SceneBuffersPointer& uploaded, const std::shared_ptr<store::Recorder>& recorder) {
    m_experiment = std::make_shared<const Experiment>(experiment);
    m_uploaded = uploaded;
    m_recorder = recorder;
    // Nothing of an older run is told any more.
    if (std::exchange(m_due, nullptr)) m_runner.cancel();
    m_running = true;
    m_background.start([this, kept = m_experiment, scene,
                        repetitions](const std::stop_token& stop) { return run(*kept, scene, repetitions, stop); },
                       [this](const std::exception& error) -> Background::Delivery {
                           return [this, message = experimentFailure(error)] {
                               emit failed(message);
                               end();
                           };
                       });
}

void SceneExperiment::cancel() {
    if (!m_running) return;
    if (m_due)
        m_runner.cancel();
    else
        m_background.cancel();
    end();
}

// ---- On the experiment's thread

Background::Delivery SceneExperiment::run(const Experiment& experiment, const ScenePointer& scene, int repetitions,
                                          const std::stop_token& stop) {
    ExperimentStage stage;
    stage.scene = [&](size_t, const Progress&) { return scene; };
    stage.measure = [&](const MeasureRequest& request, const Progress&) {
        const auto due = std::make_shared<Answer<MeasureResult>>();
        QMetaObject::invokeMethod(
            this, [this, request, due, stop] { measure(request, due, stop); }, Qt::QueuedConnection);
        return due->wait(stop);
    };
    const ResultTable table = runExperiment(experiment, {{}, repetitions}, {nullptr, stop}, {}, stage);
    return [this, table] {
        // Where the measurement failed there is no result, and that was said.
        if (m_result.request.scene) emit measured(table, m_result);
        m_result = {};
        if (m_running) end();
    };
}

// ---- On the window's thread

void SceneExperiment::measure(const MeasureRequest& request, Due due, const std::stop_token& stop) {
    if (stop.stop_requested()) return;
    m_result = {};
    m_due = std::move(due);
    m_runner.start(request, m_uploaded, m_recorder);
}

void SceneExperiment::end() {
    m_running = false;
    m_runner.leaveStructures();
    // They have the scene, which may be closed before another run.
    m_uploaded = nullptr;
    m_recorder = nullptr;
    emit ended();
}

}  // namespace cullscope::ui
