#include "core/visibility/verdict_palette.h"

#include "core/gpu/colour.h"

namespace cullscope {
namespace {

using VerdictPalette = std::array<PaletteEntry, kTriangleStateCount>;

constexpr std::array<uint32_t, kTriangleStateCount> kOnLight{0x1FC3E3, 0xDBAC16, 0xC8CCD0, 0x3168F5,
                                                             0x441094, 0x5D3A05, 0xF02172, 0xB4B4B4};
constexpr std::array<uint32_t, kTriangleStateCount> kOnDark{0x88EAEE, 0xF4FB19, 0x4A5058, 0x30A3FE,
                                                            0x8A2BFF, 0xFAB970, 0xE7120E, 0xAEA198};

/// The middle of each colour's shading. With 1 for all, some pairs have the same grey (drawn and visible, drawn in vain); with
/// these values any two differ by ΔE₀₀ ≥ 8 in every colour vision that verdict_colour_test.cpp simulates. What is not yet decided
/// is a grey that keeps this distance to all but the two states that need the truth: a picture has either it or them.
constexpr std::array<float, kTriangleStateCount> kShadesOnLight{0.9125f, 0.7625f, 1.0f, 0.775f, 0.7f, 0.975f, 1.0f, 0.7f};
constexpr std::array<float, kTriangleStateCount> kShadesOnDark{0.9125f, 1.1f, 0.85f, 0.875f, 0.8625f, 0.8375f, 1.0f, 0.7f};

}  // namespace

VerdictPalette verdictPalette(const Vec3f& background) {
    const bool light = isLight(background);
    VerdictPalette palette;
    for (size_t state = 0; state < palette.size(); ++state) {
        palette[state].colour = colourFromHexadecimal((light ? kOnLight : kOnDark)[state]);
        palette[state].shade = (light ? kShadesOnLight : kShadesOnDark)[state];
    }
    palette[size_t(TriangleState::OutsideFrustum)].look = PaletteEntry::Look::Wireframe;
    palette[size_t(TriangleState::WronglyCulled)].look = PaletteEntry::Look::Marked;
    return palette;
}

}  // namespace cullscope
