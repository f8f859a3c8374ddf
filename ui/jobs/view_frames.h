#pragma once

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/gpu/gpu_frame.h"
#include "core/image/view_picture.h"
#include "core/visibility/built_strategy.h"
#include "ui/jobs/gpu_thread.h"

namespace cullscope::ui {

/// All that a frame is decided from.
struct FrameRequest {
    SceneBuffersPointer buffers;
    BuiltStrategyPointer strategy;
    Camera culling;
    Viewport size;
    int view = 0;       ///< whose memory it has
    uint32_t turn = 0;  ///< of frames of one view that stands, which of them (ViewState::unsteady)

    /// Whether it is the same frame. How the scene was uploaded decides nothing.
    [[nodiscard]] bool sameFrame(const FrameRequest& other) const {
        return strategy == other.strategy && culling == other.culling && size == other.size && view == other.view &&
               turn == other.turn;
    }
    /// Whether it is a later frame of the same view, which stands.
    [[nodiscard]] bool laterTurnOf(FrameRequest other) const {
        if (turn <= other.turn) return false;
        other.turn = turn;
        return sameFrame(other);
    }
};

/// A frame that was decided. Its picture from any camera, its panels and its colours by verdict are replays of it.
struct ViewFrame {
    FrameRequest request;
    FrameLog log;
    bool unsteady = false;  ///< the view's next frame may be another one, although nothing changes (ViewState::unsteady)
    /// The states of a coarse scene's triangles in this frame (coarseStates), of the last one that was asked for: a view that
    /// looks at a frame from elsewhere moves while the frame stays. Used on the GPU thread.
    [[nodiscard]] const std::vector<TriangleState>& statesOf(const CoarseBuffersPointer& coarse) const;
    mutable CoarseBuffersPointer coarse{};
    mutable std::vector<TriangleState> coarseOnes{};
};
using ViewFramePointer = std::shared_ptr<const ViewFrame>;

/// A place in a frame's log: its first `entries` entries, where it has `whole` of them; in another log the same share.
struct LogPlace {
    size_t entries = 0, whole = 0;

    bool operator==(const LogPlace&) const = default;
};
/// The number of entries of a frame's log up to that place.
[[nodiscard]] size_t entriesUpTo(const ViewFrame& frame, const LogPlace& place);
/// The frame with the part of its log up to a place; without a place the frame itself. A null frame stays null.
[[nodiscard]] ViewFramePointer frameUpTo(const ViewFramePointer& frame, const std::optional<LogPlace>& place);

/// The frames of the views, each decided once, with each view's memory. Used on the GPU thread, but for what says otherwise.
class ViewFrames {
public:
    /// The view's frame, decided here if its newest one is another; the newest one where it is a later turn of the same. Its
    /// decisions are always recorded, so that whatever reads them later finds them in the frame that is shown. Throws what core
    /// throws.
    [[nodiscard]] ViewFramePointer of(const FrameRequest& request, Renderer& renderer);
    /// The frame of a view that the picture of another view is compared with. The view need not be shown, or show that frame yet:
    /// then it is decided here, with the memory that the view's next frame would have, and it becomes the view's own frame where
    /// the view asks for it next. It is known as long as its pointer lives.
    [[nodiscard]] ViewFramePointer ofOther(const FrameRequest& request, Renderer& renderer);
    /// The same for a picture that the view does not show, as of another size: with the memory with which the shown frame began.
    [[nodiscard]] ViewFramePointer beside(const FrameRequest& request, Renderer& renderer);
    /// The memory with which the view's frame began, if its newest frame is this one; else that of a view without a past.
    [[nodiscard]] ViewStatePointer memoryBefore(const FrameRequest& request) const;

    /// Tells the view's next frame how long its newest one, which is this, took until its picture was there: decided, without the
    /// drawing that a decision waits for, and drawn.
    void took(const FrameRequest& request, double milliseconds);

