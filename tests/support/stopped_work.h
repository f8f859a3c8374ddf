#pragma once

#include <ctime>
#include <stop_token>
#include <thread>

#include "core/base/error.h"
#include "core/base/work_check.h"

namespace cullscope::test {

/// Watches the steps of WorkCheck (core/base/work_check.h) while it exists. One at a time.
class WatchedWork {
public:
    WatchedWork() {
        s_steps = 0;
        s_longest = 0.0;
        s_last = ownMilliseconds();
        WorkCheck::observer = [](uint32_t steps) {
            s_steps += steps;
            tellTime();
        };
    }
    ~WatchedWork() { WorkCheck::observer = nullptr; }
    WatchedWork(const WatchedWork&) = delete;
    WatchedWork& operator=(const WatchedWork&) = delete;

    [[nodiscard]] uint64_t steps() const { return s_steps; }
    /// The longest time between two looks for a stop request so far, and since the last one, in milliseconds that the calling
    /// thread itself worked: other programs on the machine do not count.
    [[nodiscard]] double longestGap() const {
        tellTime();
        return s_longest;
    }

private:
    static double ownMilliseconds() {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
    }
    static void tellTime() {
        const double now = ownMilliseconds();
        s_longest = std::max(s_longest, now - s_last);
        s_last = now;
    }

    static inline std::atomic<uint64_t> s_steps{0};
    static inline double s_last = 0.0, s_longest = 0.0;  ///< of the thread that works
};

/// What became of work that another thread stopped on its way.
struct StoppedWork {
    bool interrupted = false;  ///< false: it was done before
    uint64_t stepsBefore = 0;  ///< when the stop was requested
    uint64_t stepsAfter = 0;   ///< made after the request
};

/// Runs `work(progress)`; another thread requests the stop once so many steps were made.
template <typename Work>
StoppedWork stoppedAfter(uint64_t steps, const Work& work) {
    const WatchedWork watched;
    std::stop_source source;
    std::atomic<bool> done{false};
    std::atomic<uint64_t> atRequest{0};
    std::thread stopper([&] {
        while (watched.steps() < steps && !done) std::this_thread::yield();
        source.request_stop();
        atRequest = watched.steps();
    });
    StoppedWork result;
    try {
        work(Progress{nullptr, source.get_token()});
    } catch (const Error& error) {
        result.interrupted = error.kind() == ErrorKind::Interrupted;
    }
    done = true;
    stopper.join();
    result.stepsBefore = atRequest;
    result.stepsAfter = watched.steps() > atRequest ? watched.steps() - atRequest : 0;
    return result;
}

}  // namespace cullscope::test
