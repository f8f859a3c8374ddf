#include "core/measure/view_picture.h"

#include <numbers>

#include "core/gpu/colour.h"

namespace cullscope {
namespace {

using Look = PaletteEntry::Look;
using VerdictPalette = std::array<PaletteEntry, kTriangleStateCount>;

// Widths and radii are in units (DrawStyle::unit).
constexpr float kFrustumWidth = 1.5f;
constexpr float kBoxWidth = 1.0f;
constexpr float kEyeWidth = 2.0f;
constexpr float kCasing =
    1.0f;  ///< of the background's colour on both sides of frustum and eye, so that they are seen on surfaces
constexpr double kEyeRadius = 6.0;

constexpr std::array<uint32_t, kTriangleStateCount> kOnLight{0x1FC3E3, 0xDBAC16, 0xC8CCD0, 0x3168F5,
                                                             0x441094, 0x5D3A05, 0xF02172};
constexpr std::array<uint32_t, kTriangleStateCount> kOnDark{0x88EAEE, 0xF4FB19, 0x4A5058, 0x30A3FE, 0x8A2BFF, 0xFAB970, 0xE7120E};

/// The middle of each colour's shading. At 1 throughout, some pairs have the same grey (drawn and visible, drawn in vain); with
/// these any two differ by ΔE₀₀ ≥ 8 in every sight that verdict_colour_test.cpp simulates.
constexpr std::array<float, kTriangleStateCount> kShadesOnLight{0.9125f, 0.7625f, 1.0f, 0.775f, 0.7f, 0.975f, 1.0f};
constexpr std::array<float, kTriangleStateCount> kShadesOnDark{0.9125f, 1.1f, 0.85f, 0.875f, 0.8625f, 0.8375f, 1.0f};

Vec3f colourOf(uint32_t hexadecimal) {
    return Vec3f(float(hexadecimal >> 16), float(hexadecimal >> 8 & 255), float(hexadecimal & 255)) / 255.0f;
}

/// Only what reached the picture keeps its look.
VerdictPalette drawnOnly(VerdictPalette palette) {
    for (size_t state = 0; state < palette.size(); ++state)
        if (state != size_t(TriangleState::Visible) && state != size_t(TriangleState::InVain)) palette[state].look = Look::Absent;
    return palette;
}

std::span<const uint8_t> bytes(const std::vector<TriangleState>& states) {
    return {reinterpret_cast<const uint8_t*>(states.data()), states.size()};
}

/// The forward distance at which the frustum's lines end: the far plane or the scene's farthest corner, whichever is nearer; a
/// tenth of the scene's size at least, where it lies behind.
double cutDistance(const Frustum& frustum, const Vec3& eye, const Box3& bounds) {
    double farthest = 0.1 * bounds.diagonal();
    for (int corner = 0; corner < 8 && !bounds.empty(); ++corner) {
        const Vec3 point((corner & 1) != 0 ? bounds.max.x : bounds.min.x, (corner & 2) != 0 ? bounds.max.y : bounds.min.y,
                         (corner & 4) != 0 ? bounds.max.z : bounds.min.z);
        farthest = std::max(farthest, glm::dot(point - eye, frustum.forward));
    }
    return std::clamp(farthest, frustum.nearDistance, frustum.farDistance);
}

std::vector<LineSegment> frustumLines(const View& culling, const Scene& scene, const Vec3f& colour) {
    Frustum frustum = culling.frustum();
    frustum.farDistance = cutDistance(frustum, culling.eye(), scene.bounds());
    const std::array<Vec3, 8> corners = frustum.corners();
    std::vector<LineSegment> lines;
    const auto add = [&](size_t a, size_t b) {
        lines.push_back({culling.eye() + corners[a], culling.eye() + corners[b], colour});
    };
    for (size_t i = 0; i < 4; ++i) {
        add(i, (i + 1) % 4);
        add(i, i + 4);
        add(i + 4, (i + 1) % 4 + 4);
    }
    return lines;
}

/// A ring of constant size in the picture around the culling camera's eye, with a dot in it; nothing where it lies behind.
std::vector<LineSegment> eyeMark(const View& culling, const View& viewing, const Vec3f& colour, double unit) {
    const Frustum& frustum = viewing.frustum();
    const double distance = glm::dot(culling.eye() - viewing.eye(), frustum.forward);
    if (!(distance > 0.0)) return {};
    const double radius = kEyeRadius * unit * 2.0 * frustum.tanHalfHeight * distance / viewing.viewport().height;
    constexpr int kSides = 12;
    const auto onRing = [&](int i) {
        const double angle = 2.0 * std::numbers::pi * i / kSides;
        return culling.eye() + (frustum.right * std::cos(angle) + frustum.up * std::sin(angle)) * radius;
    };
    std::vector<LineSegment> lines{{culling.eye(), culling.eye(), colour}};
    for (int i = 0; i < kSides; ++i) lines.push_back({onRing(i), onRing(i + 1), colour});
    return lines;
}

std::vector<LineSegment> boxLines(const Inside& inside, const VerdictPalette& palette) {
    std::vector<LineSegment> lines;
    lines.reserve(inside.nodes.size() * 12);
    for (const InsideNode& node : inside.nodes) {
        const TriangleState state = node.culled ? stateOfCause(node.cause) : TriangleState::Visible;
        const Vec3f colour = palette[size_t(state)].colour;
        const auto corner = [&](int c) {
            return Vec3((c & 1) != 0 ? node.box.max.x : node.box.min.x, (c & 2) != 0 ? node.box.max.y : node.box.min.y,
                        (c & 4) != 0 ? node.box.max.z : node.box.min.z);
        };
        for (int from = 0; from < 8; ++from)
            for (const int axis : {1, 2, 4})
                if ((from & axis) == 0) lines.push_back({corner(from), corner(from | axis), colour});
    }
    return lines;
}

/// Lines with a casing of the background's colour under them.
void drawCased(Renderer& renderer, const View& viewing, std::vector<LineSegment> lines, LineStyle line, const DrawStyle& style,
               Framebuffer& target) {
    std::vector<LineSegment> casing = lines;
    for (LineSegment& each : casing) each.colour = style.background;
    line.width *= style.unit;
    renderer.drawLines(viewing, casing, {line.width + 2.0f * kCasing * style.unit, line.depthTest}, target);
    renderer.drawLines(viewing, lines, line, target);
}

}  // namespace

VerdictPalette verdictPalette(const Vec3f& background) {
    const bool light = isLight(background);
    VerdictPalette palette;
    for (size_t state = 0; state < palette.size(); ++state) {
        palette[state].colour = colourOf((light ? kOnLight : kOnDark)[state]);
        palette[state].shade = (light ? kShadesOnLight : kShadesOnDark)[state];
    }
    palette[size_t(TriangleState::OutsideFrustum)].look = Look::Wireframe;
    palette[size_t(TriangleState::WronglyCulled)].look = Look::Marked;
    return palette;
}

bool needsTrace(const ViewLook& look) { return look.colouring == Colouring::Verdicts || look.boxes; }

void drawViewPicture(Renderer& renderer, const SceneBuffers& buffers, const Strategy& strategy, const View& culling,
                     const View& viewing, const Verdict& verdict, const Trace& trace, const TriangleStates* known,
                     const ViewLook& look, const DrawStyle& style, Framebuffer& target) {
    const VerdictPalette palette = verdictPalette(style.background);
    if (look.colouring == Colouring::Verdicts) {
        const TriangleStates own =
            known != nullptr ? TriangleStates{} : triangleStates(buffers.scene(), culling, verdict.drawList, trace, nullptr);
        const std::vector<TriangleState>& states = known != nullptr ? known->states : own.states;
        renderer.drawByState(buffers, viewing, Facing::TwoSided, bytes(states), look.culledToo ? palette : drawnOnly(palette),
                             target, style);
    } else {
        renderer.draw(buffers, viewing, verdict.drawList, target, style);
    }
    if (look.boxes)
        renderer.drawLines(viewing, boxLines(strategy.inside(trace), palette), {kBoxWidth * style.unit, true}, target);
    // Seen from its own eye a frustum is the picture's border.
    if (!look.frustum || culling.camera() == viewing.camera()) return;
    const Vec3f contrast = contrastTo(style.background);
    drawCased(renderer, viewing, frustumLines(culling, buffers.scene(), contrast), {kFrustumWidth, true}, style, target);
    drawCased(renderer, viewing, eyeMark(culling, viewing, contrast, style.unit), {kEyeWidth, false}, style, target);
}

}  // namespace cullscope