    /// Ends the frame that is being decided, and all to come: the window closes. On any thread.
    void stop() { m_stop.request_stop(); }
    /// Ends the frame of a view (none: of any) that is being decided, because it is not wanted any more. Requests of a view for
    /// frames of the same strategy that wait for the GPU thread end at once, too, until the view is interrupted again. On any
    /// thread.
    void interrupt(std::optional<int> view);
    /// Says by which strategy the view's frames are decided from now on (null: by none). A frame of the view by any other one
    /// that is being decided, or waits for the GPU thread, ends at once: it may take minutes. The frames that `beside` decides go
    /// on. On any thread.
    void want(int view, const BuiltStrategyPointer& strategy);

    /// Drops the frames, or those of a view whose strategy is another one by now.
    void forget() { m_views.clear(); }
    void forget(int view, const BuiltStrategyPointer& present);

    /// How many frames were decided for a view so far; on any thread. For tests: a frame is decided once.
    [[nodiscard]] size_t decided(int view) const;

private:
    /// A frame that was decided for another view's picture.
    struct Compared {
        std::weak_ptr<const ViewFrame> frame, follows;  ///< `follows`: the view's own frame at that time
        ViewStatePointer before, after;
    };
    struct Memory {
        ViewFramePointer frame;
        ViewStatePointer before, after;  ///< the view's memory before and after `frame`
        std::vector<Compared> compared;  ///< oldest first

        /// The frame if it was decided for another view's picture.
        [[nodiscard]] std::vector<Compared>::iterator find(const FrameRequest& request);
        /// The newest of those that follow the view's own frame and have this strategy.
        [[nodiscard]] const Compared* newest(const BuiltStrategyPointer& strategy) const;
        [[nodiscard]] bool follows(const Compared& one) const { return one.follows.lock() == frame; }
    };

    /// For whom a frame is decided: for what its view shows, or for a picture that no view shows.
    enum class For { View, Beside };

    /// What the frame of a view looks at; `end` follows.
    [[nodiscard]] std::stop_token begin(const FrameRequest& request, For whom);
    void end(int view, bool decided);
    [[nodiscard]] ViewFramePointer decide(const FrameRequest& request, ViewState& state, Renderer& renderer,
                                          For whom = For::View);
    /// Whether the view wants frames of another strategy by now. Called with m_mutex held.
    [[nodiscard]] bool overtaken(int view, const BuiltStrategyPointer& strategy) const;

    std::map<int, Memory> m_views;
    std::stop_source m_stop;
    mutable std::mutex m_mutex;
    std::map<int, size_t> m_decided;                               ///< guarded by m_mutex
    std::optional<int> m_deciding;                                 ///< the view whose frame is being decided; guarded by m_mutex
    For m_whom = For::View;                                        ///< it is decided for; guarded by m_mutex
    std::weak_ptr<const BuiltStrategy> m_strategy;                 ///< its strategy; guarded by m_mutex
    std::map<int, std::weak_ptr<const BuiltStrategy>> m_unwanted;  ///< by view; guarded by m_mutex
    std::map<int, std::weak_ptr<const BuiltStrategy>> m_wanted;    ///< by view; guarded by m_mutex
    std::stop_source m_stopOfThisFrame;                            ///< guarded by m_mutex
};
using ViewFramesPointer = std::shared_ptr<ViewFrames>;

/// The frames of pictures of one moment that no view shows, as the parts of a screenshot: those of the views' sizes are the
/// views' own, and of another size each is decided once, however many pictures and tiles replay it. Used on the GPU thread.
class FramesBeside {
public:
    explicit FramesBeside(ViewFramesPointer frames = nullptr) : m_frames(std::move(frames)) {}
    /// The frame, known as long as this object lives. Throws what core throws.
    [[nodiscard]] ViewFramePointer of(const FrameRequest& request, Renderer& renderer);

private:
    ViewFramesPointer m_frames;
    std::vector<ViewFramePointer> m_known;
};

/// Returns `look` without the boxes and the declared overlays that the strategy does not have in this frame, which was recorded.
[[nodiscard]] ViewLook shownLook(const ViewFrame& frame, ViewLook look);

}  // namespace cullscope::ui
