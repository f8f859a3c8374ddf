#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace cullscope {

/// How a long task reports its progress and learns that it is to stop. Both members may be left empty. A function that takes a
/// Progress calls `check` at least every 100 ms.
struct Progress {
    /// Called with the finished share in [0, 1] and an English name of the stage (marked with CULLSCOPE_TR). Called on the thread
    /// that does the work; must return quickly.
    std::function<void(double share, std::string_view stage)> report;
    std::stop_token stop;

    void tell(double share, std::string_view stage) const {
        if (report) report(share, stage);
    }
    /// Throws Error(Interrupted) when a stop was requested.
    void check() const;
    [[nodiscard]] bool stopRequested() const { return stop.stop_requested(); }
    /// The progress of a sub-task that covers the share [from, to] of this one.
    [[nodiscard]] Progress part(double from, double to) const;
};

}  // namespace cullscope
