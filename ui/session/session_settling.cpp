// Views that came to rest and whose strategy is not settled: they get further frames, though nothing changes.
#include <algorithm>

#include "ui/session/session.h"

namespace cullscope::ui {

namespace {

/// So many frames settle any strategy that settles at all.
constexpr uint32_t kMostTurns = 60;

}  // namespace

std::optional<Session::Stand> Session::standOf(int view) const {
    const std::optional<MetricsSubject> now = subject(view);
    return now ? std::optional(Stand{now->strategy.get(), now->culling, now->size}) : std::nullopt;
}

void Session::comeToRest() {
    for (const int view : measuredViews()) {
        ViewState& state = m_views[size_t(view)];
        const std::optional<Stand> now = standOf(view);
        if (now == state.standsAt) continue;
        state.standsAt = now;
        state.turns = 0;
    }
}

bool Session::letSettle() {
    // A stepped frame stays, and experiments have the machine for themselves.
    if (!m_pictures || m_step || m_question || !m_measuring) return false;
    bool awaited = false, asked = false;
    for (const int view : shownViews()) {
        ViewState& state = m_views[size_t(culledBy(view))];
        if (!state.standsAt || standOf(culledBy(view)) != state.standsAt) continue;
        if (!m_pictures->isCurrent(view)) {
            awaited = awaited || (state.turns > 0 && !m_views[size_t(view)].complained);
            continue;
        }
        const ViewPicturePointer& shown = m_pictures->picture(view);
        if (!shown->frame->unsteady || !shown->timed || state.turns >= kMostTurns) continue;
        ++state.turn;
        ++state.turns;
        asked = true;
    }
    if (asked) update();
    return awaited || asked;
}

void Session::goOnSettling() {
    if (!letSettle() && m_underWay.empty() && !m_rest.isActive() && !metricsSettled()) m_rest.start();
}

}  // namespace cullscope::ui
