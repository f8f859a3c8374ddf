#pragma once

#include <QObject>
#include <memory>
#include <vector>

#include "core/scene/camera.h"
#include "ui/jobs/gpu_jobs.h"
#include "ui/jobs/view_metrics.h"

namespace cullscope::ui {

/// Says when core measures the views' strategies on the GPU thread (ViewRounds), and delivers the figures: repetitions of the
/// frame that a view shows are timed in turns beside the baseline's, and the first of them is judged against the truth. Its
/// errors are delivered before its speed. Works in small steps, so that pictures are drawn in between. A newer request, or the
/// loss of the thread's context, ends an older one after its present step; no further result of it is delivered.
class ViewMeter : public QObject {
    Q_OBJECT

public:
    struct Subject {
        int view = 0;  ///< whose frame it is
        MetricsSubject what;
        /// Its metrics where they are known: then it is only timed anew, beside the others, so that no two views of one camera
        /// have times of different moments, whose × and frames per second could contradict each other. Else null.
        std::shared_ptr<const ViewMetrics> known{};
    };

    /// How often frames are drawn for the times of views: few, because views are measured after every change.
    [[nodiscard]] static TimingProtocol protocol();

    ViewMeter(GpuThread& gpu, ViewFramesPointer frames, std::shared_ptr<StructureStore> structures, const TimingProtocol& rounds,
              QObject* parent = nullptr);
    ~ViewMeter() override;

    void measure(std::vector<Subject> subjects);
    /// Drops what was asked for; a frame that is being timed or judged ends before its next object.
    void cancel();
    /// Drops what was asked for, and leaves what is known of other scenes: one that is closed is not kept alive here.
    void leaveOthers(const ScenePointer& scene);
    /// How many references were computed so far; waits for the thread. For tests: truth is never computed twice.
    [[nodiscard]] size_t referencesComputed();

signals:
    void measured(int view, const cullscope::ui::ViewMetrics& figures);

private:
    struct Bench;  ///< objects that live on the GPU thread
    struct Job;    ///< one request and its progress

    /// Stops the frame of the former request.
    void beginAnew();
    void measureNext(Job& job, GpuJobs::Step& step);
    void deliver(GpuJobs::Step& step, int view, const ViewMetrics& figures);

    GpuThread& m_gpu;
    TimingProtocol m_rounds;
    std::shared_ptr<Bench> m_bench;
    GpuJobs m_jobs;
    std::stop_source m_stop;  ///< of the newest request
    uint64_t m_timings = 0;   ///< requests so far
};

}  // namespace cullscope::ui
