#include "core/image/view_picture.h"

#include <algorithm>
#include <cmath>

#include "core/gpu/colour.h"
#include "core/image/overlays.h"
#include "core/image/spherical_model.h"
#include "core/scene/section.h"
#include "core/visibility/registry.h"

namespace cullscope {
namespace {

using Look = PaletteEntry::Look;
using VerdictPalette = std::array<PaletteEntry, kTriangleStateCount>;

/// Width of the background-coloured border on both sides of a cased line, in units.
constexpr float kCasing = 1.0f;
constexpr float kSectionWidth = 1.5f;  // in units
/// How much of the surface's colour a ghost has; the rest is the background's.
constexpr float kGhostShare = 0.32f;
/// Of back sides: orange, which no verdict has.
constexpr uint32_t kBackOnDark = 0xE08A50, kBackOnLight = 0xC8601E;

/// A palette in which only drawn triangles keep their look.
VerdictPalette drawnOnly(VerdictPalette palette) {
    for (size_t state = 0; state < palette.size(); ++state)
        if (state != size_t(TriangleState::Visible) && state != size_t(TriangleState::InVain)) palette[state].look = Look::Absent;
    return palette;
}

std::span<const uint8_t> bytes(std::span<const TriangleState> states) {
    return {reinterpret_cast<const uint8_t*>(states.data()), states.size()};
}

/// The outline of the plane that cuts a picture, in the scene's box.
OverlayLines sectionOutline(const Scene& scene, const Plane& section, const Vec3f& colour) {
    OverlayLines outline{{}, {kSectionWidth, false}, true};
    const std::vector<Vec3> polygon = planeInBox(section, scene.bounds());
    for (size_t i = 0; i < polygon.size(); ++i) outline.lines.push_back({polygon[i], polygon[(i + 1) % polygon.size()], colour});
    return outline;
}

/// The bounds that the strategy tests, in its own form where it has one.
std::vector<OverlayLines> boxesOf(const OverlayContext& context, const BuiltStrategy& strategy, const FrameLog& log,
                                  const StructureSnapshot& snapshot, bool byPlane) {
    if (strategy.info().first(Show::Kind::Boxes) != nullptr) return strategy.overlay(kBoxesShow, context, log);
    if (byPlane) return boxOverlayByPlane(context, snapshot);
    return {groupOverlay(context, snapshot), boxOverlay(context, snapshot)};
}

/// In the first entries of a frame: an object that was tested and is neither culled nor drawn is not reached yet.
void leaveUndecided(StructureSnapshot& snapshot, const Scene& scene, const FrameLog& log) {
    const std::vector<TriangleState> states = statesOfUnsubmitted(scene, log);
    for (SnapshotNode& node : snapshot.nodes) {
        if (node.isGroup() || scene.meshOf(node.instance).triangleCount() == 0) continue;
        if (states[scene.firstTriangle(node.instance)] == TriangleState::Undecided) node.reached = false;
    }
}

}  // namespace

ViewLook::ViewLook() {
    for (const Show* show : pictureShows())
        if (show->byDefault) m_shown.insert(show->id);
}

ViewLook::ViewLook(std::initializer_list<const char*> ids) : ViewLook() { m_shown.insert(ids.begin(), ids.end()); }

void ViewLook::show(const std::string& id, bool on) {
    if (on)
        m_shown.insert(id);
    else
        m_shown.erase(id);
}

void ViewLook::showWithAll(const Show& show, bool on) {
    this->show(show.id, on);
    for (const Show* needed : pictureShows())
        if (on && show.with() == needed->kind) this->show(needed->id, true);
}

bool ViewLook::has(const Show& show) const { return shows(show.id) && (!show.with() || has(*show.with())); }

bool ViewLook::has(Show::Kind kind) const {
    return std::ranges::any_of(pictureShows(), [&](const Show* show) { return show->kind == kind && has(*show); });
}

std::vector<const Show*> ViewLook::shown() const {
    std::vector<const Show*> result;
    std::ranges::copy_if(pictureShows(), std::back_inserter(result), [&](const Show* show) { return has(*show); });
    return result;
}

bool ViewLook::inPlace() const {
    return std::ranges::any_of(shown(), [](const Show* show) { return show->inPlace(); });
}

ViewLook ViewLook::inPlaceAlone() const {
    ViewLook look;
    for (const Show* show : shown())
        if (show->inPlace()) look.show(show->id, true);
    return look;
}

void ViewLook::watch() {
    for (const Show* show : pictureShows())
        if (show->watching) this->show(show->id, true);
}

void ViewLook::leaveOutOverlays() {
    for (const Show* show : pictureShows())
        if (show->over()) m_shown.erase(show->id);
}

void ViewLook::keepShownOf(const BuiltStrategy& strategy, const FrameLog& log) {
    std::erase_if(m_shown, [&](const std::string& id) { return strategy.whyNotShown(id, {}, log).has_value(); });
}

std::vector<std::string> overlayIds(const ViewLook& look) {
    std::vector<std::string> ids;
    for (const Show* show : namedShows())
        if (look.shows(show->id) && !show->help.empty() && (!look.inPlace() || show->inPlace())) ids.push_back(show->id);
    return ids;
}

std::vector<std::pair<std::string, std::string>> unusualOf(const ViewLook& look) {
    std::vector<std::pair<std::string, std::string>> found;
    // Options of boxes stand before those of verdicts.
    for (auto each = pictureShows().rbegin(); each != pictureShows().rend(); ++each) {
        const Show& show = **each;
        if (show.unusual.key.empty() || look.shows(show.id) == show.byDefault || !show.with() || !look.has(*show.with()))
            continue;
        if (!look.inPlace()) found.emplace_back(show.unusual.key, show.byDefault ? show.unusual.off : show.unusual.on);
    }
    return found;
}

std::set<TriangleState> legendOf(const ViewLook& look) {
    std::set<TriangleState> states;
    for (const Show* show : look.shown()) states.insert(show->legend.begin(), show->legend.end());
    return states;
}

std::vector<ShowMeaning> meaningsOf(const ViewLook& look, const StrategyInfo& strategy) {
    std::vector<ShowMeaning> meanings;
    for (const Show& show : strategy.shows) {
        const bool shown = show.kind == Show::Kind::Boxes ? look.has(Show::Kind::Boxes)
                                                          : show.kind == Show::Kind::Overlay && look.shows(show.id);
        if (shown && !look.inPlace()) meanings.insert(meanings.end(), show.meanings.begin(), show.meanings.end());
    }
    if (look.has(Show::Kind::Backs)) meanings.push_back({CULLSCOPE_TR("back side of a surface"), backColour});
    return meanings;
}

Vec3f ghostColour(const DrawStyle& style) { return glm::mix(style.background, style.surface, kGhostShare); }

Vec3f backColour(const Vec3f& background) { return colourFromHexadecimal(isLight(background) ? kBackOnLight : kBackOnDark); }

bool needsDecisions(const ViewLook& look) {
    return !look.inPlace() && (look.has(Show::Kind::Verdicts) || look.has(Show::Kind::Boxes) || look.has(Show::Kind::Overlay));
}

void drawViewPicture(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, const FrameLog& log,
                     const View& viewing, const TriangleStates* known, const ViewLook& look, const DrawStyle& given,
                     Framebuffer& target) {
    DrawStyle style = given;
    style.wireframe = style.wireframe || look.has(Show::Kind::Wireframe);
    if (look.has(Show::Kind::Backs)) style.back = backColour(style.background);
    if (look.has(Show::Kind::Model))
        return drawSphericalModel(renderer, buffers, viewing, drawnTriangles(buffers.scene(), log), style, target);
    if (look.has(Show::Kind::Verdicts)) {
        VerdictPalette palette = verdictPalette(style.background);
        if (style.wireframe)
            for (PaletteEntry& entry : palette)
                if (entry.look == Look::Filled) entry.look = Look::Wireframe;
        const TriangleStates own = known != nullptr ? TriangleStates{} : triangleStates(buffers.scene(), log, std::nullopt);
        const std::vector<TriangleState>& states = known != nullptr ? known->states : own.states;
        renderer.drawByState(buffers, viewing, Facing::TwoSided, bytes(states),
                             look.has(Show::Kind::Left) ? palette : drawnOnly(palette), target, style);
    } else if (look.has(Show::Kind::Ghost)) {
        // Almost unshaded, so that the ghost is paler than what lies before it everywhere.
        const std::array palette{PaletteEntry{ghostColour(style), style.wireframe ? Look::Wireframe : Look::Filled}};
        const std::vector<uint8_t> all(buffers.scene().triangleCount(), 0);
        renderer.drawByState(buffers, viewing, Facing::TwoSided, all, palette, target, style);
        renderer.drawOver(buffers, viewing, drawnTriangles(buffers.scene(), log), target, style);
    } else {
        renderer.draw(buffers, viewing, log, target, style);
    }
    drawViewOverlays(renderer, buffers.scene(), strategy, log, viewing, look, style, target);
}

void drawOverlay(Renderer& renderer, const View& viewing, const OverlayLines& overlay, const DrawStyle& style,
                 Framebuffer& target) {
    const LineStyle line{overlay.style.width * style.unit, overlay.style.depthTest};
    if (overlay.cased) {
        std::vector<LineSegment> casing = overlay.lines;
        for (LineSegment& each : casing) each.colour = style.background;
        renderer.drawLines(viewing, casing, {line.width + 2.0f * kCasing * style.unit, line.depthTest}, target);
    }
    renderer.drawLines(viewing, overlay.lines, line, target);
}

std::vector<TriangleState> coarseStates(const Scene& scene, const Scene& coarse, const FrameLog& log) {
    // An object that is drawn counts as a whole, so that facing need not be asked of each of its triangles.
    const std::vector<TriangleState> unsubmitted = statesOfUnsubmitted(scene, log);
    std::vector<bool> drawn(scene.instances().size(), false);
    for (const DrawRange& range : drawnTriangles(scene, log).ranges) drawn[range.instance] = true;
    std::vector<TriangleState> byObject(coarse.triangleCount());
    for (size_t i = 0; i < drawn.size(); ++i) {
        if (coarse.firstTriangle(i) == coarse.firstTriangle(i + 1)) continue;
        const TriangleState state = drawn[i] ? TriangleState::Visible : unsubmitted[scene.firstTriangle(i)];
        std::fill(byObject.begin() + std::ptrdiff_t(coarse.firstTriangle(i)),
                  byObject.begin() + std::ptrdiff_t(coarse.firstTriangle(i + 1)), state);
    }
    return byObject;
}

namespace {

/// The boxes of the objects whose look is their triangles' edges, in their colours.
OverlayLines edgeBoxes(const Scene& scene, const Scene& objects, std::span<const TriangleState> states,
                       const VerdictPalette& palette) {
    OverlayLines boxes{{}, {kBoxLineWidth, true}};
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        if (objects.firstTriangle(i) == objects.firstTriangle(i + 1)) continue;
        const PaletteEntry& entry = palette[size_t(states[objects.firstTriangle(i)])];
        if (entry.look == Look::Wireframe) addBox(boxes, scene.instanceBox(i), entry.colour * entry.shade);
    }
    return boxes;
}

/// The drawn objects as ranges of the merged mesh, neighbours in one.
DrawList mergedList(const Scene& scene, const Scene& objects, const FrameLog& log) {
    std::vector<bool> drawn(scene.instances().size(), false);
    for (const DrawRange& range : drawnTriangles(scene, log).ranges) drawn[range.instance] = true;
    DrawList list{Facing::TwoSided, {}};
    for (size_t i = 0; i < drawn.size(); ++i) {
        const auto first = uint32_t(3 * objects.firstTriangle(i)), end = uint32_t(3 * objects.firstTriangle(i + 1));
        if (!drawn[i] || first == end) continue;
        if (!list.ranges.empty() && list.ranges.back().firstIndex + list.ranges.back().indexCount == first)
            list.ranges.back().indexCount = end - list.ranges.back().firstIndex;
        else
            list.ranges.push_back({0, first, end - first});
    }
    return list;
}

}  // namespace

