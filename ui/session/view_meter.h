#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/scene/camera.h"
#include "ui/jobs/gpu_thread.h"
#include "ui/jobs/job_numbers.h"
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

    /// How often a frame is drawn for its time, besides once before that does not count.
    struct Rounds {
        int fewest = 3, most = 15;
        double budgetSeconds = 1.0;  ///< of drawing, after which no further round is begun
    };

    explicit ViewMeter(GpuThread& gpu, const Rounds& rounds, QObject* parent = nullptr);
    ~ViewMeter() override;

    void measure(std::vector<Subject> subjects);
    void cancel();
    [[nodiscard]] bool busy() const { return m_busy; }
    /// How many references were computed so far; waits for the thread. For tests: truth is never computed twice.
    [[nodiscard]] size_t referencesComputed();

signals:
    void measured(int view, const cullscope::ui::ViewMetrics& figures);

private:
    struct Bench;  ///< what lives on the GPU thread
    struct Job;    ///< one request and how far it is

    void step(const std::shared_ptr<Job>& job);
    /// False: that was the last of it.
    [[nodiscard]] bool measureNext(Job& job);
    /// Whether OpenGL still has what the job measures.
    [[nodiscard]] bool held(const Job& job) const;
    void fail(const Job& job, const Message& message);
    void deliver(uint64_t job, int view, const ViewMetrics& figures);

    GpuThread& m_gpu;
    Rounds m_rounds;
    JobNumbers m_jobs;
    bool m_busy = false;
    std::shared_ptr<Bench> m_bench;
};

}  // namespace cullscope::ui
