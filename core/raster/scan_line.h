#pragma once

#include <array>

#include "core/raster/depth_buffer.h"

namespace cullscope {

/// A piece of a row in which one surface is in front, as the scan line found it.
struct RowSpan {
    int row = 0, begin = 0, end = 0;  ///< pixels [begin, end) of a row
    uint32_t triangle = 0;            ///< the scene's triangle number
};

/// What became of a surface at a column at which the scan line looked at it: a comparison of depths, or none.
struct RowStep {
    enum class At : uint8_t {
        Begins,  ///< the surface begins there
        Ends,    ///< the one that was in front ends there, and the surface remains
        Crosses  ///< the surface may pass through the one in front
    };
    int row = 0, column = 0;
    At at = At::Begins;
    bool toFront = false;     ///< whether it comes to the front
    uint32_t triangle = 0;    ///< the scene's triangle number
    uint32_t other = 0;       ///< scene triangle number + 1 of the one in front that it was compared with; 0: none was in front
    float depth = 0.0f;       ///< reversed
    float otherDepth = 0.0f;  ///< of the other surface there; of equal ones the one that would be drawn first is in front
};
/// Of pictures with more steps in all rows together none are kept.
inline constexpr size_t kMostRowSteps = 100'000;

/// An edge that bounds a surface in a row: one of the row's active edges.
struct RowEdge {
    /// A corner on the raster: columns and rows, counted from the centre of the first pixel, and the reversed depth there.
    struct End {
        float x = 0.0f, y = 0.0f, depth = 0.0f;
    };
    int row = 0;
    int column = 0;         ///< the first one to the right of the edge
    bool begins = false;    ///< whether the surface lies to the right of it
    uint32_t triangle = 0;  ///< the scene's triangle number
    double x = 0.0;         ///< where the edge lies in the row
    std::array<End, 2> ends{};
};
/// Of pictures with more active edges in all rows together none are kept.
inline constexpr size_t kMostRowEdges = 50'000;

/// A picture by the scan line, and the spans, steps and active edges of its rows where they were asked for.
struct ScanLinePicture : RasterPicture {
    std::vector<RowSpan> spans;  ///< by row from the bottom, then from the left
    std::vector<RowStep> steps;  ///< likewise, as they fall: all comparisons of depths among them; empty: as the edges
    std::vector<RowEdge> edges;  ///< by row, the two of a surface together, surfaces from the left; empty: not asked for, or more
};

/// The same picture as drawDepthBuffer, to the bit, by the scan line: an edge table by rows, the active edges of each row, and
/// the spans between them. Depths are compared only where a surface begins, where the one in front ends, and where two surfaces
/// may cross. That is where their depths lie within the rounding of a float; from there on they are compared pixel by pixel until
/// one is surely in front. At equal depths the surface that would be drawn first stays. Counts are by rows. `keepSpans`: spans,
/// steps and active edges are returned. Throws Error(Interrupted) soon after a stop is requested.
[[nodiscard]] ScanLinePicture drawScanLine(const SceneOnRaster& scene, bool keepSpans = false, bool parallel = true,
                                           const Progress& progress = {});

}  // namespace cullscope
