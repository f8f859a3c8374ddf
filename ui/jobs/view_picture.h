#pragma once

#include <QColor>
#include <QImage>
#include <memory>
#include <optional>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/measure/accuracy.h"
#include "core/scene/section.h"
#include "core/visibility/plane_colours.h"
#include "ui/jobs/gpu_thread.h"
#include "ui/jobs/view_frames.h"
#include "ui/jobs/view_setup.h"

namespace cullscope::ui {

using TriangleStatesPointer = std::shared_ptr<const TriangleStates>;

/// All inputs of one view's picture: equal requests make equal pictures.
struct ViewRequest {
    SceneBuffersPointer buffers;
    BuiltStrategyPointer strategy;
    Camera culling;
    Viewport cullingSize;
    int culledBy = 0;   ///< the view whose frame the picture replays
    uint32_t turn = 0;  ///< and which of its frames while it stands
    Camera viewing;
    Viewport size;
    ViewLook look;
    DrawStyle style;
    std::optional<Section> section;  ///< that cuts the picture, and never the frame
    TriangleStatesPointer states;    ///< against the truth, if that is known already; else null
    /// With Wipe::Mode::Loss, where it is known that snapping explains some missed pixels: those that are lost. Else null.
    std::shared_ptr<const std::vector<uint32_t>> lost{};
    Wipe::Mode wipe = Wipe::Mode::None;
    BuiltStrategyPointer other;      ///< the other strategy in Wipe::Mode::OtherView and Difference
    int otherView = 0;               ///< with `other`: the view that it is the strategy of
    uint32_t otherTurn = 0;          ///< and which of its frames
    std::optional<LogPlace> upTo{};  ///< where a replay of the frame stops; none: at its end
    /// A coarse scene of the same objects that the picture is drawn with; null: the scene itself. The frame is the same.
    CoarseBuffersPointer coarse{};
    bool unanswered = false;  ///< all triangles are shown in place of the frame: what a strategy decided is not told yet

    [[nodiscard]] bool complete() const { return buffers && strategy && strategy->scenePointer() == buffers->scenePointer(); }
    /// The view that the picture shows, cut where it is a section.
    [[nodiscard]] View shownView() const;
    /// The frame that the picture replays, and the one beside which it is shown (with `other`).
    [[nodiscard]] FrameRequest frame() const { return {buffers, strategy, culling, cullingSize, culledBy, turn}; }
    [[nodiscard]] FrameRequest otherFrame() const { return {buffers, other, culling, cullingSize, otherView, otherTurn}; }
    bool operator==(const ViewRequest&) const = default;
};

/// A picture with the picture it is compared with. The rows of images start at the top, those of arrays at the bottom.
struct ViewPicture {
    ViewRequest request;
    ViewFramePointer frame;  ///< what is shown of it: with `upTo` its part
    QImage colour;
    QImage ahead;                      ///< what the part of the frame decided to draw and did not draw yet; null: nothing
    std::vector<float> depth;          ///< reversed depth of `colour`
    ViewFramePointer otherFrame{};     ///< that `other` replays, where it is another view's
    QImage other;                      ///< the truth, or the other view's picture; null without a wipe
    QImage marks;                      ///< premultiplied colours of the differing pixels, grown to 5 × 5; null without a wipe
    uint64_t missed = 0, added = 0;    ///< pixels at which `colour` shows a farther or a nearer surface than `other`
    uint64_t withinSnapping = 0;       ///< of the missed ones: those that the request does not count as lost
    uint64_t consideredTriangles = 0;  ///< triangles submitted to OpenGL
    double milliseconds = 0.0;         ///< that it took in all, with the frame's decisions where they were new
    bool timed = false;                ///< the view's next frame was told how long this one took
    PlaneCounts planes;                ///< counts of boxes by plane, if boxes are coloured by plane
    bool partOfModel = false;          ///< in spherical coordinates: the strategy submitted only a part of the shown object
};

/// The colour of marked pixels that show a nearer surface than the picture beside, and of missed ones within snapping.
[[nodiscard]] QColor addedPixelColour();
[[nodiscard]] QColor snappedPixelColour();

using ViewPicturePointer = std::shared_ptr<const ViewPicture>;

/// A picture being drawn: a frame replayed tile by tile on the thread whose context is current. Throws what core throws.
class PictureDrawing {
public:
    /// `frame`: the whole one. `other`: that of the request's other strategy; null where there is none.
    PictureDrawing(const ViewRequest& request, const ViewFramePointer& frame, ViewFramePointer other);

