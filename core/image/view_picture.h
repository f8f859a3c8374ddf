#pragma once

#include <initializer_list>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/gpu/renderer.h"
#include "core/visibility/built_strategy.h"
#include "core/visibility/triangle_states.h"
#include "core/visibility/verdict_palette.h"

namespace cullscope {

/// What a view shows besides the drawn triangles: the ids of shows (visibility/show.h).
class ViewLook {
public:
    /// What is shown by default.
    ViewLook();
    /// That, and these.
    ViewLook(std::initializer_list<const char*> ids);

    /// Whether a show is chosen, and the same look with it or without it.
    [[nodiscard]] bool shows(const std::string& id) const { return m_shown.contains(id); }
    void show(const std::string& id, bool on);
    /// Chooses or not, with what it needs: boxes with their colours.
    void showWithAll(const Show& show, bool on);

    /// Whether a show, or something of a kind, is to be seen: it is chosen, with what it needs.
    [[nodiscard]] bool has(const Show& show) const;
    [[nodiscard]] bool has(Show::Kind kind) const;
    /// What is chosen and to be seen, in the order of menus.
    [[nodiscard]] std::vector<const Show*> shown() const;
    /// Whether something stands in place of what a camera sees: then nothing else is seen.
    [[nodiscard]] bool inPlace() const;
    /// That alone.
    [[nodiscard]] ViewLook inPlaceAlone() const;
    /// The look of a view that watches another one from outside, besides what is chosen.
    void watch();
    /// Takes away all lines that lie over the picture.
    void leaveOutOverlays();
    /// Takes away what is not shown of a frame (BuiltStrategy::whyNotShown).
    void keepShownOf(const BuiltStrategy& strategy, const FrameLog& log);

    bool operator==(const ViewLook&) const = default;

private:
    std::set<std::string> m_shown;
};
/// "verdicts", "boxes", … for all that a look shows: as in files and on the command line.
[[nodiscard]] std::vector<std::string> overlayIds(const ViewLook& look);
/// What a look has that is not as by default and has no such id: names and values, as in pictures' texts; the command line has
/// options of these names, with "-" for "_".
[[nodiscard]] std::vector<std::pair<std::string, std::string>> unusualOf(const ViewLook& look);
/// The states of triangles whose colours a look uses.
[[nodiscard]] std::set<TriangleState> legendOf(const ViewLook& look);
/// What lines of other colours mean in a picture by a strategy (Show::meanings).
[[nodiscard]] std::vector<ShowMeaning> meaningsOf(const ViewLook& look, const StrategyInfo& strategy);

/// The colour of what a ghost shows (Show::Kind::Ghost), and of the surfaces' back sides (Show::Kind::Backs).
[[nodiscard]] Vec3f ghostColour(const DrawStyle& style);
[[nodiscard]] Vec3f backColour(const Vec3f& background);

/// Whether drawViewPicture reads decisions for this look; if not, the frame need not be recorded.
[[nodiscard]] bool needsDecisions(const ViewLook& look);

/// Clears `target` and replays a frame of `strategy` as seen by `viewing`; the same in the desktop and in cullbench. `known`
/// holds its triangles' states (null: computed here, without ground truth). With a default look and one camera in both roles the
/// picture is bit-identical to the one that the frame drew. Overlays are never culled: their parts beyond `viewing`'s depth range
/// are drawn too. In spherical coordinates there are no overlays and no depth.
void drawViewPicture(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, const FrameLog& log,
                     const View& viewing, const TriangleStates* known, const ViewLook& look, const DrawStyle& style,
                     Framebuffer& target);

/// Draws the lines of one overlay, cased ones with their border.
void drawOverlay(Renderer& renderer, const View& viewing, const OverlayLines& overlay, const DrawStyle& style,
                 Framebuffer& target);
/// What drawViewPicture draws over the objects.
void drawViewOverlays(Renderer& renderer, const Scene& scene, const BuiltStrategy& strategy, const FrameLog& log,
                      const View& viewing, const ViewLook& look, const DrawStyle& style, Framebuffer& target);

/// A coarse scene for pictures (scene/coarse_scene.h): the objects of the scene that it stands for, and all of their triangles
/// in one mesh, uploaded.
struct CoarseBuffers {
    ScenePointer objects;
    std::shared_ptr<const SceneBuffers> merged;
};
using CoarseBuffersPointer = std::shared_ptr<const CoarseBuffers>;

/// The states of a coarse scene's triangles in a frame of the scene whose objects it has: by object, and
/// without the truth. An object of which anything is drawn is drawn; any other one has the state of its first triangle.
[[nodiscard]] std::vector<TriangleState> coarseStates(const Scene& scene, const Scene& coarse, const FrameLog& log);

/// A picture of a frame by a coarse scene of the same objects: those of which the frame draws anything, in whole, and with the
/// same overlays. Of an object that a whole picture shows by the edges of its triangles there is the box alone. `states`:
/// coarseStates of that frame.
void drawCoarsePicture(Renderer& renderer, const SceneBuffers& buffers, const CoarseBuffers& coarse,
                       const BuiltStrategy& strategy, const FrameLog& log, std::span<const TriangleState> states,
                       const View& viewing, const ViewLook& look, const DrawStyle& style, Framebuffer& target);

/// With this opacity what a step has decided to draw and no command has drawn yet lies over its picture.
inline constexpr double kAheadOpacity = 0.35;
/// Lays those triangles over a picture of the view (RGBA, rows from the bottom), as the desktop does.
void drawAhead(Renderer& renderer, const SceneBuffers& buffers, const View& viewing, const DrawList& ahead,
               const DrawStyle& style, std::vector<uint8_t>& rgba);

}  // namespace cullscope
