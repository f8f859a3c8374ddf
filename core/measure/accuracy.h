#pragma once

#include <cstdint>
#include <vector>

#include "core/measure/reference.h"

namespace cullscope {

/// What a strategy's picture is worth against a reference with the same facing rule.
struct Accuracy {
    uint64_t coveredPixels = 0;             ///< of the reference
    uint64_t missedPixels = 0;              ///< the reference has a surface, the picture a farther one or none
    uint64_t extraPixels = 0;               ///< the picture shows a nearer surface than the reference
    uint64_t largestHolePixels = 0;         ///< largest 4-connected set of missed pixels
    uint64_t visibleTriangles = 0;          ///< |V|
    uint64_t submittedTriangles = 0;        ///< |S|, different ones
    uint64_t falselyCulledTriangles = 0;    ///< |V∖S|
    uint64_t needlesslyDrawnTriangles = 0;  ///< |S∖V|

    [[nodiscard]] double missedPixelRate() const {
        return coveredPixels == 0 ? 0.0 : double(missedPixels) / double(coveredPixels);
    }
    [[nodiscard]] double falselyCulledShare() const {
        return visibleTriangles == 0 ? 0.0 : double(falselyCulledTriangles) / double(visibleTriangles);
    }
    [[nodiscard]] double needlesslyDrawnShare() const {
        return submittedTriangles == 0 ? 0.0 : double(needlesslyDrawnTriangles) / double(submittedTriangles);
    }
};

/// What a depth sample of a picture is beside that of the truth.
enum class PixelDifference : uint8_t {
    None,
    Extra,  ///< the picture shows a nearer surface
    Missed  ///< the picture shows a farther surface, or none
};
[[nodiscard]] inline PixelDifference pixelDifference(float truth, float depth) {
    return depth < truth ? PixelDifference::Missed : depth > truth ? PixelDifference::Extra : PixelDifference::None;
}

/// Compares by depth sample; `depth` is what the strategy's picture has (Framebuffer::readDepth), `list` what it drew.
[[nodiscard]] Accuracy compare(const Reference& reference, const std::vector<float>& depth, const DrawList& list,
                               const Scene& scene);

/// How many missed pixels the raster's snapping to 1/256 pixel does not explain. It does where the pixel's centre lies within
/// 1/64 pixel of an edge of the reference's triangle, or where the picture's surface lies no farther behind it than the depth
/// changes over 1/128 pixel. What `backface` promises is that there are none on a closed mesh seen from outside.
[[nodiscard]] uint64_t missedBeyondSnapping(const Reference& reference, const std::vector<float>& depth, const Scene& scene,
                                            const View& view);

/// Missed pixels as a mask (1 a missed pixel), rows from the bottom.
[[nodiscard]] std::vector<uint8_t> missedMask(const Reference& reference, const std::vector<float>& depth);

/// A 4-connected set of missed pixels.
struct Hole {
    int x = 0, y = 0;  ///< one of its pixels, rows from the bottom
    uint64_t pixels = 0;
};
/// All holes of a mask, largest first; equal ones in the order of their lowest, then leftmost pixel.
[[nodiscard]] std::vector<Hole> holes(std::vector<uint8_t> mask, const Viewport& size);

}  // namespace cullscope
