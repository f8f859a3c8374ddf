#pragma once

#include <algorithm>
#include <cmath>

#include "core/raster/scan_line.h"
#include "core/raster/screen_triangle.h"

namespace cullscope {

/// An edge while rows pass it. The column where it lies in a row is a whole number and a remainder, so that no step rounds.
class ActiveEdge {
public:
    ActiveEdge() = default;
    /// The edge of a triangle from corner i to the next one, which must not be horizontal, at its row `row`.
    ActiveEdge(const ScreenTriangle& triangle, int i, int row) {
        const int next = (i + 1) % 3;
        const int64_t dx = triangle.x[next] - triangle.x[i], dy = triangle.y[next] - triangle.y[i];
        m_begins = dy < 0;
        m_divisor = std::abs(dy) * kSubPixels;
        // A left edge owns the centres on it, a right edge does not: the first column inside is the ceiling of where the left
        // edge lies, the first one outside that of where the right edge lies.
        const int64_t onRow = m_begins ? -dx * (int64_t(row) * kSubPixels - triangle.y[i]) - dy * triangle.x[i]
                                       : dx * (int64_t(row) * kSubPixels - triangle.y[i]) + dy * triangle.x[i];
        set(onRow + m_divisor - 1, m_column, m_remainder);
        set((m_begins ? -dx : dx) * kSubPixels, m_columnStep, m_remainderStep);
        const auto [low, high] = std::minmax(triangle.y[i], triangle.y[next]);
        m_firstRow = (low + kSubPixels - 1) >> 8;
        m_endRow = (high >> 8) + 1;
    }

    /// Whether it begins spans (a left edge) or ends them.
    [[nodiscard]] bool begins() const { return m_begins; }
    [[nodiscard]] bool reaches(int row) const { return m_firstRow <= row && row < m_endRow; }
    /// The first column to the right of the edge, in the current row.
    [[nodiscard]] int64_t column() const { return m_column; }
    void goUp() {
        m_column += m_columnStep;
        m_remainder += m_remainderStep;
        if (m_remainder >= m_divisor) {
            m_remainder -= m_divisor;
            ++m_column;
        }
    }

private:
    void set(int64_t dividend, int64_t& quotient, int64_t& remainder) const {
        quotient = dividend / m_divisor;
        if (quotient * m_divisor > dividend) --quotient;
        remainder = dividend - quotient * m_divisor;
    }

    int64_t m_column = 0, m_remainder = 0, m_columnStep = 0, m_remainderStep = 0, m_divisor = 1;
    int m_firstRow = 0, m_endRow = 0;
    bool m_begins = false;
};

/// An edge in a row, as steps tell of it. `from`: the corner where it begins.
inline RowEdge rowEdge(const ScreenTriangle& triangle, const ActiveEdge& edge, int from, int row) {
    const int to = (from + 1) % 3;
    RowEdge result{row, int(edge.column()), edge.begins(), triangle.number - 1};
    const double down = double(row) * kSubPixels - triangle.y[from], height = double(triangle.y[to]) - triangle.y[from];
    result.x = (triangle.x[from] + (double(triangle.x[to]) - triangle.x[from]) * down / height) / kSubPixels;
    for (size_t i = 0; i < 2; ++i) {
        const int corner = i == 0 ? from : to;
        const float x = float(triangle.x[corner]) / kSubPixels, y = float(triangle.y[corner]) / kSubPixels;
        result.ends[i] = {x, y, triangle.depth + triangle.depthPerColumn * x + triangle.depthPerRow * y};
    }
    return result;
}

}  // namespace cullscope
