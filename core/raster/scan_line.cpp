#include "core/raster/scan_line.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/work_check.h"
#include "core/raster/active_edge.h"
#include "core/raster/in_parallel.h"
#include "core/raster/triangle_setup.h"

namespace cullscope {
namespace {

constexpr int kNever = std::numeric_limits<int>::max();
constexpr uint32_t kNoSurface = UINT32_MAX;

/// A triangle that the current row may meet.
struct Surface {
    const ScreenTriangle* triangle = nullptr;
    uint32_t order = 0;  ///< in which it would be drawn
    int edgeCount = 0;
    ActiveEdge edges[3];
    int corners[3]{};  ///< by edge: where it begins
    // In the current row:
    int begin = 0, end = 0;  ///< its pixels
    int mayCross = kNever;   ///< the first column at which it may come before the surface in front
};

/// Depth exactly as the depth buffer has it.
float depthAt(const Surface& surface, int row, int column) { return depthOf(*surface.triangle, column, row); }

/// A surface's depth at a pixel before any rounding, and by how much depthAt may differ from it.
struct UnroundedDepth {
    double depth, error;
};
UnroundedDepth unroundedAt(const Surface& surface, int row, int column) {
    const ScreenTriangle& triangle = *surface.triangle;
    const double along = double(triangle.depth) + double(triangle.depthPerColumn) * column;
    const double depth = along + double(triangle.depthPerRow) * row;
    // A float's rounding is 2^-24 of it; the rest is that of this computation, and of the smallest floats.
    return {depth, 0x1.01p-24 * (std::abs(along) + std::abs(depth)) + 0x1p-140};
}

/// The rows of one band, from the bottom up.
class Sweep {
public:
    Sweep(std::span<const ScreenTriangle> triangles, const Viewport& size, int firstRow, int endRow, bool keepSpans,
          FinishedPicture& picture, std::vector<uint8_t>& fates, const Progress& progress)
        : m_size(size), m_picture(picture), m_fates(fates), m_keepSpans(keepSpans), m_work(progress) {
        m_starting.resize(size_t(endRow - firstRow));
        worked(triangles.size());
        for (uint32_t i = 0; i < triangles.size(); ++i)
            m_starting[size_t(std::max(triangles[i].firstRow, firstRow) - firstRow)].push_back({&triangles[i], i});
        for (int row = firstRow; row < endRow; ++row) {
            for (const auto& [triangle, order] : m_starting[size_t(row - firstRow)]) begin(*triangle, order, row);
            sweep(row);
            goUp(row);
        }
    }

    /// The edge table, the active edges and surfaces at their largest.
    [[nodiscard]] uint64_t bytes() const {
        uint64_t sum =
            m_surfaces.capacity() * sizeof(Surface) + (m_beginning.capacity() + m_active.capacity()) * sizeof(uint32_t);
        for (const auto& starting : m_starting) sum += sizeof starting + starting.capacity() * sizeof(Starting);
        return sum;
    }

    std::vector<RowCounts> counts;
    std::vector<RowSpan> spans;
    std::vector<RowStep> steps;
    std::vector<RowEdge> edges;

private:
    /// So many surfaces were looked at, each in some ten nanoseconds.
    void worked(size_t surfaces) {
        constexpr size_t kOfAStep = 64;
        for (m_looked += surfaces; m_looked >= kOfAStep; m_looked -= kOfAStep) m_work.step();
    }

    struct Starting {
        const ScreenTriangle* triangle;
        uint32_t order;
    };

    void begin(const ScreenTriangle& triangle, uint32_t order, int row) {
        Surface surface;
        surface.triangle = &triangle;
        surface.order = order;
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            if (triangle.y[next] == triangle.y[i]) continue;
            surface.corners[surface.edgeCount] = i;
            surface.edges[surface.edgeCount++] = ActiveEdge(triangle, i, row);
        }
        m_surfaces.push_back(surface);
    }

