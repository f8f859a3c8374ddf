#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

namespace cullscope {

/// How long work reports back and is told to stop. Both members may be left empty.
/// Work that takes one polls `check` at least every 100 ms.
struct Progress {
    /// Called with the finished share in [0, 1] and an English name of the stage (marked with CULLSCOPE_TR).
    /// Called from the working thread; must be quick.
    std::function<void(double share, std::string_view stage)> report;
    std::stop_token stop;

    void tell(double share, std::string_view stage) const {
        if (report) report(share, stage);
    }
    /// Throws Error(Interrupted) when a stop was requested.
    void check() const;
    [[nodiscard]] bool stopRequested() const { return stop.stop_requested(); }
    /// This progress narrowed to [from, to] of the whole, for a sub-task.
    [[nodiscard]] Progress part(double from, double to) const;
};

}  // namespace cullscope
