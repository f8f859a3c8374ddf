#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "core/gpu/gpu_frame.h"
#include "core/visibility/built_strategy.h"

namespace cullscope {

/// The number of repetitions of a frame (docs/measuring.md, "Speed").
struct TimingProtocol {
    int warmUp = 1;            ///< rounds that are not counted
    bool warmUpOnce = false;   ///< over a path: before its first view only
    int fixedRepetitions = 0;  ///< 0: until the median is steady
    int leastRepetitions = 3;
    int mostRepetitions = 21;
    double steadyWithin = 0.02;            ///< relative change of every strategy's median over the last two rounds
    double longFrameMilliseconds = 250.0;  ///< a strategy with longer frames counts as steady after leastRepetitions
    double budgetSeconds = std::numeric_limits<double>::infinity();  ///< of drawing, after which no round beyond the least begins
    /// For tests: the milliseconds that are taken down for a strategy's next frame; empty: those that it took.
    std::function<double(const BuiltStrategy& strategy)> madeUpTime{};
};

/// One strategy at one view: what is drawn, and the times that it took. Every counted frame repeats the first one, which is
/// judged.
struct TimedFrames {
    const SceneBuffers* buffers = nullptr;
    BuiltStrategyPointer strategy;
    View view;
    std::vector<ViewStatePointer> memories;  ///< of as many pictures as a frame has; what a strategy that remembers begins with
    bool shown = false;  ///< a view shows this frame already, decided with these memories: that was the warm-up

    std::vector<double> frameMilliseconds{}, cullMilliseconds{};  ///< of the counted frames, cull + draw and cull of all pictures
    FrameLog log{};                                               ///< of the first counted frame's first picture: is judged
    std::vector<ViewStatePointer> left{};                         ///< the memories after that frame, of a strategy that remembers
    bool dropped = false;                                         ///< takes no part any more: its times and its log are not whole
    std::vector<View> others{};                                   ///< of the pictures behind the first one; empty: the same view

    /// The memories with which the next view begins.
    [[nodiscard]] std::vector<ViewStatePointer> takeMemories() { return std::move(left.empty() ? memories : left); }
};

/// The one protocol by which frames are timed, for both programs: the strategies are drawn in turns, every other round in reverse
/// order so that none always follows the same one, until the medians are steady. A strategy whose frames depend on the ones
/// before draws every repetition with the memory with which the view came here. A frame a step, so that it can be left between
/// frames.
class TimedRounds {
public:
    /// The framebuffer for a picture of a frame, of the size asked for; other pictures of the frame have other framebuffers.
    using TargetOf = std::function<Framebuffer&(const Viewport& size, size_t picture)>;

    /// `backwards`: of the rounds that are counted the first one is in reverse order, not the second.
    TimedRounds(std::vector<TimedFrames> entrants, const TimingProtocol& protocol, bool backwards = false);

    /// Times the next frame; it ends when the GPU has finished. Needs a current context. Nothing happens once complete. Throws
    /// Error(Interrupted) where the strategy ended its frame on the stop request; the frame does not count then.
    void step(Renderer& renderer, const TargetOf& targetOf, const std::stop_token& stop = {});
    /// The number of the entrant that the next step draws; of that one, where a step threw.
    [[nodiscard]] size_t next() const;
    /// Goes on without that entrant, whose strategy refuses the view. Not once complete.
    void dropNext();
    /// Whether a frame of each is counted: then their errors can be counted, too.
    [[nodiscard]] bool counted() const { return m_round > 0; }
    /// Whether no more frames are needed.
    [[nodiscard]] bool complete() const { return m_complete; }
    /// In the order in which they were given; of each as many frames are counted.
    [[nodiscard]] std::vector<TimedFrames>& entrants() { return m_entrants; }

private:
    [[nodiscard]] bool enough() const;
    [[nodiscard]] bool takesPart(const TimedFrames& entrant) const;
    /// To the next frame of an entrant that takes part.
    void goOn();

    std::vector<TimedFrames> m_entrants;
    TimingProtocol m_protocol;
    bool m_backwards;
    int m_round = 0;         ///< below 0: warm-up
    size_t m_place = 0;      ///< number of the next frame in the round
    double m_seconds = 0.0;  ///< of drawing
    bool m_complete = false;
};

}  // namespace cullscope
