#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/work_check.h"
#include "core/scene/camera.h"
#include "core/spatial/cut_triangles.h"

namespace cullscope {

/// What the picture shows of a convex polygon before the near plane. Coordinates in pixels, y upward.
struct ScreenPolygon {
    std::vector<Vec2> points;  ///< counter-clockwise; empty: nothing of it lies in the picture
    double x0 = 0.0, x1 = 0.0, y0 = 0.0, y1 = 0.0;
    double near = 0.0, far = 0.0;  ///< the least and largest forward distance, in scene units
    Vec3 inverse{0.0};             ///< 1 / forward distance of its plane at (x, y): inverse.x · x + inverse.y · y + inverse.z

    [[nodiscard]] double inverseAt(const Vec2& at) const { return inverse.x * at.x + inverse.y * at.y + inverse.z; }
};

/// Projects polygons for one view.
class ScreenProjection {
public:
    explicit ScreenProjection(const View& view);

    /// `corners`: relative to the eye, not all in a plane with the eye; `normal`: of their plane.
    [[nodiscard]] ScreenPolygon project(const std::vector<Vec3>& corners, const Vec3& normal) const;

private:
    Vec3 m_forward, m_right,
        m_up;  ///< right and up are scaled: their components are pixels from the middle at forward distance 1
    double m_near, m_width, m_height;
};

/// Where two projections overlap.
struct Overlap {
    /// Projections that overlap by less than this many pixels count as apart: the raster snaps corners to 1/256 pixel.
    static constexpr double kApart = 1.0 / 1024;

    double thickness = 0.0;  ///< pixels, in the direction in which it is least
    /// The first polygon's inverse distance less the second one's, over the overlap: above 0 where the first is nearer. Within
    /// rounding it is 0.
    double leastBefore = std::numeric_limits<double>::infinity();
    double mostBefore = -std::numeric_limits<double>::infinity();

    [[nodiscard]] bool empty() const { return thickness <= kApart || leastBefore > mostBefore; }
};
[[nodiscard]] Overlap overlapOf(const ScreenPolygon& first, const ScreenPolygon& second);

enum class PieceState : uint8_t { Waiting, Marked, Done };

/// A polygon as the painter compares it.
struct Piece {
    static constexpr uint32_t kUncut = 0xFFFFFFFF;
    uint32_t polygon = 0;
    uint32_t lastCut = kUncut;  ///< of the cuts that made it, by number
    PieceState state = PieceState::Waiting;
    int8_t eyeSide = 0;  ///< of its plane
    ScreenPolygon screen;
    CuttingPlane plane;
};

/// Cells over the picture, each with the numbers of the pieces whose extents touch it, by their farthest depth, far first.
class PieceGrid {
public:
    struct Range {
        int x0, y0, x1, y1;
    };
    struct Cell {
        std::vector<uint32_t> pieces;
        size_t begin = 0;  ///< the pieces before are done
    };

    PieceGrid(const Viewport& size, const std::vector<Piece>& pieces) : m_pieces(pieces) {
        double width = 0.0, height = 0.0;
        for (const Piece& piece : pieces) {
            width += piece.screen.x1 - piece.screen.x0;
            height += piece.screen.y1 - piece.screen.y0;
        }
        const double count = std::max(1.0, double(pieces.size())), side = std::sqrt(count);
        m_cellWidth = std::max({width / count, size.width / side, 1.0});
        m_cellHeight = std::max({height / count, size.height / side, 1.0});
        m_columns = int(size.width / m_cellWidth) + 1;
        m_rows = int(size.height / m_cellHeight) + 1;
        m_cells.resize(size_t(m_columns) * size_t(m_rows));
    }

    [[nodiscard]] Range rangeOf(const ScreenPolygon& screen) const {
        const auto cell = [](double at, double size, int count) { return std::clamp(int(at / size), 0, count - 1); };
        return {cell(screen.x0, m_cellWidth, m_columns), cell(screen.y0, m_cellHeight, m_rows),
                cell(screen.x1, m_cellWidth, m_columns), cell(screen.y1, m_cellHeight, m_rows)};
    }
    [[nodiscard]] Cell& cell(int x, int y) { return m_cells[size_t(y) * size_t(m_columns) + size_t(x)]; }
    /// Whether a cell is the one at which a pair is compared, of all that both touch.
    [[nodiscard]] bool isFor(int x, int y, const ScreenPolygon& a, const ScreenPolygon& b) const {
        const Range one = rangeOf(a), other = rangeOf(b);
        return x == std::max(one.x0, other.x0) && y == std::max(one.y0, other.y0);
    }

    /// Pieces must be added far first, or (`sorted` false) one by one later.
    void add(uint32_t number, bool sorted, WorkCheck& work) {
        const Range range = rangeOf(m_pieces[number].screen);
        for (int y = range.y0; y <= range.y1; ++y)
            for (int x = range.x0; x <= range.x1; ++x) {
                work.step();
                Cell& in = cell(x, y);
                auto at = in.pieces.end();
                if (!sorted)
                    at =
                        std::upper_bound(in.pieces.begin() + std::ptrdiff_t(in.begin), in.pieces.end(), number,
                                         [&](uint32_t a, uint32_t b) { return m_pieces[a].screen.far > m_pieces[b].screen.far; });
                in.pieces.insert(at, number);
            }
    }

private:
    const std::vector<Piece>& m_pieces;
    double m_cellWidth = 1.0, m_cellHeight = 1.0;
    int m_columns = 1, m_rows = 1;
    std::vector<Cell> m_cells;
};

}  // namespace cullscope
