#pragma once

#include <cstdint>

namespace cullscope::small_feature {

/// Holds a frame time by one number, the strength of culling in doublings: 0 is what the parameters say, 1 twice as much, −1 half
/// as much. Knows nothing but the times that it is told.
///
/// A frame over its budget strengthens at once by the excess in doublings, at most one. A frame within the budget, but above 85 %
/// of it, changes nothing. Below that it eases, by at most a quarter of a doubling a frame, after a few frames of patience; where
/// easing led over the budget again, the patience doubles, so that a scene whose cost has a step at the budget does not swing.
class FrameBudget {
public:
    static constexpr double kLeast = -6.0, kMost = 10.0;          ///< doublings
    static constexpr double kRoom = 0.85;                         ///< share of the budget below which it eases
    static constexpr uint32_t kPatience = 2, kMostPatience = 64;  ///< frames

    /// The frame with the strength so far took so long; `budget`: how long it may take, in the same unit.
    void follow(double milliseconds, double budget);
    [[nodiscard]] double doublings() const { return m_doublings; }

private:
    double m_doublings = 0.0;
    uint32_t m_patience = kPatience, m_waiting = 0;
    uint32_t m_easings = 0;  ///< in a row, since a frame was over its budget or used it
    uint32_t m_settled = 0;  ///< frames in a row that used the budget
};

}  // namespace cullscope::small_feature
