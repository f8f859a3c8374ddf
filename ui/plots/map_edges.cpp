#include "ui/plots/map_edges.h"

#include <algorithm>

namespace cullscope::ui {

namespace {

/// If a length is divided into `of` parts: the part under the centre of part `index` of `count`.
uint32_t under(uint32_t index, uint32_t count, uint32_t of) {
    return uint32_t((2 * uint64_t(index) + 1) * of / (2 * uint64_t(count)));
}

}  // namespace

MapEdges::MapEdges(const SphericalGrid& grid, const MapLayout& layout)
    : m_grid(grid),
      m_layout(layout),
      m_columns(std::min(grid.columns(), uint32_t(layout.area.width()))),
      m_rows(std::min(grid.rows(), uint32_t(layout.area.height()))),
      m_chosen(size_t(m_columns) * m_rows, 0) {}

void MapEdges::choose(const std::vector<SphericalGrid::Cell>& cells) {
    for (const SphericalGrid::Cell& cell : cells)
        m_chosen[size_t(under(cell.row, m_grid.rows(), m_rows)) * m_columns + under(cell.column, m_grid.columns(), m_columns)] =
            1;
}

template <typename Differs, typename At>
void MapEdges::addLines(QPainterPath& path, uint32_t steps, const Differs& differs, const At& at) const {
    for (uint32_t step = 0; step < steps; ++step) {
        if (!differs(step)) continue;
        path.moveTo(at(step));
        while (step < steps && differs(step)) ++step;
        path.lineTo(at(step));
    }
}

QPainterPath MapEdges::path() const {
    const QRectF& area = m_layout.area;
    const double width = area.width() / m_columns, height = area.height() / m_rows;
    const auto at = [&](uint32_t row, uint32_t column) {
        return QPointF(area.left() + column * width, area.top() + row * height);
    };
    QPainterPath path;
    for (uint32_t row = 1; row < m_rows; ++row)
        addLines(
            path, m_columns, [&](uint32_t step) { return chosen(row, step) != chosen(row - 1, step); },
            [&](uint32_t step) { return at(row, step); });
    // The map wraps around: its left and right edges are the same line, and the first column follows the last one.
    for (uint32_t column = 1; column <= m_columns; ++column)
        addLines(
            path, m_rows, [&](uint32_t step) { return chosen(step, column % m_columns) != chosen(step, column - 1); },
            [&](uint32_t step) { return at(step, column); });
    return path;
}

}  // namespace cullscope::ui