    /// Draws the part of the picture that `target` covers.
    void draw(Renderer& renderer, Framebuffer& target);
    /// Returns the picture; call it once all tiles are drawn. Marks the pixels within `reach` of a differing pixel.
    [[nodiscard]] std::shared_ptr<ViewPicture> finish(int reach);

    [[nodiscard]] const FrameLog& log() const { return m_picture->frame->log; }
    /// How long the drawing took so far, without what is drawn beside and without reading pictures.
    [[nodiscard]] double milliseconds() const { return m_milliseconds; }
    /// Null if the picture is not coloured by verdict.
    [[nodiscard]] const TriangleStatesPointer& states() const { return m_states; }

private:
    void drawAhead(Renderer& renderer, Framebuffer& target);
    void drawBeside(Renderer& renderer, Framebuffer& target);
    void compareTriangles(std::vector<PixelDifference>& differences, const std::vector<float>& mine,
                          const std::vector<float>& other, Renderer& renderer, const PictureTile& tile) const;

    std::shared_ptr<ViewPicture> m_picture;
    View m_viewing;
    TriangleStatesPointer m_states;
    DrawList m_ahead;                 ///< of ViewPicture::ahead
    std::optional<DrawList> m_truth;  ///< what is drawn beside the picture: all triangles,
    ViewFramePointer m_other;         ///< or another frame
    std::vector<PixelDifference> m_differences;
    double m_milliseconds = 0.0;
};

/// Draws on the thread whose context is current. Throws what core throws.
class ViewPictureDrawer {
public:
    struct Picked {
        uint64_t triangle = 0;  ///< numbered as in the request's scene
        Vec3 point{0.0};
    };

    ViewPictureDrawer(GpuThread& gpu, ViewFramesPointer frames) : m_gpu(gpu), m_frames(std::move(frames)) {}

    /// `stop`: ends it between two objects (Renderer::Stoppable).
    [[nodiscard]] ViewPicturePointer draw(const ViewRequest& request, const std::stop_token& stop = {});
    /// The triangle and point that the request's picture shows at a pixel (y upward); none: background. Where lost pixels are
    /// marked, or the truth stands beside, and where nothing is drawn at all: the triangle that the truth has there and the frame
    /// does not.
    [[nodiscard]] std::optional<Picked> pick(const ViewRequest& request, int x, int y);

    /// The triangles that it shows within a rectangle (y upward), ascending, each once.
    [[nodiscard]] std::vector<uint64_t> trianglesIn(const ViewRequest& request, const PictureTile& within);

    /// Releases what was made in the thread's context, and the frames, whose answers may come from a lost one.
    void letGo();
    [[nodiscard]] const ViewFramesPointer& frames() const { return m_frames; }

private:
    [[nodiscard]] std::shared_ptr<ViewPicture> drawWhole(const ViewRequest& request);
    [[nodiscard]] std::shared_ptr<ViewPicture> drawCoarse(const ViewRequest& request);
    /// What the truth shows and the frame does not at the lost pixel that is nearest to a pixel, at most `reach` rows and columns
    /// away; none: no pixel is lost there.
    [[nodiscard]] std::optional<Picked> missing(const ViewRequest& request, const ViewFrame& frame, int x, int y, int reach);
    /// The one of all pictures: a view's memory may hold questions whose answers only their renderer knows.
    Renderer& renderer() { return m_gpu.renderer(); }
    Framebuffer& target(const Viewport& size);
    /// How long the frame takes to be drawn; none: its picture shows a part of it, or something else.
    [[nodiscard]] std::optional<double> drawingTime(const ViewRequest& request, const ViewFrame& frame,
                                                    const PictureDrawing& drawing);

    GpuThread& m_gpu;
    ViewFramesPointer m_frames;
    std::unique_ptr<Framebuffer> m_framebuffer;
};

}  // namespace cullscope::ui
