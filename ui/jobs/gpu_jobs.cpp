#include "ui/jobs/gpu_jobs.h"

#include <algorithm>

namespace cullscope::ui {

GpuJobs::~GpuJobs() {
    cancel();
    if (!m_gpu) return;
    // A step in hand may post one more, which finds itself stale: wait for both.
    m_gpu->run([] {});
    m_gpu->run([] {});
}

void GpuJobs::start(GpuThread& gpu, Work work, Needs needs) {
    cancel();
    add(gpu, std::make_shared<const Job>(Job{std::move(work), std::move(needs)}));
}

void GpuJobs::cancel() {
    m_newest = m_numbers.begin();
    m_underWay = 0;
}

void GpuJobs::add(GpuThread& gpu, const JobPointer& job) {
    m_gpu = &gpu;
    ++m_underWay;
    gpu.post([this, &gpu, number = m_newest, job] { run(gpu, number, job); }, job->needs.urgency);
}

void GpuJobs::run(GpuThread& gpu, uint64_t number, const JobPointer& job) {
    if (!m_numbers.isCurrent(number)) return;
    const auto held = [&] {
        const std::vector<SceneBuffersPointer>& needed = job->needs.buffers;
        return std::all_of(needed.begin(), needed.end(), [&](const SceneBuffersPointer& buffers) { return gpu.holds(buffers); });
    };
    Step step;
    bool lost = !held();
    if (!lost) {
        job->work(step);
        lost = !held();
    }
    if (lost) step = Step();
    if (lost && job->needs.lost) step.deliver(job->needs.lost);
    if (step.m_again) gpu.post([this, &gpu, number, job] { run(gpu, number, job); });
    QMetaObject::invokeMethod(
        this, [this, number, done = std::make_shared<const Step>(std::move(step))] { finish(number, *done); },
        Qt::QueuedConnection);
}

void GpuJobs::finish(uint64_t number, const Step& step) {
    if (m_numbers.isCurrent(number) && !step.m_again) --m_underWay;
    for (const Delivery& deliver : step.m_deliveries)
        if (m_numbers.isCurrent(number)) deliver();
}

}  // namespace cullscope::ui
