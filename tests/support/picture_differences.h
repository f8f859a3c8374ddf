#pragma once

#include <string>

#include "core/measure/accuracy.h"

namespace cullscope::test {

/// Where a frame shows another triangle than the depth buffer.
struct PictureDifferences {
    uint64_t pixels = 0;       ///< all of them
    uint64_t unresolved = 0;   ///< of these, those that an unresolved depth explains, and no edge of a scene triangle
    uint64_t atCuts = 0;       ///< of these, those that only the edge of a cut explains
    uint64_t unexplained = 0;  ///< neither an edge nor an unresolved depth explains them
    std::string first;         ///< the first three of these, in words
};

/// A pixel is explained by an edge of one of the two triangles within 1/128 pixel of its centre, or by an edge as near at which
/// the frame cut one of them: the parts on both sides of a cut have places of their own in the order, and snapping moves a pixel
/// from one to the other; by the line in which their planes meet, as near; or by depths that a float does not tell apart, where
/// each plane may be moved by what its corners in the picture are rounded (1/4096 pixel), and not by their snapping to 1/256
/// pixel, which moves edges alone.
[[nodiscard]] PictureDifferences pictureDifferences(const Scene& scene, const View& view, const Reference& truth,
                                                    const ShownPixels& shown, const FrameLog& log);

}  // namespace cullscope::test
