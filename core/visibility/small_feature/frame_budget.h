#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace cullscope::small_feature {

/// Holds a frame time by one number, the strength of culling in doublings: 0 is what the parameters say, 1 twice as much, −1 half
/// as much. Knows nothing but the times that it is told.
///
/// It follows the middle one of the last three times at the present strength, and of two only what both say, so that one slow
/// frame changes nothing. Over the budget it strengthens by the excess in doublings, at most two. From 85 % to 100 % of the
/// budget nothing changes. Below that it eases in proportion, at most a doubling at once, and comes no nearer than halfway to a
/// strength that was over the budget. One that lies next to it is tried again after a few frames of patience, which doubles where
/// it is over the budget again, so that a scene whose cost has a step at the budget does not swing. What was found in motion says
/// nothing of a view that stands.
///
/// Where even the most strength is over the budget, what gains no time is given back: it returns to the weakest strength that is
/// as fast as the fastest one, within 5 %.
class FrameBudget {
public:
    static constexpr double kLeast = -6.0, kMost = 4.0;            ///< doublings
    static constexpr double kRoom = 0.85;                          ///< share of the budget below which it eases
    static constexpr double kNear = 0.15;                          ///< doublings: the strengths between are not told apart
    static constexpr uint32_t kPatience = 4, kMostPatience = 128;  ///< frames

    /// The frame with the strength so far took so long; `budget`: how long it may take, in the same unit. `standing`: the next
    /// frame is that of the same view; what was found in motion is tried anew there.
    void follow(double milliseconds, double budget, bool standing = false);
    [[nodiscard]] double doublings() const { return m_doublings; }
    /// Whether more frames of this cost would, for the time being, change nothing.
    [[nodiscard]] bool steady() const { return m_steady; }

private:
    struct Tried {
        double doublings = 0.0, milliseconds = 0.0;
    };

    void change(double doublings);
    void over(double milliseconds, double budget);
    void ease(double milliseconds, double budget);
    void giveBack();
    /// Whether a frame of patience was left.
    bool wait();

    double m_doublings = 0.0;
    bool m_steady = false;
    std::vector<double> m_times;         ///< the last ones at this strength
    std::vector<Tried> m_tried;          ///< over the budget, since it was held last
    std::optional<double> m_over;        ///< the strongest strength that was over the budget
    std::optional<double> m_held;        ///< the weakest one that was not, since then
    std::optional<double> m_outOfReach;  ///< the budget cannot be held: ms at the strength that was given back to
    uint32_t m_patience = kPatience, m_waiting = kPatience;
    std::optional<double> m_again;  ///< this strength was over the budget and is tried again
    bool m_standing = false;
};

}  // namespace cullscope::small_feature
