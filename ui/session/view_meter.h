#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/scene/camera.h"
#include "ui/jobs/gpu_jobs.h"
#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// Measures the views' strategies on the GPU thread: first the error of each against the truth (computed once per
/// camera, size and facing rule), then their speed beside `backface`, interleaved. Goes step by step, so that pictures
/// come in between. A newer request makes an older one stale: it stops after the step in hand and brings nothing any more.
/// So does the loss of the thread's context.
class ViewMeter : public QObject {
    Q_OBJECT

public:
    struct Subject {
        int view = 0;
        MetricsSubject what;
    };

    explicit ViewMeter(GpuThread& gpu, QObject* parent = nullptr);
    ~ViewMeter() override;

    void measure(std::vector<Subject> subjects);
    void cancel() { m_jobs.cancel(); }
    /// How many references were computed so far; waits for the thread. For tests: truth is never computed twice.
    [[nodiscard]] size_t referencesComputed();

signals:
    void measured(int view, const cullscope::ui::ViewMetrics& figures);

private:
    struct Bench;  ///< what lives on the GPU thread
    struct Job;    ///< one request and how far it is

    void measureNext(Job& job, GpuJobs::Step& step);
    void deliver(GpuJobs::Step& step, int view, const ViewMetrics& figures);

    GpuThread& m_gpu;
    std::shared_ptr<Bench> m_bench;
    GpuJobs m_jobs;
};

}  // namespace cullscope::ui
