#pragma once

#include <QPainterPath>
#include <vector>

#include "ui/plots/map_layout.h"

namespace cullscope::ui {

/// The boundary between the chosen cells of a map and the others, at the resolution of pixels, so that time and memory do not
/// grow with the map.
class MapEdges {
public:
    MapEdges(const SphericalGrid& grid, const MapLayout& layout);

    /// Chooses cells; a cell smaller than a pixel chooses that pixel.
    void choose(const std::vector<SphericalGrid::Cell>& cells);
    [[nodiscard]] QPainterPath path() const;

private:
    [[nodiscard]] bool chosen(uint32_t row, uint32_t column) const { return m_chosen[size_t(row) * m_columns + column] != 0; }
    /// Adds the lines along one grid line, wherever the cells on its two sides differ. `at` returns the point of a step.
    template <typename Differs, typename At>
    void addLines(QPainterPath& path, uint32_t steps, const Differs& differs, const At& at) const;

    const SphericalGrid& m_grid;
    const MapLayout& m_layout;
    uint32_t m_columns, m_rows;  ///< those of the map, but at most one per pixel
    std::vector<uint8_t> m_chosen;
};

}  // namespace cullscope::ui
