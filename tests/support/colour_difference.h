#pragma once

#include <array>

#include "core/geometry/types.h"

namespace cullscope::test {

/// CIE L*a*b* under D65.
struct Lab {
    double lightness = 0.0, a = 0.0, b = 0.0;
};

/// ΔE₀₀ with all weights 1 (Sharma, Wu & Dalal, "The CIEDE2000 color-difference formula", Color Research & Application 30(1),
/// 2005).
[[nodiscard]] double ciede2000(const Lab& first, const Lab& second);

/// Linear sRGB of an sRGB colour in [0, 1], and its L*a*b* (IEC 61966-2-1, D65).
[[nodiscard]] Vec3 linearOf(const Vec3& srgb);
[[nodiscard]] Lab labOf(const Vec3& linear);

/// A model of how an observer perceives linear sRGB.
struct Sight {
    const char* name;
    Mat3 linear;  ///< applied to linear sRGB, the result clamped to [0, 1]

    [[nodiscard]] Vec3 seen(const Vec3& linearColour) const;
};

/// Normal colour vision; luminance only; protanopia, deuteranopia and tritanopia by the matrices for severity 1.0 of Machado,
/// Oliveira & Fernandes, "A Physiologically-based Model for Simulation of Color Vision Deficiency", IEEE TVCG 15(6), 2009.
[[nodiscard]] const std::array<Sight, 5>& sights();

}  // namespace cullscope::test