    void goUp(int row) {
        worked(m_surfaces.size());
        std::erase_if(m_surfaces, [&](const Surface& surface) { return surface.triangle->endRow <= row + 1; });
        for (Surface& surface : m_surfaces)
            for (int i = 0; i < surface.edgeCount; ++i) surface.edges[i].goUp();
    }

    /// Whether the row lies on a horizontal edge at the triangle's top, which does not belong to it.
    static bool onTopEdge(const ScreenTriangle& triangle, int row) {
        for (int i = 0; i < 3; ++i) {
            const int next = (i + 1) % 3;
            if (triangle.y[i] == row * kSubPixels && triangle.y[next] == triangle.y[i] && triangle.x[next] < triangle.x[i])
                return true;
        }
        return false;
    }

    /// Finds the pixels of each surface in a row.
    void findIntervals(int row) {
        m_beginning.clear();
        for (uint32_t i = 0; i < m_surfaces.size(); ++i) {
            worked(2);
            Surface& surface = m_surfaces[i];
            const ScreenTriangle& triangle = *surface.triangle;
            if (onTopEdge(triangle, row)) continue;
            int64_t begin = triangle.firstColumn, end = triangle.endColumn;
            for (int e = 0; e < surface.edgeCount; ++e) {
                const ActiveEdge& edge = surface.edges[e];
                if (!edge.reaches(row)) continue;
                if (edge.begins())
                    begin = std::max(begin, edge.column());
                else
                    end = std::min(end, edge.column());
            }
            if (begin >= end) continue;
            surface.begin = int(begin);
            surface.end = int(end);
            counts.back().edges += 2;
            counts.back().samples += uint64_t(end - begin);
            // Other bands may say the same of the triangle at the same time.
            std::atomic_ref(m_fates[triangle.number - 1]).store(kCovers, std::memory_order_relaxed);
            // A surface without a plane is nowhere the nearest.
            if (!std::isnan(triangle.depth)) m_beginning.push_back(i);
        }
        const auto fromLeft = [&](uint32_t a, uint32_t b) {
            return m_surfaces[a].begin != m_surfaces[b].begin ? m_surfaces[a].begin < m_surfaces[b].begin : a < b;
        };
        std::ranges::sort(m_beginning, [&](uint32_t a, uint32_t b) {
            worked(1);
            return fromLeft(a, b);
        });
    }

    /// The active edges of a row, which bound the surfaces that have pixels in it.
    void keepEdges(int row) {
        for (const uint32_t i : m_beginning) {
            const Surface& surface = m_surfaces[i];
            std::optional<RowEdge> begin, end;
            for (int e = 0; e < surface.edgeCount; ++e) {
                const ActiveEdge& edge = surface.edges[e];
                if (!edge.reaches(row)) continue;
                std::optional<RowEdge>& kept = edge.begins() ? begin : end;
                if (kept && (edge.begins() ? edge.column() <= kept->column : edge.column() >= kept->column)) continue;
                kept = rowEdge(*surface.triangle, edge, surface.corners[e], row);
            }
            for (const std::optional<RowEdge>& kept : {begin, end})
                if (kept) edges.push_back(*kept);
        }
    }

    void keepStep(int row, int column, RowStep::At at, uint32_t surface, uint32_t other, bool toFront) {
        if (!m_keepSpans || steps.size() > kMostRowSteps) return;
        RowStep step{row, column, at, toFront, m_surfaces[surface].triangle->number - 1};
        step.depth = depthAt(m_surfaces[surface], row, column);
        if (other != kNoSurface) {
            step.other = m_surfaces[other].triangle->number;
            step.otherDepth = depthAt(m_surfaces[other], row, column);
        }
        steps.push_back(step);
    }

    /// Whether a surface comes before another one at a pixel: a comparison of depths.
    bool before(uint32_t surface, uint32_t other, int row, int column) {
        ++counts.back().comparisons;
        const float a = depthAt(m_surfaces[surface], row, column), b = depthAt(m_surfaces[other], row, column);
        return a > b || (a == b && m_surfaces[surface].order < m_surfaces[other].order);
    }

