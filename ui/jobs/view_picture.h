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

/// All inputs of one view's picture: equal requests make equal pictures.
struct ViewRequest {
    SceneBuffersPointer buffers;
    BuiltStrategyPointer strategy;
    Camera culling;
    Viewport cullingSize;
    Camera viewing;
    Viewport size;
    ViewLook look;
    DrawStyle style;
    TriangleStatesPointer states;  ///< against the truth, if that is known already; else null
    Wipe::Mode wipe = Wipe::Mode::None;
    BuiltStrategyPointer other;  ///< the other strategy in Wipe::Mode::OtherView and Difference

    [[nodiscard]] bool complete() const { return buffers && strategy && strategy->scene == buffers->scenePointer(); }
    bool operator==(const ViewRequest&) const = default;
};

/// A picture with the picture it is compared with. The rows of images start at the top, those of arrays at the bottom.
struct ViewPicture {
    ViewRequest request;
    QImage colour;
    std::vector<float> depth;          ///< reversed depth of `colour`
    QImage other;                      ///< the truth, or the other view's picture; null without a wipe
    QImage marks;                      ///< premultiplied colours of the differing pixels, grown to 5 × 5; null without a wipe
    uint64_t missed = 0, added = 0;    ///< pixels at which `colour` shows a farther or a nearer surface than `other`
    uint64_t consideredTriangles = 0;  ///< triangles submitted to OpenGL
    PlaneCounts planes;                ///< counts of boxes by plane, if boxes are coloured by plane
    bool partOfModel = false;          ///< in spherical coordinates: the strategy submitted only a part of the shown object
};

/// The colour of marked pixels that show a nearer surface than the picture beside.
[[nodiscard]] QColor addedPixelColour();

using ViewPicturePointer = std::shared_ptr<const ViewPicture>;

/// A picture being drawn: culled once, then drawn tile by tile on the thread whose context is current. Throws what core throws.
class PictureDrawing {
public:
    PictureDrawing(const ViewRequest& request, Renderer& renderer);

    /// Draws the part of the picture that `target` covers.
    void draw(Renderer& renderer, Framebuffer& target);
    /// Returns the picture; call it once all tiles are drawn. Marks the pixels within `reach` of a differing pixel.
    [[nodiscard]] std::shared_ptr<ViewPicture> finish(int reach);

    /// The strategy's draw list at the culling camera.
    [[nodiscard]] const DrawList& drawList() const { return m_verdict.drawList; }
    /// Null if the picture is not coloured by verdict.
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
        uint64_t triangle = 0;  ///< numbered as in the request's scene
        Vec3 point{0.0};
    };

    [[nodiscard]] ViewPicturePointer draw(const ViewRequest& request);
    /// The triangle and point that the request's picture shows at a pixel (y upward); none: background.
    [[nodiscard]] std::optional<Picked> pick(const ViewRequest& request, int x, int y);

private:
    Renderer& renderer();
    Framebuffer& target(const Viewport& size);

    std::unique_ptr<Renderer> m_renderer;
    std::unique_ptr<Framebuffer> m_framebuffer;
};

}  // namespace cullscope::ui
