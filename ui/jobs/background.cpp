#include "ui/jobs/background.h"

namespace cullscope::ui {

void Background::start(Work work) {
    stopAll();
    const uint64_t job = m_jobs.begin();
    m_busy = true;
    m_running.push_back({job, std::jthread([this, job, work = std::move(work)](const std::stop_token& stop) {
                             Delivery deliver = work(stop);
                             QMetaObject::invokeMethod(
                                 this, [this, job, deliver = std::move(deliver)] { finish(job, deliver); }, Qt::QueuedConnection);
                         })});
}

void Background::cancel() {
    stopAll();
    m_jobs.invalidate();
    m_busy = false;
}

void Background::stopAll() {
    for (Running& running : m_running) running.thread.request_stop();
}

void Background::finish(uint64_t job, const Delivery& deliver) {
    // The worker thread posted this call as its last action, so joining it takes no time.
    m_running.remove_if([job](const Running& running) { return running.job == job; });
    if (!m_jobs.isCurrent(job)) return;
    m_busy = false;
    if (deliver) deliver();
}

}  // namespace cullscope::ui