    /// The first column from `from` at which a surface may come before the one in front. Both depths change evenly along the row;
    /// before that column their difference exceeds what their rounding to float, and that of its own computation, can hide.
    static int crossingOf(const Surface& surface, const Surface& front, int row, int from) {
        const int last = std::min(surface.end, front.end) - 1;
        if (from > last) return kNever;
        const UnroundedDepth s0 = unroundedAt(surface, row, from), s1 = unroundedAt(surface, row, last);
        const UnroundedDepth f0 = unroundedAt(front, row, from), f1 = unroundedAt(front, row, last);
        // Errors are largest at one of the ends.
        const double margin = std::max(s0.error, s1.error) + std::max(f0.error, f1.error);
        // Where depths are limited to 1 they do not change evenly.
        if (std::max(s0.depth, s1.depth) + margin >= 1.0) return from;
        const double atFrom = s0.depth - f0.depth, atLast = s1.depth - f1.depth;
        if (atFrom >= -margin) return from;
        if (atLast < -margin) return kNever;
        const double columns = (-margin - atFrom) / (atLast - atFrom) * double(last - from);
        return std::clamp(from + int(columns) - 1, from, last);
    }

    void sweep(int row) {
        counts.push_back({row, row + 1});
        findIntervals(row);
        counts.back().triangles = m_beginning.size();
        if (m_keepSpans && edges.size() <= kMostRowEdges) keepEdges(row);
        m_active.clear();
        m_front = kNoSurface;
        size_t beginning = 0;
        int spanBegin = 0;
        const auto finish = [&](int end) {
            if (m_front == kNoSurface) return;
            write(row, spanBegin, end);
            ++counts.back().spans;
            if (m_keepSpans) spans.push_back({row, spanBegin, end, m_surfaces[m_front].triangle->number - 1});
        };
        while (beginning < m_beginning.size() || !m_active.empty()) {
            worked(4 + 3 * m_active.size());
            int column = m_active.empty() ? kNever : nextActive();
            if (beginning < m_beginning.size()) column = std::min(column, m_surfaces[m_beginning[beginning]].begin);

            const uint32_t old = m_front;
            std::erase_if(m_active, [&](uint32_t surface) { return m_surfaces[surface].end <= column; });
            const bool ended = old != kNoSurface && m_surfaces[old].end <= column;
            uint32_t front = ended ? kNoSurface : old;
            bool crossed = false;
            const auto challenge = [&](uint32_t surface, RowStep::At at) {
                const bool wins = front == kNoSurface || before(surface, front, row, column);
                keepStep(row, column, at, surface, front, wins);
                if (!wins) return;
                front = surface;
                crossed = at == RowStep::At::Crosses;
            };
            // Where the surface in front ended, those that remain are compared with each other; else those that may cross it.
            for (const uint32_t surface : m_active) {
                if (surface == old) continue;
                if (ended)
                    challenge(surface, RowStep::At::Ends);
                else if (m_surfaces[surface].mayCross <= column)
                    challenge(surface, RowStep::At::Crosses);
            }
            const size_t already = m_active.size();
            for (; beginning < m_beginning.size() && m_surfaces[m_beginning[beginning]].begin == column; ++beginning) {
                const uint32_t surface = m_beginning[beginning];
                challenge(surface, RowStep::At::Begins);
                m_active.push_back(surface);
            }
            if (front != old) {
                if (crossed) ++counts.back().crossings;
                finish(column);
                spanBegin = column;
                m_front = front;
            }
            for (size_t i = 0; i < m_active.size() && front != kNoSurface; ++i) {
                Surface& surface = m_surfaces[m_active[i]];
                if (m_active[i] == front)
                    surface.mayCross = kNever;
                else if (front != old || i >= already || surface.mayCross <= column)
                    surface.mayCross = crossingOf(surface, m_surfaces[front], row, column + 1);
            }
        }
    }

