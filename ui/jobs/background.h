#pragma once

#include <QObject>
#include <functional>
#include <list>
#include <stop_token>
#include <thread>

#include "ui/jobs/job_numbers.h"

namespace cullscope::ui {

/// Runs work on threads of its own and hands what it brings to the thread that owns this object.
/// Starting new work tells the old to stop and drops whatever it still brings; nothing here ever waits for it,
/// except the destructor.
class Background : public QObject {
    Q_OBJECT

public:
    /// What is to happen on the owner's thread when the work is done and still wanted.
    using Delivery = std::function<void()>;
    using Work = std::function<Delivery(const std::stop_token&)>;

    explicit Background(QObject* parent = nullptr) : QObject(parent) {}

    void start(Work work);
    void cancel();
    /// Whether wanted work is under way.
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
