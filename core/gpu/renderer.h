#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>

#include "core/gpu/framebuffer.h"
#include "core/gpu/scene_buffers.h"
#include "core/scene/camera.h"
#include "core/frame/draw_list.h"

namespace cullscope {

/// How a picture looks; never what is in it.
struct DrawStyle {
    Vec3f background{0.078f, 0.090f, 0.110f};
    float backgroundAlpha = 1.0f;
    Vec3f surface{0.80f, 0.80f, 0.78f};
    float unit = 1.0f;  ///< pixels of what is one pixel wide on a screen: lines and hatching grow with a large picture

    bool operator==(const DrawStyle&) const = default;
};

/// How the triangles of one palette index are drawn.
struct PaletteEntry {
    enum class Look {
        Filled,
        Wireframe,  ///< edges without light, and nothing between them
        Marked,     ///< hatched in black and white, with a halo of constant width in pixels that shows even what covers no pixel
        Absent
    };
    Vec3f colour{0.0f};
    Look look = Look::Filled;
    float shade = 1.0f;  ///< times the colour: the middle of the shading's range
};

/// A line in world coordinates; made relative to the eye in double before it goes to OpenGL.
struct LineSegment {
    Vec3 from{0.0};
    Vec3 to{0.0};
    Vec3f colour{0.0f};
};

/// The map of directions in a picture: twice as wide as it is high, in the middle. Pixels, rows from the bottom.
struct MapArea {
    double left = 0.0, bottom = 0.0, width = 2.0, height = 1.0;
};
/// The largest with a margin (pixels; less in a small picture) around it.
[[nodiscard]] MapArea mapArea(const Viewport& size, double margin);

/// Where the spherical coordinates of a mesh have their origin, and how they are shown.
struct SphericalModel {
    uint32_t instance = 0;        ///< of the scene
    Sphere sphere;                ///< relative to the mesh's origin: R is counted from its centre, up to its radius
    std::array<Vec3f, 5> ramp{};  ///< colours by growing R, at equal distances
    MapArea area;                 ///< in the whole picture
};

struct LineStyle {
    float width = 1.0f;     ///< pixels
    bool depthTest = true;  ///< false: on top of everything
};

/// What is seen at a pixel.
struct PickedTriangle {
    uint64_t triangle = 0;  ///< scene triangle number
    double depth = 0.0;     ///< reversed (View::distanceFromDepth)
};

/// Draws draw lists, states and overlays: reversed-Z, eye-relative floats, one Lambert shader with a headlight at the eye.
/// One renderer a context; needs that context current in every call. After every call the state is what Qt expects:
/// OpenGL's defaults (glClipControl, depth and culling too), nothing bound, and the framebuffer that was bound before.
class Renderer {
public:
    Renderer();
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Clears `target` and draws the list as seen by `view` (whose viewport must be the target's size, or hold its tile).
    void draw(const SceneBuffers& buffers, const View& view, const DrawList& list, Framebuffer& target,
              const DrawStyle& style = {});

    /// Ground truth: for every pixel the depth and the lowest triangle number (Scene numbering + 1; 0 = nothing) at that depth.
    /// Draws `list` in a depth pass with the same vertex program as `draw`, then with GL_EQUAL and an atomic minimum.
    /// Throws Error(Usage) for a scene of more than 2^32 − 2 triangles.
    struct ItemBuffer {
        std::vector<float> depth;
        std::vector<uint32_t> triangle;
    };
    [[nodiscard]] ItemBuffer drawItemBuffer(const SceneBuffers& buffers, const View& view, const DrawList& list) {
        return drawItemBuffer(buffers, view, list, {0, 0, view.viewport()});
    }
    /// The same for a part of the picture.
    [[nodiscard]] ItemBuffer drawItemBuffer(const SceneBuffers& buffers, const View& view, const DrawList& list,
                                            const PictureTile& tile);

    /// What `list` shows at a pixel (y upward), as drawItemBuffer would say there; nothing where nothing is drawn or the pixel
    /// lies outside the viewport. Touches one pixel only. Throws as drawItemBuffer does.
    [[nodiscard]] std::optional<PickedTriangle> pick(const SceneBuffers& buffers, const View& view, const DrawList& list, int x,
                                                     int y);

    /// Which boxes OpenGL's selection mode hits with all of the picture as the pick region (Cho et al., chapter 3.2).
    struct SelectedBoxes {
        std::vector<uint32_t> hits;  ///< places in the span, which were the boxes' names, ascending
        size_t bufferWords = 0;      ///< of the hit buffer that held all records; four words a hit
        int overflows = 0;           ///< how often a smaller one did not
    };
    /// Draws the faces of boxes relative to the eye, both sides, in GL_SELECT with a hit buffer of `bufferWords` (at least 1),
    /// and again with twice as many where they did not do (glRenderMode gives −1). A box that holds the whole frustum is not
    /// hit. Throws Error(OpenGl) where there is no compatibility profile.
    [[nodiscard]] SelectedBoxes selectBoxes(const View& view, std::span<const EyeBox> boxes, size_t bufferWords);

    /// Which boxes relative to the eye cover a sample of the picture: an occlusion query each
    /// (GL_ANY_SAMPLES_PASSED_CONSERVATIVE), without depth test, both sides, depth clamped in place of clipped. Waits for the
    /// answers. A box that holds the whole frustum covers none, nor does what lies behind the eye; what lies beyond near or far
    /// does. Places in the span, ascending.
    [[nodiscard]] std::vector<uint32_t> queryBoxes(const View& view, std::span<const EyeBox> boxes);

    /// Clears `target` and draws every triangle of the scene as `view` sees it, coloured by palette[stateOfTriangle[number]],
    /// nearly flat (Lambert ± 10 %). Halo and hatch of marked triangles are made for the style's background. Throws
    /// Error(OpenGl) where this OpenGL cannot hold a byte a triangle in one buffer.
    void drawByState(const SceneBuffers& buffers, const View& view, Facing facing, std::span<const uint8_t> stateOfTriangle,
                     std::span<const PaletteEntry> palette, Framebuffer& target, const DrawStyle& style = {});

    /// Clears `target` and draws what a list has of one instance in spherical coordinates (Han & Hong 2008, Figure 2): the
    /// azimuth φ to the right (0 … 360°), the zenith angle θ downward (0 … 180°), and of what lies in one direction the largest
    /// R. Both sides of every triangle, with a headlight along the radius. Of `view` only the viewport counts. Leaves no depth.
    void drawSpherical(const SceneBuffers& buffers, const View& view, const DrawList& list, const SphericalModel& model,
                       Framebuffer& target, const DrawStyle& style = {});

    /// Draws lines over a finished picture, without clearing and without writing depth; also beyond the view's depth range.
    void drawLines(const View& view, std::span<const LineSegment> lines, const LineStyle& style, Framebuffer& target);

private:
    struct Programs;
    std::unique_ptr<Programs> m_programs;
};

/// Every triangle of a scene, instance by instance.
[[nodiscard]] DrawList everything(const Scene& scene, Facing facing);

/// Waits until the GPU has finished what was asked of it.
void waitForGpu();

}  // namespace cullscope
