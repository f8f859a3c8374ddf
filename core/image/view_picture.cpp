#include "core/image/view_picture.h"

#include "core/gpu/colour.h"
#include "core/image/overlays.h"
#include "core/image/spherical_model.h"
#include "core/visibility/registry.h"

namespace cullscope {
namespace {

using Look = PaletteEntry::Look;
using VerdictPalette = std::array<PaletteEntry, kTriangleStateCount>;

/// Width of the background-coloured border on both sides of a cased line, in units.
constexpr float kCasing = 1.0f;

/// A palette in which only drawn triangles keep their look.
VerdictPalette drawnOnly(VerdictPalette palette) {
    for (size_t state = 0; state < palette.size(); ++state)
        if (state != size_t(TriangleState::Visible) && state != size_t(TriangleState::InVain)) palette[state].look = Look::Absent;
    return palette;
}

std::span<const uint8_t> bytes(const std::vector<TriangleState>& states) {
    return {reinterpret_cast<const uint8_t*>(states.data()), states.size()};
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

/// The bounds that the strategy tests, in its own form where it has one.
std::vector<OverlayLines> boxesOf(const OverlayContext& context, const BuiltStrategy& strategy, const FrameLog& log,
                                  const StructureSnapshot& snapshot, BoxColouring colouring) {
    if (strategy.info().show(kBoxesOverlay) != nullptr) return strategy.overlay(kBoxesOverlay, context, log);
    if (colouring == BoxColouring::Plane) return boxOverlayByPlane(context, snapshot);
    return {groupOverlay(context, snapshot), boxOverlay(context, snapshot)};
}

}  // namespace

const char* boxColouringId(BoxColouring colouring) { return colouring == BoxColouring::Plane ? "plane" : "verdict"; }

std::vector<std::string> overlayIds(const ViewLook& look) {
    // In its place nothing else is seen.
    if (look.sphericalModel) return {kSphericalModelOverlay};
    std::vector<std::string> ids;
    const auto add = [&](bool shown, const std::string& id) {
        if (shown) ids.push_back(id);
    };
    add(look.colouring == Colouring::Verdicts, kVerdictsOverlay);
    add(look.boxes, kBoxesOverlay);
    add(look.frustum, kFrustumOverlay);
    for (const Show* show : declaredShows(Show::Kind::Overlay)) add(look.shows(show->id), show->id);
    return ids;
}

bool needsDecisions(const ViewLook& look) {
    return !look.sphericalModel && (look.colouring == Colouring::Verdicts || look.boxes || !look.overlays.empty());
}

void drawViewPicture(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, const FrameLog& log,
                     const View& viewing, const TriangleStates* known, const ViewLook& look, const DrawStyle& style,
                     Framebuffer& target) {
    if (look.sphericalModel)
        return drawSphericalModel(renderer, buffers, viewing, drawnTriangles(buffers.scene(), log), style, target);
    const VerdictPalette palette = verdictPalette(style.background);
    if (look.colouring == Colouring::Verdicts) {
        const TriangleStates own = known != nullptr ? TriangleStates{} : triangleStates(buffers.scene(), log, std::nullopt);
        const std::vector<TriangleState>& states = known != nullptr ? known->states : own.states;
        renderer.drawByState(buffers, viewing, Facing::TwoSided, bytes(states), look.culledToo ? palette : drawnOnly(palette),
                             target, style);
    } else {
        renderer.draw(buffers, viewing, log, target, style);
    }
    const OverlayContext context{
        buffers.scene(), viewing, style, palette, contrastTo(style.background), planePalette(style.background)};
    const auto drawAll = [&](const std::vector<OverlayLines>& overlays) {
        for (const OverlayLines& overlay : overlays) drawOverlay(renderer, viewing, overlay, style, target);
    };
    // The frustum's planes are coloured where the boxes are; a strategy without boxes has no plane colours.
    bool byPlane = false;
    if (look.boxes) {
        const StructureSnapshot snapshot = strategy.snapshot(log);
        drawAll(boxesOf(context, strategy, log, snapshot, look.boxColouring));
        byPlane = look.byPlane() && !snapshot.nodes.empty();
    }
    for (const Show& show : strategy.info().shows)
        if (show.kind == Show::Kind::Overlay && look.shows(show.id)) drawAll(strategy.overlay(show.id, context, log));
    // Seen from its own eye, a frustum coincides with the picture's border.
    if (!look.frustum || log.camera == viewing.camera()) return;
    const View culling(log.camera, log.size);
    if (byPlane) drawAll({planeOverlay(context, culling)});
    drawAll(frustumOverlay(context, culling));
}

}  // namespace cullscope