void drawCoarsePicture(Renderer& renderer, const SceneBuffers& buffers, const CoarseBuffers& coarse,
                       const BuiltStrategy& strategy, const FrameLog& log, std::span<const TriangleState> states,
                       const View& viewing, const ViewLook& look, const DrawStyle& style, Framebuffer& target) {
    const Scene& scene = buffers.scene();
    if (look.has(Show::Kind::Verdicts)) {
        VerdictPalette palette = verdictPalette(style.background);
        if (!look.has(Show::Kind::Left)) palette = drawnOnly(palette);
        // Edges take a software OpenGL several times as long as surfaces.
        const OverlayLines boxes = edgeBoxes(scene, *coarse.objects, states, palette);
        for (PaletteEntry& entry : palette)
            if (entry.look == Look::Wireframe) entry.look = Look::Absent;
        renderer.drawByState(*coarse.merged, viewing, Facing::TwoSided, bytes(states), palette, target, style);
        if (!look.has(Show::Kind::Boxes)) drawOverlay(renderer, viewing, boxes, style, target);
    } else {
        renderer.draw(*coarse.merged, viewing, mergedList(scene, *coarse.objects, log), target, style);
    }
    drawViewOverlays(renderer, scene, strategy, log, viewing, look, style, target);
}

void drawViewOverlays(Renderer& renderer, const Scene& scene, const BuiltStrategy& strategy, const FrameLog& log,
                      const View& viewing, const ViewLook& look, const DrawStyle& style, Framebuffer& target) {
    const OverlayContext context{
        scene, viewing, style, verdictPalette(style.background), contrastTo(style.background), planePalette(style.background)};
    const auto drawAll = [&](const std::vector<OverlayLines>& overlays) {
        for (const OverlayLines& overlay : overlays) drawOverlay(renderer, viewing, overlay, style, target);
    };
    // The frustum's planes are coloured where the boxes are; a strategy without boxes has no plane colours.
    bool byPlane = false;
    if (look.has(Show::Kind::Boxes)) {
        StructureSnapshot snapshot = strategy.snapshot(log);
        if (!log.whole) leaveUndecided(snapshot, scene, log);
        byPlane = look.has(Show::Kind::Planes) && !snapshot.nodes.empty();
        drawAll(boxesOf(context, strategy, log, snapshot, byPlane));
    }
    for (const Show& show : strategy.info().shows)
        if (show.kind == Show::Kind::Overlay && look.shows(show.id)) drawAll(strategy.overlay(show.id, context, log));
    // For a view that looks at the plane from elsewhere.
    if (viewing.section() && !(log.camera == viewing.camera()))
        drawAll({sectionOutline(scene, *viewing.section(), context.contrast)});
    // Seen from its own eye, a frustum coincides with the picture's border.
    if (!look.has(Show::Kind::Frustum) || log.camera == viewing.camera()) return;
    const View culling(log.camera, log.size);
    if (byPlane) drawAll({planeOverlay(context, culling)});
    drawAll(frustumOverlay(context, culling));
}

void drawAhead(Renderer& renderer, const SceneBuffers& buffers, const View& viewing, const DrawList& ahead,
               const DrawStyle& style, std::vector<uint8_t>& rgba) {
    Framebuffer target(viewing.viewport());
    DrawStyle clear = style;
    clear.backgroundAlpha = 0.0f;
    renderer.draw(buffers, viewing, ahead, target, clear);
    const std::vector<uint8_t> over = target.readColour();
    for (size_t pixel = 0; pixel < rgba.size(); pixel += 4) {
        if (over[pixel + 3] == 0) continue;
        for (size_t channel = 0; channel < 4; ++channel)
            rgba[pixel + channel] =
                uint8_t(std::lround(kAheadOpacity * over[pixel + channel] + (1.0 - kAheadOpacity) * rgba[pixel + channel]));
    }
}

}  // namespace cullscope
