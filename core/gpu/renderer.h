#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>

#include "core/frame/frame_context.h"
#include "core/gpu/framebuffer.h"
#include "core/gpu/scene_buffers.h"
#include "core/scene/camera.h"

namespace cullscope {

/// The look of a picture, independent of its content.
struct DrawStyle {
    Vec3f background{0.078f, 0.090f, 0.110f};
    float backgroundAlpha = 1.0f;
    Vec3f surface{0.80f, 0.80f, 0.78f};
    std::optional<Vec3f> back{};  ///< of the surfaces' back sides; none: as of the front
    bool wireframe = false;       ///< the edges of triangles, without the surfaces between them
    float unit = 1.0f;            ///< pixels for one unit of line width: lines and hatching grow with a large picture

    bool operator==(const DrawStyle&) const = default;
};

/// How the triangles of one palette index are drawn.
struct PaletteEntry {
    enum class Look {
        Filled,
        Wireframe,  ///< unshaded edges without the surface between them
        Marked,     ///< hatched in black and white, with a halo of constant width in pixels, visible even where the triangle
                    ///< covers no pixel
        Absent
    };
    Vec3f colour{0.0f};
    Look look = Look::Filled;
    float shade = 1.0f;  ///< factor of the colour: the middle of the shading's range
};

/// A line in world coordinates; converted to eye-relative coordinates in double before it goes to OpenGL.
struct LineSegment {
    Vec3 from{0.0};
    Vec3 to{0.0};
    Vec3f colour{0.0f};
};

/// The rectangle of the map of directions in a picture: centred, twice as wide as it is high. In pixels, rows from the bottom.
struct MapArea {
    double left = 0.0, bottom = 0.0, width = 2.0, height = 1.0;
};
/// The largest such rectangle within a margin (pixels; smaller in a small picture).
[[nodiscard]] MapArea mapArea(const Viewport& size, double margin);

/// The spherical coordinates in which a mesh is drawn: their origin, range and colours.
struct SphericalModel {
    uint32_t instance = 0;        ///< of the scene
    Sphere sphere;                ///< relative to the mesh's origin: R is the distance from its centre, at most its radius
    std::array<Vec3f, 5> ramp{};  ///< colours of equally spaced R, ascending
    MapArea area;                 ///< in the whole picture
};

struct LineStyle {
    float width = 1.0f;     ///< pixels
    bool depthTest = true;  ///< false: drawn over everything
};

/// The triangle that is visible at a pixel.
struct PickedTriangle {
    uint64_t triangle = 0;  ///< scene triangle number
    double depth = 0.0;     ///< reversed (View::distanceFromDepth)
};

/// Draws draw lists, states and overlays: reversed-Z, eye-relative floats, one Lambert shader with a headlight at the eye. Needs
/// one renderer for each context, with that context current in every call. After every call the state is what Qt expects:
/// OpenGL's defaults (glClipControl, depth and culling included), no bindings, and the framebuffer that was bound before.
class Renderer {
public:
    /// `indirect`: whether what the GPU chooses is drawn indirectly, without waiting for the choice; else it is read back at
    /// once, and drawn as a list. None: as suits this OpenGL. A software OpenGL goes through the commands of all candidates one
    /// by one.
    explicit Renderer(std::optional<bool> indirect = {});
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// While it lives, a renderer looks for a stop request before each object that it draws, in pictures and item buffers: then
    /// it throws Error(Interrupted). What was drawn so far stays in the target. OpenGL's state is as after every call.
    class Stoppable {
    public:
        Stoppable(Renderer& renderer, std::stop_token stop);
        ~Stoppable();
        Stoppable(const Stoppable&) = delete;
        Stoppable& operator=(const Stoppable&) = delete;

    private:
        Renderer& m_renderer;
        std::stop_token m_before;  ///< of the one within which it lives
    };

    /// Clears `target` and draws the list as seen by `view`, whose viewport must be the target's size or contain its tile.
    void draw(const SceneBuffers& buffers, const View& view, const DrawList& list, Framebuffer& target,
              const DrawStyle& style = {});
    /// Draws the list over the picture that is in `target`, before all of it: as the first thing that has a depth.
    void drawOver(const SceneBuffers& buffers, const View& view, const DrawList& list, Framebuffer& target,
                  const DrawStyle& style = {});
    /// Replays a frame: clears `target` and executes the log's commands as seen by `view`. Where that is the culling view, the
    /// picture is the frame's own. From any other place a finished picture is seen as the triangles that it shows.
    void draw(const SceneBuffers& buffers, const View& view, const FrameLog& log, Framebuffer& target,
              const DrawStyle& style = {});
    /// The first step of `draw`, and one command: drawn into `target` over what is there, or (`cleared`) into the cleared target.
    /// A software OpenGL draws what follows a clear at once much faster than what comes after the framebuffer was changed.
    void clear(const View& view, Framebuffer& target, const DrawStyle& style);
    void execute(const SceneBuffers& buffers, const View& view, const Command& command, Framebuffer& target,
                 const DrawStyle& style, bool cleared = false);

