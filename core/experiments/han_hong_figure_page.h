#pragma once

#include <functional>

#include "core/experiments/han_hong_figures.h"
#include "core/frame/cell_map.h"
#include "core/gpu/renderer.h"
#include "core/image/view_picture.h"
#include "core/visibility/overlay.h"
#include "core/visibility/spherical/decision.h"

namespace cullscope::han_hong {

/// What all figures are made of: a page that grows downward, pictures of recorded frames, maps and legends, and the cameras.
class FigurePage {
public:
    FigurePage(const FigureRequest& request, const PageLook& look, const Progress& progress);

    // Lengths are in units of the page, and so are the viewports of views: what draws a picture takes `sharp` of them.
    static constexpr double kMargin = 12.0;

protected:
    using Overlays = std::function<std::vector<OverlayLines>(const OverlayContext& context)>;

    [[nodiscard]] const Scene& scene() const { return *m_request.scene; }
    [[nodiscard]] const BuiltStrategy& strategy() const { return *m_strategy; }
    [[nodiscard]] double inner() const { return m_request.width - 2 * kMargin; }
    [[nodiscard]] Viewport pictureSize() const { return {int(inner()), int(inner()) * 5 / 8}; }
    [[nodiscard]] std::string say(const char* text) const { return m_look.say({text}); }
    [[nodiscard]] PlotColour stateColour(TriangleState state) const;
    [[nodiscard]] PageLegendEntry stateEntry(TriangleState state) const;

    /// A view of a picture on the page, with as many pixels as the page's scale gives it.
    [[nodiscard]] View sharp(const View& viewing) const;
    /// A frame of the strategy, whose rays, regions and bands go into the figure's data. `view`: its number there.
    [[nodiscard]] FrameLog frameOf(const View& culling, size_t view);
    /// A frame of the strategy of which the data say nothing.
    [[nodiscard]] FrameLog decidedOn(const View& culling);
    /// A frame in which all triangles are drawn.
    [[nodiscard]] FrameLog frameOfAll(const View& culling);
    /// A view of the path of a case, 320 × 240 as in section 3.
    [[nodiscard]] View viewOfCase(int number) const;
    /// All of the object in view, 640 × 480 as in section 3.
    [[nodiscard]] View wholeView() const;
    /// A camera beside a culling view, turned about the scene's middle by degrees to the side and up; `distance` in radii,
    /// `towardsEye`: how far its target lies from the middle towards the culling eye, as a share of that distance.
    [[nodiscard]] Camera beside(const View& culling, double turn, double rise, double distance, double towardsEye = 0.0) const;
    /// The same camera, turned and with the lens or, of a parallel one, moved and of the height with which these places fill a
    /// picture; they must lie before its eye.
    [[nodiscard]] View fitted(Camera camera, const std::vector<Vec3>& places, const Viewport& size) const;
    /// The outermost places of the scene's bounding sphere that a camera sees: to the left, to the right, above and below.
    [[nodiscard]] std::vector<Vec3> wholeSphere(const Camera& camera) const;
    /// Throws Error(Usage) where no object of the frame has contour bands.
    void requireBands(const FrameLog& log) const;

    /// A picture of a frame, with further lines.
    [[nodiscard]] std::vector<uint8_t> drawn(const FrameLog& log, const View& viewing, const ViewLook& look,
                                             const Overlays& more = {});
    /// Tints the pixels of a picture from the frame's own eye that show less than the truth; returns which share of those
    /// covered.
    double markLost(const FrameLog& log, const View& viewing, std::vector<uint8_t>& rgba);
    /// The map of the object that the figure shows; the frame must have decided about one.
    [[nodiscard]] spherical::MapSnapshot shownMap(const FrameLog& log) const;
    /// Adds a line of words, such as the case, and goes on below it.
    void addWords(const Words& words);
    void addPicture(const Viewport& size, std::vector<uint8_t> rgba, double left = kMargin);
    /// Words around a place in the newest picture; `aside`: from there. `colour`: of the words; none: the style's.
    void addLabel(const View& viewing, const Vec3& place, const Vec2& aside, const std::string& words,
                  std::optional<PlotColour> colour = {});
    /// Words on a pale ground that begin at a point of the page and are centred along y, as far as they stay in the newest
    /// picture.
    void addPlate(const PlotPoint& from, const std::string& words, std::optional<PlotColour> colour = {});
    [[nodiscard]] Figure finish();
    void addLegendBelow(const std::vector<PageLegendEntry>& entries, double pictureHeight);
    /// `truth`: states of the triangles, by which the cells are coloured in place of what was decided about them.
    void addMap(const FrameLog& log, const char* colouring, const TriangleStates* truth = nullptr);
    [[nodiscard]] TriangleStates statesAgainstTruth(const FrameLog& log);

    const FigureRequest& m_request;
    const PageLook& m_look;
    Renderer m_renderer;
    SceneBuffers m_buffers;
    DrawStyle m_style;
    Page m_page;
    double m_bottom = kMargin;  ///< where the page ends so far
    ResultTable m_data;

private:
    [[noreturn]] void refuse() const;

    StructureStore m_structures;
    BuiltStrategyPointer m_strategy;
};

}  // namespace cullscope::han_hong
