#pragma once

#include <QColor>
#include <QImage>
#include <memory>
#include <optional>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/image/plane_colours.h"
#include "core/measure/accuracy.h"
#include "ui/jobs/built_strategy.h"
#include "ui/jobs/gpu_thread.h"
#include "ui/jobs/view_setup.h"

namespace cullscope::ui {

using TriangleStatesPointer = std::shared_ptr<const TriangleStates>;

/// Everything that one view's picture depends on; equal requests make equal pictures.
struct ViewRequest {
    SceneBuffersPointer buffers;
    BuiltStrategyPointer strategy;
    Camera culling;
    Viewport cullingSize;
    Camera viewing;
    Viewport size;
    ViewLook look;
    DrawStyle style;
    TriangleStatesPointer states;  ///< against the truth, where that is known already; else null
    Wipe::Mode wipe = Wipe::Mode::None;
    BuiltStrategyPointer other;  ///< of Wipe::Mode::OtherView and Difference

    [[nodiscard]] bool complete() const { return buffers && strategy && strategy->scene == buffers->scenePointer(); }
    bool operator==(const ViewRequest&) const = default;
};

/// A picture with what is shown beside it. Images hold rows from the top, arrays from the bottom.
struct ViewPicture {
    ViewRequest request;
    QImage colour;
    std::vector<float> depth;          ///< reversed, of `colour`
    QImage other;                      ///< the truth, or the other view's picture; null without a wipe
    QImage marks;                      ///< premultiplied colours of the differing pixels, grown to 5 × 5; null without a wipe
    uint64_t missed = 0, added = 0;    ///< differing pixels: `colour` shows something farther or nearer than `other`
    uint64_t consideredTriangles = 0;  ///< given to OpenGL
    PlaneCounts planes;                ///< where boxes are coloured by plane
    bool partOfModel = false;          ///< in spherical coordinates: not all of the object that is shown was given to OpenGL
};

/// Of marked pixels that show something nearer than what lies beside them.
[[nodiscard]] QColor addedPixelColour();

using ViewPicturePointer = std::shared_ptr<const ViewPicture>;

/// A picture under way: culled once, then drawn tile by tile on the thread whose context is current. Throws what core throws.
class PictureDrawing {
public:
    PictureDrawing(const ViewRequest& request, Renderer& renderer);

    /// Draws the part of the picture that `target` holds.
    void draw(Renderer& renderer, Framebuffer& target);
    /// Once every tile is drawn. `reach` pixels around a differing one are marked.
    [[nodiscard]] std::shared_ptr<ViewPicture> finish(int reach);

    /// What the strategy submitted at the culling camera.
    [[nodiscard]] const DrawList& drawList() const { return m_verdict.drawList; }
    /// Null where nothing is coloured by verdict.
    [[nodiscard]] const TriangleStatesPointer& states() const { return m_states; }

private:
    void drawBeside(Renderer& renderer, Framebuffer& target);

    std::shared_ptr<ViewPicture> m_picture;
    View m_culling, m_viewing;
    Trace m_trace;
    Verdict m_verdict;
    TriangleStatesPointer m_states;
    std::optional<DrawList> m_beside;  ///< of the truth or the other view
    std::vector<PixelDifference> m_differences;
};

/// Draws on the thread whose context is current. Throws what core throws.
class ViewPictureDrawer {
public:
    struct Picked {
        uint64_t triangle = 0;  ///< of the request's scene
        Vec3 point{0.0};
    };

    [[nodiscard]] ViewPicturePointer draw(const ViewRequest& request);
    /// What the request's picture shows at a pixel (y upward).
    [[nodiscard]] std::optional<Picked> pick(const ViewRequest& request, int x, int y);

private:
    Renderer& renderer();
    Framebuffer& target(const Viewport& size);

    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Framebuffer> m_framebuffer;
};

}  // namespace cullscope::ui
