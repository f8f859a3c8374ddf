#include "ui/jobs/background.h"

#include <QCoreApplication>
#include <system_error>

#include "core/base/error.h"

namespace cullscope::ui {

void Background::start(Work work, Failed failed) {
    stopAll();
    const uint64_t job = m_jobs.begin();
    m_busy = true;
    const auto onThread = [this, job, work = std::move(work), failed](const std::stop_token& stop) {
        Delivery deliver;
        try {
            deliver = work(stop);
        } catch (const std::exception& failure) {
            deliver = failed(failure);
        }
        post(job, std::move(deliver));
    };
    try {
        m_running.push_back({job, std::jthread(onThread)});
    } catch (const std::system_error& failure) {
        const Message why{
            QT_TRANSLATE_NOOP("core", "The system gives no thread for this: %1. Close other programs and try again."),
            {systemReason(failure.code().value())}};
        post(job, failed(Error(ErrorKind::Input, why)));
    } catch (const std::exception& failure) {
        post(job, failed(failure));
    }
}

void Background::post(uint64_t job, Delivery deliver) {
    QMetaObject::invokeMethod(
        this, [this, job, deliver = std::move(deliver)] { finish(job, deliver); }, Qt::QueuedConnection);
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
