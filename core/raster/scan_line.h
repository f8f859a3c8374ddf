#pragma once

#include <array>

#include "core/raster/depth_buffer.h"

namespace cullscope {

/// A piece of a row in which one surface is in front, as the scan line found it.
struct RowSpan {
    /// What made a surface the one in front.
    enum class Start : uint8_t {
        Alone,    ///< there was no other surface
        Begins,   ///< it begins there, before the surface that was in front
        Remains,  ///< the surface before it ended there, and it is the nearest of those that remain
        Crosses   ///< it passes through the surface that was in front
    };
    int row = 0, begin = 0, end = 0;  ///< pixels [begin, end) of a row
    Start start = Start::Alone;
    uint32_t triangle = 0;     ///< the scene's triangle number
    uint32_t other = 0;        ///< scene triangle number + 1 of the surface that it was compared with; 0: none
    float depth = 0.0f;        ///< reversed, at the first pixel
    float otherDepth = 0.0f;   ///< of the other surface there
    uint32_t comparisons = 0;  ///< of depths, since the span before it began
};

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

/// A picture by the scan line, and the spans and active edges of its rows where they were asked for.
struct ScanLinePicture : RasterPicture {
    std::vector<RowSpan> spans;  ///< by row from the bottom, then from the left
    std::vector<RowEdge> edges;  ///< by row, the two of a surface together, surfaces from the left; empty: not asked for, or more
};

/// The same picture as drawDepthBuffer, to the bit, by the scan line: an edge table by rows, the active edges of each row, and
/// the spans between them. Depths are compared only where a surface begins, where the one in front ends, and where two surfaces
/// may cross. That is where their depths lie within the rounding of a float; from there on they are compared pixel by pixel until
/// one is surely in front. At equal depths the surface that would be drawn first stays. Counts are by rows. `keepSpans`: spans
/// and active edges are returned. Throws Error(Interrupted) soon after a stop is requested.
[[nodiscard]] ScanLinePicture drawScanLine(const SceneOnRaster& scene, bool keepSpans = false, bool parallel = true,
                                           const Progress& progress = {});

}  // namespace cullscope
