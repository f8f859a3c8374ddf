#include "core/spatial/cell_lists.h"

#include <cassert>

namespace cullscope {

CellLists::CellLists(uint32_t cells, std::span<const std::vector<Entry>> lists, const Progress& progress)
    : m_starts(size_t(cells) + 1, 0) {
    for (const std::vector<Entry>& list : lists) {
        progress.check();
        for (const auto& [cell, value] : list) {
            assert(cell < cells);
            ++m_starts[cell + 1];
        }
    }
    for (uint32_t cell = 0; cell < cells; ++cell) m_starts[cell + 1] += m_starts[cell];
    m_values.resize(m_starts.back());
    std::vector<uint32_t> next(m_starts.begin(), m_starts.end() - 1);
    for (const std::vector<Entry>& list : lists) {
        progress.check();
        for (const auto& [cell, value] : list) m_values[next[cell]++] = value;
    }
}

}  // namespace cullscope