    /// The next column at which an active surface ends or may cross the one in front.
    [[nodiscard]] int nextActive() const {
        int next = kNever;
        for (const uint32_t surface : m_active)
            next = std::min(next, std::min(m_surfaces[surface].end, m_surfaces[surface].mayCross));
        return next;
    }

    /// Fills a span with the surface in front, without a comparison; what lies beyond the far plane (depth 0) is not shown.
    void write(int row, int begin, int end) {
        const Surface& front = m_surfaces[m_front];
        const size_t first = size_t(row) * size_t(m_size.width);
        for (int column = begin; column < end; ++column) {
            const float depth = depthAt(front, row, column);
            if (!(depth > 0.0f)) continue;
            m_picture.depth[first + size_t(column)] = depth;
            m_picture.triangle[first + size_t(column)] = front.triangle->number;
            ++counts.back().written;
        }
    }

    const Viewport& m_size;
    FinishedPicture& m_picture;
    std::vector<uint8_t>& m_fates;
    bool m_keepSpans;
    std::vector<std::vector<Starting>> m_starting;  ///< the edge table: what begins in each row
    std::vector<Surface> m_surfaces;                ///< in the order in which they began
    std::vector<uint32_t> m_beginning;              ///< in the current row, from the left
    std::vector<uint32_t> m_active;                 ///< at the current column
    uint32_t m_front = kNoSurface;
    WorkCheck m_work;
    size_t m_looked = 0;  ///< surfaces since the last step
};

}  // namespace

ScanLinePicture drawScanLine(const SceneOnRaster& scene, bool keepSpans, bool parallel, const Progress& progress) {
    const size_t pixels = size_t(scene.size.width) * size_t(scene.size.height);
    ScanLinePicture result;
    result.picture = std::make_shared<FinishedPicture>();
    result.picture->size = scene.size;
    result.picture->triangle.assign(pixels, 0);
    result.picture->depth.assign(pixels, 0.0f);
    std::vector<std::vector<RowCounts>> counts(scene.bands());
    std::vector<std::vector<RowSpan>> spans(scene.bands());
    std::vector<std::vector<RowStep>> steps(scene.bands());
    std::vector<std::vector<RowEdge>> edges(scene.bands());
    std::vector<uint64_t> bytes(scene.bands());
    result.fates = scene.fates;
    forEachOf(scene.bands(), parallel, [&](size_t number) {
        const int first = int(number) * kBandRows;
        const std::vector<ScreenTriangle> triangles = scene.trianglesIn(number, progress);
        Sweep sweep(triangles, scene.size, first, std::min(first + kBandRows, scene.size.height), keepSpans, *result.picture,
                    result.fates, progress);
        bytes[number] = triangles.capacity() * sizeof(ScreenTriangle) + sweep.bytes();
        counts[number] = std::move(sweep.counts);
        spans[number] = std::move(sweep.spans);
        steps[number] = std::move(sweep.steps);
        edges[number] = std::move(sweep.edges);
    });
    result.bytes = bytes.empty() ? 0 : std::ranges::max(bytes);
    for (size_t number = 0; number < scene.bands(); ++number) {
        for (RowCounts& row : counts[number]) row.covered = row.written;
        result.rows.insert(result.rows.end(), counts[number].begin(), counts[number].end());
        result.spans.insert(result.spans.end(), spans[number].begin(), spans[number].end());
        if (result.steps.size() <= kMostRowSteps)
            result.steps.insert(result.steps.end(), steps[number].begin(), steps[number].end());
        if (result.edges.size() <= kMostRowEdges)
            result.edges.insert(result.edges.end(), edges[number].begin(), edges[number].end());
    }
    if (result.steps.size() > kMostRowSteps) result.steps.clear();
    if (result.edges.size() > kMostRowEdges) result.edges.clear();
    return result;
}

}  // namespace cullscope
