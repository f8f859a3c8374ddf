#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/frame/frame_log.h"

namespace cullscope {

/// What a frame submitted, in the scene's terms: the one definition for headers, tables, reports, pictures and result files.
struct Submitted {
    uint64_t triangles = 0;  ///< of the scene, of which anything is drawn: each once, however many parts. Of a picture made
                             ///< without OpenGL those that it shows
    uint64_t fragments = 0;  ///< parts of triangles that the strategy made itself, where it cuts or orders them; counted apart

    /// The share of a scene's triangles, 0 to 1.
    [[nodiscard]] double share(uint64_t sceneTriangles) const {
        return sceneTriangles == 0 ? 0.0 : double(triangles) / double(sceneTriangles);
    }
    bool operator==(const Submitted&) const = default;
};
[[nodiscard]] Submitted submittedBy(const Scene& scene, const FrameLog& log);

/// Ranges of scene triangle numbers [first, end), ascending and disjoint.
using TriangleIntervals = std::vector<std::pair<uint64_t, uint64_t>>;
/// The triangles of a draw list, each once, as `submittedBy` counts them.
[[nodiscard]] TriangleIntervals submittedIntervals(const Scene& scene, const DrawList& list);
/// How many triangles intervals hold.
[[nodiscard]] uint64_t triangleCount(const TriangleIntervals& intervals);

}  // namespace cullscope
