#pragma once

#include <QObject>
#include <functional>
#include <list>
#include <stop_token>
#include <thread>

#include "ui/jobs/job_numbers.h"

namespace cullscope::ui {

/// Runs work on worker threads and delivers its result on the thread that owns this object. Starting new work requests the old
/// work to stop and drops its result. An exception that leaves the work becomes a delivery of its failure. Only the destructor
/// waits for the worker threads.
class Background : public QObject {
    Q_OBJECT

public:
    /// Runs on the owner's thread after the work has finished, unless newer work was started or the work was cancelled.
    using Delivery = std::function<void()>;
    using Work = std::function<Delivery(const std::stop_token&)>;
    /// What is delivered where the work failed: `failure` is the exception that left it, or an Error that says that the system
    /// gives no thread for it. Called on the work's thread, or in the latter case on the owner's.
    using Failed = std::function<Delivery(const std::exception& failure)>;

    explicit Background(QObject* parent = nullptr) : QObject(parent) {}

    /// Where no thread can be started the object is busy all the same, until the failure is delivered: callers meet it in one
    /// way.
    void start(Work work, Failed failed);
    void cancel();
    /// Whether work is running that was neither cancelled nor replaced by newer work.
    [[nodiscard]] bool busy() const { return m_busy; }

private:
    struct Running {
        uint64_t job;
        std::jthread thread;
    };

    /// Delivers on the owner's thread, once its events are handled; may be called on any thread.
    void post(uint64_t job, Delivery deliver);
    void finish(uint64_t job, const Delivery& deliver);
    void stopAll();

    JobNumbers m_jobs;
    bool m_busy = false;
    std::list<Running> m_running;
};

}  // namespace cullscope::ui
