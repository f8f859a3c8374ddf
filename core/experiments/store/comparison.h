#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/experiments/store/result_store.h"

namespace cullscope::store {

/// A strategy in two measurements, or two strategies of one.
struct Compared {
    std::string a, b;      ///< strategyText
    size_t poses = 0;      ///< that both have
    RatioEstimate ratio;   ///< how many times as fast B is as A (ratioOver): total times over the poses that both have
    bool inTurns = false;  ///< they were timed in turns, as in one measurement
    std::optional<Losses> lostByA, lostByB;  ///< over those poses
    double msOfA = 0.0, msOfB = 0.0;         ///< mean time of a frame over those poses
};

/// Compares what both have. `a` and `b`: a measurement's number, or number:strategy, as 3:frustum. Of two measurements without a
/// strategy every one that both have is compared. Throws Error(Usage) where they are of other scenes, camera paths or sizes, or
/// have no pose in common.
[[nodiscard]] std::vector<Compared> compared(const ResultStore& store, const std::string& a, const std::string& b);
/// The same of what was read.
[[nodiscard]] std::vector<Compared> compared(const Stored& a, const Stored& b);
/// "× 1.23 [1.10, 1.40]: B is faster", in one sentence, English with its values.
[[nodiscard]] Message verdict(const Compared& compared);

}  // namespace cullscope::store
