#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/measure/frame_measurement.h"
#include "core/visibility/triangle_states.h"

namespace cullscope {

/// A strategy at a view, to be timed in turns beside others and judged.
struct ViewSubject {
    std::shared_ptr<const SceneBuffers> buffers;
    BuiltStrategyPointer strategy;
    View view;
    std::vector<ViewStatePointer> memories;  ///< of its pictures, before the frame (TimedFrames)
    /// The frame that the view shows already, decided with these memories, with its decisions recorded; null: none. It stands in
    /// the place of the warm-up.
    std::shared_ptr<const FrameLog> shown{};
    BuiltStrategyPointer baseline{};         ///< is timed in the same turns, at the same view; null: none
    BuiltStrategyPointer frontFaces{};       ///< likewise: the strong baseline, where `baseline` draws other sides; null: none
    BuiltStrategyPointer limit{};            ///< likewise: the limit of culling (limitOfCulling); null: none
    BuiltStrategyPointer baselineOfLimit{};  ///< likewise, with `limit`: the baseline that draws the same sides as it
    bool judged = true;                      ///< false: only its times are wanted
    std::vector<View> others{};              ///< of its pictures behind the first one, which is judged; empty: the same view
};

/// What any culling could gain at a view at most, and how much of that a strategy gains.
struct ViewHeadroom {
    RatioEstimate most;                  ///< speed of the limit of culling over the baseline that draws the same sides as it
    std::string baseline;                ///< strategyLabel of that baseline
    std::optional<RatioEstimate> share;  ///< shareOfHeadroom of this one view; none: it is not certain that time can be saved
};

/// Speed and errors of a strategy at a view, as far as they are known. Counts and errors are of the first frame that was timed,
/// as in a table. The states of triangles, which colour the picture, are of the frame that the view shows. The timed frames
/// repeat that one, with the memory that it began with, but record no decisions.
struct ViewFigures {
    double frameMilliseconds = 0.0;        ///< median, cull + draw
    double cullMilliseconds = 0.0;         ///< median; until the view is timed, of its first timed frame
    std::optional<RatioEstimate> speedup;  ///< over the baseline with the same facing rule: ratioOfTotals of this one view
    std::optional<RatioEstimate> speedupOverFrontFaces;  ///< over ViewSubject::frontFaces
    std::string baseline;                                ///< strategyLabel of what `speedup` is over
    std::optional<ViewHeadroom> headroom;                ///< with ViewSubject::limit
    std::vector<double> frameTimes;  ///< milliseconds by turn, those of all subjects of a measurement taken in the same turns
    bool timed = false;              ///< false: the errors are known, the speed is still being measured
    Submitted submitted;
    uint64_t consideredTriangles = 0;  ///< given to OpenGL, whole triangles and fragments alike
    uint64_t sceneTriangles = 0;
    Facing truthFacing = Facing::TwoSided;
    Viewport size;
    Accuracy accuracy;
    /// The number of missed pixels that the rasteriser's snapping of vertices does not explain. Only set where the snapping may
    /// explain some (JudgedFrame).
    std::optional<uint64_t> missedBeyondSnapping;
    /// Where snapping explains some: the pixels that are lost (JudgedFrame::lost). Null: all missed pixels are.
    std::shared_ptr<const std::vector<uint32_t>> lost;

    std::shared_ptr<const TriangleStates> states;  ///< of every triangle of the shown frame, beside the truth
    std::vector<Hole> holes;                       ///< largest first; of the lost pixels, or else of all missed ones
    std::vector<LostObject> lostObjects;           ///< most pixels first
    /// The promise at this camera, which may be weaker than the strategy's general promise.
    Promise promise = Promise::Approximate;

    /// Missed pixels that count as a loss.
    [[nodiscard]] uint64_t lostPixels() const { return missedBeyondSnapping.value_or(accuracy.missedPixels); }
    [[nodiscard]] double submittedShare() const { return submitted.share(sceneTriangles); }
};

/// Measures strategies at their views, together: all are timed in turns (TimedRounds), their baselines and the limit of culling
/// among them, and the first counted frame of each is judged against the truth. Of subjects that show a frame it is judged after
/// the first turn that counts, so that their errors are known before their speed is; of the others after all turns. Subjects that
/// show a frame share their turns where a frame of theirs is the same work; that of a strategy with a memory is its own. A frame
/// or a comparison a step, so that it can be left in between.
class ViewRounds {
public:
    /// `backwards`: as of TimedRounds.
    ViewRounds(std::vector<ViewSubject> subjects, const TimingProtocol& protocol, bool backwards = false);

    /// Returns the number of the subject that was judged in this step. Nothing happens once complete. Needs a current context.
    /// Throws what TimedRounds::step throws.
    std::optional<size_t> step(Renderer& renderer, References& references, const TimedRounds::TargetOf& targetOf,
                               const std::stop_token& stop = {});
    [[nodiscard]] bool complete() const;
    /// Whether no more frames are timed.
    [[nodiscard]] bool timed() const { return m_rounds->complete(); }
    /// The first subject whose frame the next timing step draws; where a step threw, of that one. Not once all are timed.
    [[nodiscard]] size_t next() const;
    /// Goes on without the frames of that one: it is neither timed nor judged.
    void dropNext() { m_rounds->dropNext(); }
    [[nodiscard]] bool dropped(size_t subject) const { return timed(m_places[subject].own).dropped; }

    /// The errors of a judged subject that shows a frame.
    [[nodiscard]] const ViewFigures& figures(size_t subject) const { return m_figures[subject]; }
    /// Adds a subject's times, once complete.
    void addTimes(size_t subject, ViewFigures& figures) const;
    /// Times and, of a judged subject, errors, once complete.
    [[nodiscard]] FrameMeasurement measurement(size_t subject) const;
    /// The memories with which a subject's next view begins.
    [[nodiscard]] std::vector<ViewStatePointer> takeMemories(size_t subject);
    /// The pixels that a judged subject lost (JudgedFrame::lost); empty where it was not judged.
    [[nodiscard]] std::vector<uint32_t> takeLost(size_t subject);

private:
    /// What is counted of a subject that shows no frame, for the field's figures.
    struct Further {
        std::vector<LostObject> lostObjects;
        std::vector<uint32_t> pictureDifferences;
    };

    /// Numbers among the frames that are timed.
    struct Place {
        size_t own = 0;
        std::optional<size_t> baseline{}, frontFaces{}, limit{}, baselineOfLimit{};
    };

    /// The next subject that is to be judged, of those that show a frame or of those that do not; none: all are.
    [[nodiscard]] std::optional<size_t> toJudge(bool shown) const;
    [[nodiscard]] std::optional<ViewHeadroom> headroom(size_t subject, const FrameMeasurement& own) const;
    void judgeNow(size_t subject, Renderer& renderer, References& references, const TimedRounds::TargetOf& targetOf);
    [[nodiscard]] const TimedFrames& timed(size_t place) const { return m_rounds->entrants()[place]; }

    std::vector<ViewSubject> m_subjects;
    std::vector<Place> m_places;  ///< by subject
    std::unique_ptr<TimedRounds> m_rounds;
    std::vector<std::optional<JudgedFrame>> m_judged;  ///< by subject, without the pixels; none: not yet
    std::vector<Further> m_further;                    ///< by subject
    std::vector<ViewFigures> m_figures;                ///< by subject
};

}  // namespace cullscope
