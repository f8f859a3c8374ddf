#include "core/measure/timed_rounds.h"

#include <algorithm>
#include <cmath>

#include "core/measure/render_frame.h"
#include "core/measure/statistics.h"

namespace cullscope {
namespace {

bool steady(const std::vector<double>& times, const TimingProtocol& protocol) {
    const double now = quantile(times, 0.5);
    if (now > protocol.longFrameMilliseconds) return true;
    const std::vector<double> before(times.begin(), times.end() - 2);
    return std::abs(quantile(before, 0.5) - now) <= protocol.steadyWithin * now;
}

}  // namespace

TimedRounds::TimedRounds(std::vector<TimedFrames> entrants, const TimingProtocol& protocol, bool backwards)
    : m_entrants(std::move(entrants)),
      m_protocol(protocol),
      m_backwards(backwards),
      m_round(-std::max(0, protocol.warmUp)),
      m_complete(m_entrants.empty()) {
    if (!m_complete && !takesPart(m_entrants[next()])) goOn();
}

void TimedRounds::step(Renderer& renderer, const TargetOf& targetOf, const std::stop_token& stop) {
    if (m_complete) return;
    TimedFrames& entrant = m_entrants[next()];
    std::vector<ViewStatePointer> cloned;
    if (entrant.strategy->info().remembers)
        for (const ViewStatePointer& memory : entrant.memories) cloned.push_back(memory->clone());
    std::vector<FrameTarget> pictures;
    for (size_t i = 0; i < entrant.memories.size(); ++i)
        pictures.push_back({&targetOf(entrant.view.viewport(), i), (cloned.empty() ? entrant.memories : cloned)[i].get(),
                            i > 0 && i <= entrant.others.size() ? &entrant.others[i - 1] : nullptr});
    FrameResult frame = renderFrame(renderer, *entrant.buffers, *entrant.strategy, entrant.view, pictures, {}, stop);
    if (m_protocol.madeUpTime) {
        frame.frameMilliseconds = m_protocol.madeUpTime(*entrant.strategy);
        for (const FrameTarget& picture : pictures) picture.state->frameMilliseconds = frame.frameMilliseconds;
    }
    m_seconds += frame.frameMilliseconds / 1000.0;
    if (m_round == 0) {
        entrant.log = std::move(frame.log);
        entrant.left = std::move(cloned);
    }
    if (m_round >= 0) {
        entrant.frameMilliseconds.push_back(frame.frameMilliseconds);
        entrant.cullMilliseconds.push_back(frame.cullMilliseconds);
    }
    goOn();
}

size_t TimedRounds::next() const { return (m_round % 2 == 0) != m_backwards ? m_place : m_entrants.size() - 1 - m_place; }

void TimedRounds::dropNext() {
    m_entrants[next()].dropped = true;
    m_complete = std::ranges::all_of(m_entrants, &TimedFrames::dropped);
    goOn();
}

void TimedRounds::goOn() {
    do {
        if (++m_place < m_entrants.size()) continue;
        m_place = 0;
        ++m_round;
        m_complete = m_complete || enough();
    } while (!m_complete && !takesPart(m_entrants[next()]));
}

bool TimedRounds::takesPart(const TimedFrames& entrant) const { return !entrant.dropped && (m_round >= 0 || !entrant.shown); }

bool TimedRounds::enough() const {
    if (m_round < 1) return false;
    if (m_protocol.fixedRepetitions > 0) return m_round >= m_protocol.fixedRepetitions;
    if (m_round >= m_protocol.mostRepetitions) return true;
    if (m_round >= m_protocol.leastRepetitions && m_seconds >= m_protocol.budgetSeconds) return true;
    // The median is compared with that of two rounds ago, so at least three rounds are needed.
    if (m_round < std::max(3, m_protocol.leastRepetitions)) return false;
    return std::ranges::all_of(
        m_entrants, [&](const TimedFrames& entrant) { return entrant.dropped || steady(entrant.frameMilliseconds, m_protocol); });
}

}  // namespace cullscope
