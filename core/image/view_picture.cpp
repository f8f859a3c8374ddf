#include "core/image/view_picture.h"

#include <algorithm>
#include <iterator>

#include "core/gpu/colour.h"
#include "core/image/overlays.h"
#include "core/image/spherical_model.h"

namespace cullscope {
namespace {

using Look = PaletteEntry::Look;
using VerdictPalette = std::array<PaletteEntry, kTriangleStateCount>;

/// Width of the background-coloured border on both sides of a cased line, in units.
constexpr float kCasing = 1.0f;

constexpr std::array<uint32_t, kTriangleStateCount> kOnLight{0x1FC3E3, 0xDBAC16, 0xC8CCD0, 0x3168F5,
                                                             0x441094, 0x5D3A05, 0xF02172};
constexpr std::array<uint32_t, kTriangleStateCount> kOnDark{0x88EAEE, 0xF4FB19, 0x4A5058, 0x30A3FE, 0x8A2BFF, 0xFAB970, 0xE7120E};

/// The middle of each colour's shading. With 1 for all, some pairs have the same grey (drawn and visible, drawn in vain); with
/// these values any two differ by ΔE₀₀ ≥ 8 in every colour vision that verdict_colour_test.cpp simulates.
constexpr std::array<float, kTriangleStateCount> kShadesOnLight{0.9125f, 0.7625f, 1.0f, 0.775f, 0.7f, 0.975f, 1.0f};
constexpr std::array<float, kTriangleStateCount> kShadesOnDark{0.9125f, 1.1f, 0.85f, 0.875f, 0.8625f, 0.8375f, 1.0f};

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

/// The bounds that the strategy tests. Strategies with maps test spheres, although their objects have boxes.
std::vector<OverlayLines> boxesOf(const OverlayContext& context, const StructureSnapshot& snapshot, BoxColouring colouring) {
    std::vector<OverlayLines> overlays;
    if (snapshot.maps.empty() && colouring == BoxColouring::Plane) return boxOverlayByPlane(context, snapshot);
    overlays.push_back(groupOverlay(context, snapshot));
    if (snapshot.maps.empty())
        overlays.push_back(boxOverlay(context, snapshot));
    else
        std::ranges::move(sphereOverlay(context, snapshot), std::back_inserter(overlays));
    return overlays;
}

}  // namespace

const char* boxColouringId(BoxColouring colouring) { return colouring == BoxColouring::Plane ? "plane" : "verdict"; }

std::vector<const char*> overlayIds(const ViewLook& look) {
    // In its place nothing else is seen.
    if (look.sphericalModel) return {"spherical-model"};
    std::vector<const char*> ids;
    const auto add = [&](bool shown, const char* id) {
        if (shown) ids.push_back(id);
    };
    add(look.colouring == Colouring::Verdicts, "verdicts");
    add(look.boxes, "boxes");
    add(look.frustum, "frustum");
    add(look.bands, "bands");
    add(look.kernel, "kernel");
    return ids;
}

VerdictPalette verdictPalette(const Vec3f& background) {
    const bool light = isLight(background);
    VerdictPalette palette;
    for (size_t state = 0; state < palette.size(); ++state) {
        palette[state].colour = colourFromHexadecimal((light ? kOnLight : kOnDark)[state]);
        palette[state].shade = (light ? kShadesOnLight : kShadesOnDark)[state];
    }
    palette[size_t(TriangleState::OutsideFrustum)].look = Look::Wireframe;
    palette[size_t(TriangleState::WronglyCulled)].look = Look::Marked;
    return palette;
}

bool needsDecisions(const ViewLook& look) {
    return !look.sphericalModel && (look.colouring == Colouring::Verdicts || look.boxes || look.bands || look.kernel);
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
    if (look.boxes || look.bands || look.kernel) {
        const StructureSnapshot snapshot = strategy.snapshot(log);
        if (look.boxes) drawAll(boxesOf(context, snapshot, look.boxColouring));
        byPlane = look.byPlane() && !snapshot.nodes.empty();
        if (look.bands) drawAll(bandOverlay(context, snapshot));
        if (look.kernel) drawAll(kernelOverlay(context, snapshot));
    }
    // Seen from its own eye, a frustum coincides with the picture's border.
    if (!look.frustum || log.camera == viewing.camera()) return;
    const View culling(log.camera, log.size);
    if (byPlane) drawAll({planeOverlay(context, culling)});
    drawAll(frustumOverlay(context, culling));
}

}  // namespace cullscope
