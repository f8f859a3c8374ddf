#include "core/visibility/small_feature/frame_budget.h"

#include <algorithm>
#include <cmath>

namespace cullscope::small_feature {
namespace {

constexpr double kLeastStep = 0.05, kMostStep = 1.0, kMostEasing = 0.25;  // doublings
constexpr double kAim = 0.07;                                             // doublings below the budget
constexpr double kEasingGain = 0.5;
/// So many easings, or settled frames, in a row are no mistake: the patience is as at the beginning.
constexpr uint32_t kProven = 16;

}  // namespace

void FrameBudget::follow(double milliseconds, double budget) {
    if (!(milliseconds > 0.0) || !std::isfinite(milliseconds) || !(budget > 0.0)) return;
    const double excess = std::log2(milliseconds / budget), room = std::log2(kRoom) - excess;
    if (excess > 0.0) {
        if (m_easings > 0) m_patience = std::min(2 * m_patience, kMostPatience);
        m_waiting = m_patience;
        m_easings = m_settled = 0;
        m_doublings = std::min(kMost, m_doublings + std::clamp(excess + kAim, kLeastStep, kMostStep));
        return;
    }
    if (room <= 0.0) {
        m_easings = 0;
        if (++m_settled >= kProven) m_patience = kPatience;
        return;
    }
    m_settled = 0;
    if (m_waiting > 0) {
        --m_waiting;
        return;
    }
    if (m_doublings <= kLeast) return;
    if (++m_easings >= kProven) m_patience = kPatience;
    m_doublings = std::max(kLeast, m_doublings - std::clamp(kEasingGain * room, kLeastStep, kMostEasing));
}

}  // namespace cullscope::small_feature
