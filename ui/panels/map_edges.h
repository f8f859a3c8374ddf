#pragma once

#include <QPainterPath>
#include <vector>

#include "ui/panels/map_layout.h"

namespace cullscope::ui {

/// The edge between the chosen cells of a map and the others, and nothing finer than pixels: what it takes does not grow with the
/// map.
class MapEdges {
public:
    MapEdges(const SphericalGrid& grid, const MapLayout& layout);

    /// Chooses single cells, however small they are.
    void choose(const std::vector<SphericalGrid::Cell>& cells);
    [[nodiscard]] QPainterPath path() const;

private:
    [[nodiscard]] bool chosen(uint32_t row, uint32_t column) const { return m_chosen[size_t(row) * m_columns + column] != 0; }
    /// Lines along one border, as long as the sides of it differ: `at` gives its point by number of the step.
    template <typename Differs, typename At>
    void addLines(QPainterPath& path, uint32_t steps, const Differs& differs, const At& at) const;

    const SphericalGrid& m_grid;
    const MapLayout& m_layout;
    uint32_t m_columns, m_rows;  ///< as the map's, but at most one a pixel
    std::vector<uint8_t> m_chosen;
};

}  // namespace cullscope::ui
