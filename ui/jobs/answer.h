#pragma once

#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>

#include "core/base/error.h"

namespace cullscope::ui {

/// A value that one thread waits for and another one gives, once.
template <typename Value>
class Answer {
public:
    void give(Value value) {
        const std::lock_guard lock(m_mutex);
        m_value = std::move(value);
        m_given.notify_all();
    }
    void fail(std::exception_ptr failure) {
        const std::lock_guard lock(m_mutex);
        m_failure = std::move(failure);
        m_given.notify_all();
    }
    /// Throws what was given in place of a value, and Error(Interrupted) on a stop request.
    [[nodiscard]] Value wait(const std::stop_token& stop) {
        std::unique_lock lock(m_mutex);
        if (!m_given.wait(lock, stop, [this] { return m_value || m_failure; })) throwInterrupted();
        if (m_failure) std::rethrow_exception(m_failure);
        return std::move(*m_value);
    }

private:
    std::mutex m_mutex;
    std::condition_variable_any m_given;
    std::optional<Value> m_value;
    std::exception_ptr m_failure;
};

}  // namespace cullscope::ui