    /// Ground truth: for every pixel the depth and the lowest triangle number (Scene numbering + 1; 0 = nothing) at that depth;
    /// where there is no number there is no depth.
    /// Draws `list` in a depth pass with the same vertex program as `draw`, then with GL_EQUAL and an atomic minimum.
    /// Throws Error(Usage) for a scene of more than 2^32 − 2 triangles.
    struct ItemBuffer {
        std::vector<float> depth;
        std::vector<uint32_t> triangle;
    };
    [[nodiscard]] ItemBuffer drawItemBuffer(const SceneBuffers& buffers, const View& view, const DrawList& list) {
        return drawItemBuffer(buffers, view, list, {0, 0, view.viewport()});
    }
    /// The same for a tile of the picture.
    [[nodiscard]] ItemBuffer drawItemBuffer(const SceneBuffers& buffers, const View& view, const DrawList& list,
                                            const PictureTile& tile);
    /// What a frame shows at every pixel, by a replay of its log. Where all of it is drawn from the scene with a depth test: as
    /// above. Else in the frame's order, what was shown last.
    [[nodiscard]] ItemBuffer drawItemBuffer(const SceneBuffers& buffers, const View& view, const FrameLog& log,
                                            const PictureTile& tile);

    /// The triangle of `list` that is visible at a pixel (y upward), the same as drawItemBuffer gives there; none where nothing
    /// is drawn or the pixel lies outside the viewport. Draws one pixel only. Throws as drawItemBuffer does.
    [[nodiscard]] std::optional<PickedTriangle> pick(const SceneBuffers& buffers, const View& view, const DrawList& list, int x,
                                                     int y);
    [[nodiscard]] std::optional<PickedTriangle> pick(const SceneBuffers& buffers, const View& view, const FrameLog& log, int x,
                                                     int y);

    /// The boxes that OpenGL's selection mode hits, with the whole picture as the pick region (Cho et al., chapter 3.2).
    using SelectedBoxes = cullscope::SelectedBoxes;
    /// Draws the faces of boxes relative to the eye, both sides, in GL_SELECT with a hit buffer of `bufferWords` (at least 1),
    /// and again with twice as many as long as it overflows (glRenderMode returns −1). A box that contains the whole frustum is
    /// not hit. Throws Error(OpenGl) without a compatibility profile.
    [[nodiscard]] SelectedBoxes selectBoxes(const View& view, std::span<const EyeBox> boxes, size_t bufferWords);

    /// The boxes, relative to the eye, that cover a sample of the picture, as indices into the span, ascending: one occlusion
    /// query for each (GL_ANY_SAMPLES_PASSED_CONSERVATIVE), without depth test, both sides, depth clamped instead of clipped.
    /// Waits for the results. A box that contains the whole frustum covers no sample, nor does one behind the eye; one beyond the
    /// near or far plane does. With `ends` one query for each group of consecutive boxes, of which group g ends before box
    /// ends[g], and the numbers of the groups of which a box covers a sample.
    [[nodiscard]] std::vector<uint32_t> queryBoxes(const View& view, std::span<const EyeBox> boxes,
                                                   std::span<const uint32_t> ends = {});
    /// The boxes that cover a sample at which they lie before, or at, what was drawn into `drawn`, whose depth does not change.
    [[nodiscard]] std::vector<uint32_t> queryBoxes(const View& view, std::span<const EyeBox> boxes, const Framebuffer& drawn,
                                                   std::span<const uint32_t> ends = {});
    /// Both without waiting for the results.
    [[nodiscard]] BoxTicketPointer askBoxes(const View& view, std::span<const EyeBox> boxes, std::span<const uint32_t> ends = {});
    [[nodiscard]] BoxTicketPointer askBoxes(const View& view, std::span<const EyeBox> boxes, const Framebuffer& drawn,
                                            std::span<const uint32_t> ends = {});
    /// The boxes, or groups, that lie before what was drawn into `drawn`, by the depth pyramid of that (BoxQuestion::Pyramid),
    /// without waiting. Hides no box that covers a sample at which it lies before, or at, what was drawn, if the box has grown
    /// for the rounding of a picture (visibility/eye_bounds.h): it is projected in float. One that reaches before the near plane
    /// is visible. `reduction`: the number of that which `drawn` still looks like (reductions() after an earlier question), 0
    /// for none: where it is the newest, the depth is not reduced again.
    [[nodiscard]] BoxTicketPointer askPyramid(const View& view, std::span<const EyeBox> boxes, const Framebuffer& drawn,
                                              std::span<const uint32_t> ends = {}, uint64_t reduction = 0);
    /// How often a depth pyramid was made.
    [[nodiscard]] uint64_t reductions() const { return m_reductions; }
    /// What its boxes were compared with; waits. Empty for other tickets, and those of another renderer.
    [[nodiscard]] std::vector<PyramidReading> readings(BoxTicket& ticket) const;
    /// Those results, the same at every call; waits at the first one where they are not there yet. None for a ticket of another
    /// renderer.
    [[nodiscard]] std::optional<std::vector<uint32_t>> answer(BoxTicket& ticket);

