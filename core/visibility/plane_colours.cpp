#include "core/visibility/plane_colours.h"

#include "core/gpu/colour.h"

namespace cullscope {
namespace {

// By FrustumPlane; the two colours of a plane have about the same hue. Found by search: any two of them, and each with a
// verdict's colour, differ by ΔE₀₀ > 11 in every colour vision that plane_colour_test.cpp simulates.
constexpr std::array<uint32_t, kFrustumPlaneCount> kPlanesOnLight{0x159076, 0x8F5E3A, 0x0C07FD, 0xB96EA9, 0x8B0541, 0x8D8C00};
constexpr std::array<uint32_t, kFrustumPlaneCount> kPlanesOnDark{0x1D886C, 0xFF6C05, 0x6D5B95, 0xD083B3, 0xB14440, 0xB7E8B3};

}  // namespace

std::array<Vec3f, kFrustumPlaneCount> planePalette(const Vec3f& background) {
    const auto& colours = isLight(background) ? kPlanesOnLight : kPlanesOnDark;
    std::array<Vec3f, kFrustumPlaneCount> palette;
    for (size_t plane = 0; plane < palette.size(); ++plane) palette[plane] = colourFromHexadecimal(colours[plane]);
    return palette;
}

PlaneCounts countByPlane(const StructureSnapshot& snapshot) {
    PlaneCounts counts;
    for (const SnapshotNode& node : snapshot.nodes) {
        if (node.isGroup()) continue;
        uint64_t& count = !node.culled      ? counts.kept
                          : node.rejectedBy ? counts.rejected[size_t(*node.rejectedBy)]
                                            : counts.withoutPlane;
        ++count;
    }
    return counts;
}

}  // namespace cullscope
