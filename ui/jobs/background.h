#pragma once

#include <QObject>
#include <functional>
#include <list>
#include <stop_token>
#include <thread>

#include "ui/jobs/job_numbers.h"

namespace cullscope::ui {

/// Runs work on worker threads and delivers its result on the thread that owns this object. Starting new work requests the old
/// work to stop and drops its result. Only the destructor waits for the worker threads.
class Background : public QObject {
    Q_OBJECT

public:
    /// Runs on the owner's thread after the work has finished, unless newer work was started or the work was cancelled.
    using Delivery = std::function<void()>;
    using Work = std::function<Delivery(const std::stop_token&)>;

    explicit Background(QObject* parent = nullptr) : QObject(parent) {}

    void start(Work work);
    void cancel();
    /// Whether work is running that was neither cancelled nor replaced by newer work.
    [[nodiscard]] bool busy() const { return m_busy; }

private:
    struct Running {
        uint64_t job;
        std::jthread thread;
    };

    void finish(uint64_t job, const Delivery& deliver);
    void stopAll();

    JobNumbers m_jobs;
    bool m_busy = false;
    std::list<Running> m_running;
};

}  // namespace cullscope::ui
