#include "core/experiments/store/recorder.h"

namespace cullscope::store {

Recorder::Recorder(const std::filesystem::path& file, Origin origin) : m_store(file), m_origin(std::move(origin)) {}

void Recorder::afterPose(const Meter& meter) {
    const std::lock_guard lock(m_mutex);
    if (m_failure) return;
    try {
        if (!m_current) m_current = m_store.begin(meter, m_origin);
        m_store.addPose(*m_current, meter);
        m_newest = m_current;
    } catch (const Error& error) {
        m_failure = error;
    }
}

void Recorder::end(bool interrupted) {
    const std::lock_guard lock(m_mutex);
    const std::optional<int64_t> ended = std::exchange(m_current, std::nullopt);
    if (m_failure || !ended) return;
    try {
        m_store.end(*ended, interrupted);
    } catch (const Error& error) {
        m_failure = error;
    }
}

std::optional<int64_t> Recorder::newest() const {
    const std::lock_guard lock(m_mutex);
    return m_newest;
}

std::optional<Error> Recorder::failure() const {
    const std::lock_guard lock(m_mutex);
    return m_failure;
}

MeasureResult measureInto(Recorder* recorder, const MeasureRequest& request, const Progress& progress, MeasuredScene* shared) {
    if (recorder == nullptr) return measure(request, progress, {}, shared);
    MeasureResult result = measure(
        request, progress, [&](const Meter& meter) { recorder->afterPose(meter); }, shared);
    recorder->end(result.interrupted);
    return result;
}

}  // namespace cullscope::store
