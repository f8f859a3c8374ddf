#pragma once

#include <chrono>
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
        s_pause = 0;
        s_longest = 0.0;
        s_last = ownMilliseconds();
        WorkCheck::observer = [](uint32_t steps) {
            s_steps += steps;
            while (s_steps >= s_holdAt) std::this_thread::yield();
            if (const int pause = s_pause; pause > 0) std::this_thread::sleep_for(std::chrono::milliseconds(pause));
            tellTime();
        };
    }
    ~WatchedWork() { WorkCheck::observer = nullptr; }
    WatchedWork(const WatchedWork&) = delete;
    WatchedWork& operator=(const WatchedWork&) = delete;

    [[nodiscard]] uint64_t steps() const { return s_steps; }
    /// Work waits at its look after so many steps, until it is let go on.
    void holdAt(uint64_t steps) const { s_holdAt = steps; }
    void letGoOn() const { s_holdAt = UINT64_MAX; }
    /// Work sleeps so long at each of its looks from now on: so little is done while another thread gets to request a stop, and
    /// what is done later shows.
    void pauseAtEachLook(int milliseconds) const { s_pause = milliseconds; }
    /// The longest time between two looks for a stop request so far, and since the last one, in milliseconds that the calling
    /// thread itself worked: other programs on the machine do not count.
    [[nodiscard]] double longestGap() const {
        tellTime();
        return s_longest;
    }

    /// The time that the calling thread worked since its last look.
    [[nodiscard]] double sinceLastLook() const { return ownMilliseconds() - s_last; }

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
    static inline std::atomic<uint64_t> s_holdAt{UINT64_MAX};
    static inline std::atomic<int> s_pause{0};
    static inline double s_last = 0.0, s_longest = 0.0;  ///< of the thread that works
};

/// What became of work that another thread stopped on its way.
struct StoppedWork {
    bool interrupted = false;      ///< false: it was done before
    uint64_t stepsBefore = 0;      ///< when the stop was requested
    uint64_t stepsAfter = 0;       ///< made after the request
    double endMilliseconds = 0.0;  ///< of the working thread, from its last look to its end: what it freed took so long
};

/// Runs `work(progress)`; another thread requests the stop at the first look after so many steps. The work waits there for the
/// request, so that it cannot end before it on a busy machine.
template <typename Work>
StoppedWork stoppedAfter(uint64_t steps, const Work& work) {
    const WatchedWork watched;
    watched.holdAt(steps);
    std::stop_source source;
    std::atomic<bool> done{false};
    std::atomic<uint64_t> atRequest{0};
    std::thread stopper([&] {
        while (watched.steps() < steps && !done) std::this_thread::yield();
        source.request_stop();
        atRequest = watched.steps();
        watched.letGoOn();
    });
    StoppedWork result;
    try {
        work(Progress{nullptr, source.get_token()});
    } catch (const Error& error) {
        result.interrupted = error.kind() == ErrorKind::Interrupted;
        result.endMilliseconds = watched.sinceLastLook();
    }
    done = true;
    stopper.join();
    result.stepsBefore = atRequest;
    result.stepsAfter = watched.steps() > atRequest ? watched.steps() - atRequest : 0;
    return result;
}

}  // namespace cullscope::test
