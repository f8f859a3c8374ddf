#include "core/visibility/small_feature/frame_budget.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cullscope::small_feature {
namespace {

constexpr size_t kTimes = 3;
constexpr double kLeastStep = 0.05, kMostStep = 2.0, kMostEasing = 1.0;  // doublings
constexpr double kAim = 0.07;                                            // doublings below the budget
constexpr double kEasingGain = 0.5;
constexpr double kAsFast = 1.05;
constexpr double kOtherCost = 1.25;  ///< where the budget cannot be held, a time that differs by this factor begins anew

}  // namespace

void FrameBudget::change(double doublings) {
    m_doublings = std::clamp(doublings, kLeast, kMost);
    m_times.clear();
    m_steady = false;
}

bool FrameBudget::wait() {
    if (m_waiting == 0) return false;
    --m_waiting;
    return true;
}

void FrameBudget::follow(double milliseconds, double budget, bool standing) {
    if (!(milliseconds > 0.0) || !std::isfinite(milliseconds) || !(budget > 0.0)) return;
    if (standing && !m_standing) {
        m_times.clear();
        m_tried.clear();
        m_over.reset();
        m_held.reset();
        m_outOfReach.reset();
        m_again.reset();
        m_steady = false;
    }
    m_standing = standing;
    if (m_times.size() == kTimes) m_times.erase(m_times.begin());
    m_times.push_back(milliseconds);
    if (m_times.size() < 2) return;
    std::vector<double> sorted = m_times;
    std::ranges::sort(sorted);
    // Of two times the one that says less; of three the middle one.
    const double lower = sorted[(sorted.size() - 1) / 2], upper = sorted[sorted.size() / 2];
    if (lower > budget) return over(lower, budget);
    if (upper > budget) return;
    m_tried.clear();
    m_outOfReach.reset();
    m_held = m_doublings;
    if (upper < kRoom * budget) return ease(upper, budget);
    m_steady = true;
    m_again.reset();
}

void FrameBudget::over(double milliseconds, double budget) {
    if (m_outOfReach) {
        const double change = milliseconds / *m_outOfReach;
        if (wait() || (change < kOtherCost && change > 1.0 / kOtherCost)) return;
        m_outOfReach.reset();
        m_tried.clear();
    }
    if (m_again) m_patience = std::min(2 * m_patience, kMostPatience);
    m_over = std::max({m_doublings, m_over.value_or(m_doublings), m_again.value_or(m_doublings)});
    m_again.reset();
    m_waiting = m_patience;
    m_tried.push_back({m_doublings, milliseconds});
    const std::optional<double> held = std::exchange(m_held, std::nullopt);
    if (held && *held > m_doublings) return change(*held);
    if (m_doublings >= kMost) return giveBack();
    change(m_doublings + std::clamp(std::log2(milliseconds / budget) + kAim, kLeastStep, kMostStep));
}

void FrameBudget::ease(double milliseconds, double budget) {
    if (m_over && *m_over >= m_doublings) m_over.reset();  // the cost is another one by now
    const bool nextToOver = m_over && m_doublings - *m_over <= kNear;
    m_steady = nextToOver || m_doublings <= kLeast;
    if (m_doublings <= kLeast || (nextToOver && wait())) return;
    if (nextToOver) {
        m_again = std::exchange(m_over, std::nullopt);
    } else if (!m_over && !m_again) {
        m_patience = kPatience;
    }
    const double step = std::clamp(kEasingGain * std::log2(kRoom * budget / milliseconds), kLeastStep, kMostEasing);
    const double least = m_over ? (m_doublings + *m_over) / 2.0 : kLeast;
    change(std::max(least, m_doublings - step));
}

void FrameBudget::giveBack() {
    const double fastest = std::ranges::min(m_tried, {}, &Tried::milliseconds).milliseconds;
    std::erase_if(m_tried, [&](const Tried& one) { return one.milliseconds > kAsFast * fastest; });
    const Tried weakest = std::ranges::min(m_tried, {}, &Tried::doublings);
    m_tried.clear();
    m_over.reset();
    change(weakest.doublings);
    m_outOfReach = weakest.milliseconds;
    m_waiting = kMostPatience / 2;
    m_steady = true;
}

}  // namespace cullscope::small_feature
