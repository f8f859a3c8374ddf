#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>

#include "core/frame/frame_log.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// Boxes that OpenGL's selection mode hit.
struct SelectedBoxes {
    std::vector<uint32_t> hits;             ///< indices into the span, used as the boxes' names, ascending
    size_t bufferWords = 0;                 ///< size of the hit buffer that held all records; four words for each hit
    int overflows = 0;                      ///< how often a smaller buffer was too small
    std::vector<HitDistances> distances{};  ///< by hit
};

/// What a strategy may do within a frame; writes the frame's log. Commands are executed as they come. This class executes none of
/// them and has no answers: it serves strategies that decide on the processor, wherever no picture is needed; a context of the
/// gpu layer (gpu/gpu_frame.h) draws.
class FrameContext {
public:
    /// `recording`: whether decisions are asked for.
    FrameContext(const Scene& scene, const View& culling, bool recording);
    virtual ~FrameContext() = default;
    FrameContext(const FrameContext&) = delete;
    FrameContext& operator=(const FrameContext&) = delete;

    [[nodiscard]] const Scene& scene() const { return m_scene; }
    /// The culling view.
    [[nodiscard]] const View& view() const { return m_view; }

    /// Ends the frame early where a stop is requested: a strategy that works for long within a frame looks for it, and throws
    /// Error(Interrupted). Set before the strategy draws.
    void stopBy(std::stop_token stop) { m_stop = std::move(stop); }
    [[nodiscard]] const std::stop_token& stop() const { return m_stop; }

    /// Draws ranges of the scene's triangles.
    void draw(DrawList list);
    /// Draws triangles that the strategy made.
    void draw(OwnTrianglesPointer triangles);
    /// Shows a picture that the strategy made. Throws Error(Usage) where it has not the culling view's size.
    void show(FinishedPicturePointer picture);
    /// Draws those of the candidates that the GPU chooses. When the frame ends the log gets them, and it is counted and said what
    /// became of each candidate. Throws Error(OpenGl) without OpenGL.
    void drawChosen(const GpuChoice& choice);

    /// Draws those of the candidates that a question of this frame finds visible: range i where the answer has number i. Where
    /// OpenGL can draw indirectly, the frame does not wait for the answer. When it ends the log gets them, and what was left out
    /// counts as hidden; what becomes of them is the strategy's to say (`answer`, while recording). Throws Error(OpenGl) without
    /// OpenGL, and Error(Usage) where the question has not as many answers.
    void drawVisible(BoxTicket& ticket, const DrawList& candidates);

    /// The boxes, relative to the eye, that OpenGL's selection mode hits (gpu/renderer.h); with a hit buffer of `bufferWords`.
    /// Throws Error(OpenGl) without OpenGL or without a compatibility profile.
    [[nodiscard]] SelectedBoxes selectBoxes(std::vector<EyeBox> boxes, size_t bufferWords);
    /// The boxes, relative to the eye, that cover a sample of the picture: of all samples (BoxQuestion::Samples), or of those at
    /// which they lie before what the frame has drawn so far (DepthSoFar; Pyramid, which hides a little less). As indices into
    /// the span, ascending. A box that holds a point of the near rectangle may cover none (see gpu/renderer.h), but is visible by
    /// a pyramid. With `ends`, consecutive boxes have one answer together, whether any of them covers such a sample: group g ends
    /// before box ends[g]; the answer has the numbers of the groups. Throws Error(OpenGl) without OpenGL, and Error(Usage) where
    /// a group is empty or the last one does not end at the last box.
    [[nodiscard]] std::vector<uint32_t> visibleBoxes(std::vector<EyeBox> boxes, BoxQuestion question,
                                                     std::vector<uint32_t> ends = {});
    /// Asks the same (Samples, DepthSoFar or Pyramid) without waiting: `answer` gets the answer, later in this frame or in a
    /// later one. Throws as visibleBoxes does.
    [[nodiscard]] BoxTicketPointer ask(std::vector<EyeBox> boxes, BoxQuestion question, std::vector<uint32_t> ends = {});
    /// The answer to a question of this or an earlier frame, as visibleBoxes gives it; waits where OpenGL is not that far. It can
    /// be asked for any number of times. None where the question was asked of another OpenGL context, or of one that is gone.
    [[nodiscard]] std::optional<std::vector<uint32_t>> answer(BoxTicket& ticket);

    /// What each box of a question by a pyramid was compared with; waits as `answer` does. Empty for other questions, and where
    /// there is no answer.
    [[nodiscard]] std::vector<PyramidReading> readings(BoxTicket& ticket);

    /// The scene's triangles that the exact picture of the culling view shows under the frame's facing rule, ascending, each
    /// once: for what a strategy that knew them beforehand could gain. Finding them counts into no time of the frame
    /// (untimedMilliseconds). Throws Error(OpenGl) without OpenGL.
    [[nodiscard]] std::vector<uint32_t> visibleTriangles();
    /// Works out beforehand, from those triangles, what a strategy that knew them could draw: that counts into no time of the
    /// frame either.
    void workOutUntimed(const std::function<void()>& work);

    /// Whether decisions are asked for; where they are not, nothing has to be prepared for them.
    [[nodiscard]] bool recording() const { return m_log.recorded; }
    /// Adds a decision where it falls. Only while recording.
    void say(Decision decision);
    /// The same about a node that is decided as a whole with these objects.
    void say(Decision decision, std::span<const uint32_t> objects);
    /// Says what this frame's decisions leave out (FrameLog::coarser), in a few words without a full stop. Only while recording.
    void sayCoarser(Message words) { m_log.coarser.push_back(std::move(words)); }
    /// How many decisions were said so far.
    [[nodiscard]] size_t said() const { return m_log.decisions.size(); }
    /// The order in which decisions about cells count the places of their triangles. Only while recording.
    void countPlacesIn(TriangleOrderPointer order) { m_log.order = std::move(order); }
    /// What a decision found besides its operands: the newest one about `subject`, if there is one since `said()` was `since`,
    /// else the newest of all. Only while recording, after a decision.
    void attach(std::shared_ptr<const DecisionDetail> detail, const Subject& subject, size_t since);
    /// The same of the newest decision.
    void attach(std::shared_ptr<const DecisionDetail> detail);

