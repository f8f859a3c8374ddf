#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

#include "core/experiments/advice/adviser.h"
#include "core/measure/single_frames.h"

namespace cullscope::advice {

/// Asks for a stop after a time, or when the stop of something larger is asked for.
class Deadline {
public:
    Deadline(double seconds, const std::stop_token& whole);

    [[nodiscard]] std::stop_token token() const { return m_stop.get_token(); }
    /// Whether the time was over.
    [[nodiscard]] bool passed() const { return m_passed; }

private:
    std::stop_source m_stop;
    std::stop_callback<std::function<void()>> m_whole;
    std::atomic<bool> m_passed = false;
    std::mutex m_mutex;
    std::condition_variable_any m_wake;
    std::jthread m_clock;  // the last member: it ends before the others do
};

/// A strategy in the race.
struct Entrant {
    AdvisedStrategy figures;
    BuiltStrategyPointer built;
    bool eligible = false;                           ///< it may be chosen
    bool racing = false;                             ///< it draws on
    std::vector<std::vector<double>> probes, times;  ///< milliseconds by pose: of the first views, and of the race
    std::vector<bool> judged;                        ///< by pose

    [[nodiscard]] const StrategyInfo& info() const { return findStrategy(figures.strategy.id).info; }
};

/// The frames of an advice: draws, times and judges.
class Race {
public:
    Race(const AdviseRequest& request, const Progress& progress);

    /// Draws the path's pose, and the one before it where the strategy remembers. Milliseconds; none where the strategy refuses
    /// the view or takes longer than `seconds`: then its standing says so. Throws Error(Interrupted) on the request's stop.
    std::optional<double> draw(Entrant& entrant, size_t pose, double seconds);
    /// Compares the frame that was drawn last, of that strategy at that pose, with the truth; once a pose.
    void judge(Entrant& entrant, size_t pose);
    [[nodiscard]] View viewOf(size_t pose) const { return {m_request.path.camera(pose), m_request.size}; }
    [[nodiscard]] size_t poses() const { return m_request.path.poses.size(); }
    [[nodiscard]] size_t frames() const { return m_frames.drawn(); }
    [[nodiscard]] const GlInfo& gl() const { return m_gl; }

private:
    const AdviseRequest& m_request;
    const Progress& m_progress;
    GlInfo m_gl;
    SingleFrames m_frames;
    FrameLog m_log;  ///< of the frame drawn last
};

/// The numbers below n in an order in which the first ones of any length lie evenly among all.
[[nodiscard]] std::vector<size_t> spreadOrder(size_t n);

/// The sum over the views of the medians, milliseconds.
[[nodiscard]] double sumOf(const std::vector<std::vector<double>>& times);

/// The fastest of those that may be chosen and have been drawn at every view so far; null: there is none.
[[nodiscard]] Entrant* fastest(std::vector<Entrant>& entrants);

/// Fills in what each entrant's times say, beside those of the first one, which draws everything. Of one that left the race, by
/// the choice, which drew all views (null: there is none).
void setTimes(std::vector<Entrant>& entrants, const Entrant* choice);

/// Where the interval of a choice does not exclude that drawing everything is as fast, that, the fastest of it; else the choice.
/// Nothing is built or decided for a gain that may be none.
[[nodiscard]] Entrant* everythingWhereAsFast(std::vector<Entrant>& entrants, Entrant* choice);

/// The share of what any culling could save of drawing everything, by the first entrant and the limit among them.
[[nodiscard]] std::optional<RatioEstimate> headroomOf(const Entrant& choice, const std::vector<Entrant>& entrants);

/// The chosen one (null: none), the others by speed, those that may not be chosen, those that were not drawn, the limit.
[[nodiscard]] std::vector<const Entrant*> ranked(const std::vector<Entrant>& entrants, const Entrant* choice);

/// Over the poses at which both have times: the other's total time over the entrant's.
[[nodiscard]] RatioEstimate ratioBetween(const std::vector<std::vector<double>>& baseline,
                                         const std::vector<std::vector<double>>& subject);

}  // namespace cullscope::advice
