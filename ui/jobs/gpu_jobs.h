#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>
#include <vector>

#include "ui/jobs/gpu_thread.h"
#include "ui/jobs/job_numbers.h"

namespace cullscope::ui {

/// One owner's work on the GPU thread, as Background is on threads of its own. Starting a new job drops whatever an older one
/// has not begun, and what it still brings. Nothing here ever waits, except the destructor: for what is at work. Used on the
/// owner's thread.
class GpuJobs : public QObject {
    Q_OBJECT

public:
    /// What is to happen on the owner's thread when a step is done and still wanted.
    using Delivery = std::function<void()>;

    /// One run of a job's work, on the GPU thread.
    class Step {
    public:
        void deliver(Delivery delivery) { m_deliveries.push_back(std::move(delivery)); }
        /// The work is to be run once more, after what waits by then.
        void again() { m_again = true; }

    private:
        friend class GpuJobs;

        std::vector<Delivery> m_deliveries;
        bool m_again = false;
    };

    using Work = std::function<void(Step&)>;

    /// What a job needs besides the thread.
    struct Needs {
        /// Where the present context does not hold them before or after a step, that is the last one, and what it brings is
        /// dropped.
        std::vector<SceneBuffersPointer> buffers{};
        Delivery lost{};                  ///< in place of what was dropped so; may be empty
        Urgency urgency = Urgency::Work;  ///< of the first step
    };

    using QObject::QObject;
    ~GpuJobs() override;

    void start(GpuThread& gpu, Work work, Needs needs);
    void start(GpuThread& gpu, Work work) { start(gpu, std::move(work), Needs()); }
    /// One more, which counts as long as those that were added since the newest start or cancel.
    void add(GpuThread& gpu, Work work) { add(gpu, std::make_shared<const Job>(Job{std::move(work), Needs()})); }
    void cancel();
    /// Whether wanted work is under way.
    [[nodiscard]] bool busy() const { return m_underWay > 0; }

private:
    struct Job {
        Work work;
        Needs needs;
    };
    using JobPointer = std::shared_ptr<const Job>;

    void add(GpuThread& gpu, const JobPointer& job);
    void run(GpuThread& gpu, uint64_t number, const JobPointer& job);
    void finish(uint64_t number, const Step& step);

    QPointer<GpuThread> m_gpu;  ///< that work was posted to; null: to none, or it is gone
    JobNumbers m_numbers;
    uint64_t m_newest = 0;
    int m_underWay = 0;
};

}  // namespace cullscope::ui