    /// Clears `target` and draws every triangle of the scene as seen by `view`, coloured by palette[stateOfTriangle[number]],
    /// almost unshaded (Lambert ± 10 %). Halo and hatch of marked triangles contrast with the style's background. Throws
    /// Error(OpenGl) where this OpenGL's largest buffer has less than a byte for each triangle.
    void drawByState(const SceneBuffers& buffers, const View& view, Facing facing, std::span<const uint8_t> stateOfTriangle,
                     std::span<const PaletteEntry> palette, Framebuffer& target, const DrawStyle& style = {});

    /// Clears `target` and draws the draw list's triangles of one instance in spherical coordinates (Han & Hong 2008, Figure 2):
    /// azimuth φ to the right (0 … 360°), zenith angle θ downward (0 … 180°); of several surfaces in one direction the one with
    /// the largest R. Both sides of every triangle, with a headlight along the radius. Of `view` only the viewport is used.
    /// Writes no depth.
    void drawSpherical(const SceneBuffers& buffers, const View& view, const DrawList& list, const SphericalModel& model,
                       Framebuffer& target, const DrawStyle& style = {});

    /// Draws lines over a finished picture, without clearing or writing depth; also those beyond the view's depth range.
    void drawLines(const View& view, std::span<const LineSegment> lines, const LineStyle& style, Framebuffer& target);

    /// Candidates for whose drawing the GPU has decided, in draw commands of its own memory.
    class Choice {
    public:
        Choice(const SceneBuffers& buffers, DrawList candidates, unsigned commands)
            : m_buffers(&buffers), m_candidates(std::move(candidates)), m_commands(commands) {}
        ~Choice();
        Choice(Choice&& other) noexcept;
        Choice(const Choice&) = delete;
        Choice& operator=(const Choice&) = delete;

        /// Those that were chosen. Waits for the GPU.
        [[nodiscard]] DrawList chosen() const;

    private:
        friend class Renderer;
        const SceneBuffers* m_buffers;
        DrawList m_candidates;
        unsigned m_commands;
    };
    /// Has a compute shader choose among candidates. Throws Error(OpenGl) with the driver's log where the body is refused.
    [[nodiscard]] Choice choose(const SceneBuffers& buffers, const GpuChoice& choice);
    /// Chooses the candidates that a question by a pyramid finds visible, range i by answer i, without waiting for it; none for
    /// a ticket of another kind, or of another renderer.
    /// There are as many answers as ranges.
    [[nodiscard]] std::optional<Choice> choose(const SceneBuffers& buffers, BoxTicket& ticket, const DrawList& candidates);
    /// Whether choices are drawn indirectly.
    [[nodiscard]] bool drawsIndirectly() const;
    /// Draws what was chosen over what is in `target`. Needs buffer objects (Upload::Vbo).
    void execute(const View& view, const Choice& choice, Framebuffer& target, const DrawStyle& style, bool cleared = false);

private:
    struct Programs;
    std::unique_ptr<Programs> m_programs;
    uint64_t m_reductions = 0;
};

/// A draw list of every triangle of a scene, instance by instance.
[[nodiscard]] DrawList everything(const Scene& scene, Facing facing);

/// Whether a frame's commands make its picture from there: a finished picture can be seen from its own place only.
[[nodiscard]] bool replaysFrom(const View& view, const FrameLog& log);

/// Waits until the GPU has finished all submitted work.
void waitForGpu();

}  // namespace cullscope