    [[nodiscard]] FrameCounters& counters() { return m_log.counters; }
    void addStage(const char* name, double milliseconds) { m_log.stages.push_back({name, milliseconds}); }
    /// The facing rule of the frame.
    [[nodiscard]] Facing facing() const { return m_log.facing; }
    void setFacing(Facing facing) { m_log.facing = facing; }

    /// How long the view's frame before took, for strategies that hold a frame time; none for the first one, and where frames are
    /// not timed. What it decides by that stands in the log, so that no replay depends on a clock.
    [[nodiscard]] std::optional<double> frameBeforeMilliseconds() const { return m_log.frameBeforeMilliseconds; }
    void setFrameBefore(std::optional<double> milliseconds) { m_log.frameBeforeMilliseconds = milliseconds; }

    /// Time spent in executing and logging draw commands so far.
    [[nodiscard]] double drawingMilliseconds() const { return m_drawingMilliseconds; }
    /// Time that belongs to no part of the frame, which a measurement leaves out.
    [[nodiscard]] double untimedMilliseconds() const { return m_untimedMilliseconds; }
    void setCullMilliseconds(double milliseconds) { m_log.cullMilliseconds = milliseconds; }
    /// The frame's log, once; what the GPU chose is read back, for which a caller that measures waits first.
    [[nodiscard]] FrameLog take();

protected:
    /// Executes a command that draws or shows.
    virtual void execute(const Command& /*command*/) {}
    /// Draws what the GPU chooses; `command` is the number of the command whose draw list `readBack` fills.
    virtual void executeChoice(const GpuChoice& choice, size_t command);
    /// The same of the candidates that a question finds visible.
    virtual void executeVisible(BoxTicket& ticket, const DrawList& candidates, size_t command);
    virtual void readBack(FrameLog& /*log*/) {}
    [[nodiscard]] virtual SelectedBoxes answerSelection(std::span<const EyeBox> boxes, size_t bufferWords);
    [[nodiscard]] virtual std::vector<uint32_t> answerQuestion(std::span<const EyeBox> boxes, std::span<const uint32_t> ends,
                                                               BoxQuestion question);
    [[nodiscard]] virtual BoxTicketPointer putQuestion(std::span<const EyeBox> boxes, std::span<const uint32_t> ends,
                                                       BoxQuestion question);
    [[nodiscard]] virtual std::optional<std::vector<uint32_t>> fetchAnswer(BoxTicket& ticket);
    [[nodiscard]] virtual std::vector<PyramidReading> fetchReadings(BoxTicket& ticket);
    /// As visibleTriangles, when all work before has ended.
    [[nodiscard]] virtual std::vector<uint32_t> findVisible();
    [[nodiscard]] const FrameLog& log() const { return m_log; }

private:
    /// Candidates among which the GPU chooses; `command`: the number of the draw list of those chosen.
    struct Candidates {
        size_t command = 0;
        std::vector<DrawRange> ranges;
        Cause leftOut = Cause::Hidden;
    };

    /// Candidates of which a question decides.
    struct Asked {
        size_t command = 0;  ///< the number of the draw list of those that are visible
        uint64_t triangles = 0;
    };

    void add(Command command);
    /// Adds the list of those candidates that are chosen later, and has it executed. Returns its number.
    size_t addChosen(const DrawList& candidates, const std::function<void(size_t)>& execute);
    /// Counts the candidates that were not chosen, and says what became of each object.
    void endChoice(const Candidates& candidates);

    const Scene& m_scene;
    const View& m_view;
    FrameLog m_log;
    std::vector<Candidates> m_choices;
    std::vector<Asked> m_asked;
    std::stop_token m_stop;
    double m_drawingMilliseconds = 0.0;
    double m_untimedMilliseconds = 0.0;
};

/// Measures the time from its construction to its destruction and adds it to a frame as a stage. Drawing does not count.
class StageTimer {
public:
    StageTimer(FrameContext& frame, const char* name);
    ~StageTimer();
    StageTimer(const StageTimer&) = delete;
    StageTimer& operator=(const StageTimer&) = delete;

private:
    FrameContext& m_frame;
    const char* m_name;
    double m_drawingBefore, m_untimedBefore;
    std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

/// A test whether a subject lies outside a plane: `inner` is the signed distance of the bounds' point farthest inside. The result
/// is Outside only below −margin, else Straddles: how much of the bounds lies inside was not tested.
[[nodiscard]] Decision outsideTest(const Subject& subject, FrustumPlane plane, double inner, double margin);
/// The same with a test whether all of it lies inside: `outer` is the signed distance of the bounds' point farthest outside. The
/// result is Inside only above the margin.
[[nodiscard]] Decision planeTest(const Subject& subject, FrustumPlane plane, double inner, double outer, double margin);
/// A test of a subject by separating axes (geometry/separation.h), after its planes.
[[nodiscard]] Decision axisTest(const Subject& subject, bool outside, double margin);
/// The end of a subject's decisions.
[[nodiscard]] Decision ending(const Subject& subject, Decision::Outcome outcome, Cause cause = Cause::OutsideFrustum);

}  // namespace cullscope
