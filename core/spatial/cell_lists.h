#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/progress.h"

namespace cullscope {

/// What lies in which cell, in compressed rows: one array of values by cell, and where each cell's begin.
class CellLists {
public:
    using Entry = std::pair<uint32_t, uint32_t>;  ///< cell, value

    CellLists() = default;
    /// From lists of entries, taken in their order: equal lists make equal cells, however they were found.
    CellLists(uint32_t cells, std::span<const std::vector<Entry>> lists);

    [[nodiscard]] uint32_t cellCount() const { return uint32_t(m_starts.size() - 1); }
    [[nodiscard]] uint64_t size() const { return m_values.size(); }
    /// Where a cell's values begin among all; of the one past the last cell: their end.
    [[nodiscard]] uint64_t start(uint32_t cell) const { return m_starts[cell]; }
    [[nodiscard]] std::span<const uint32_t> of(uint32_t cell) const {
        return {m_values.data() + m_starts[cell], m_starts[cell + 1] - m_starts[cell]};
    }
    [[nodiscard]] std::span<uint32_t> of(uint32_t cell) {
        return {m_values.data() + m_starts[cell], m_starts[cell + 1] - m_starts[cell]};
    }
    [[nodiscard]] std::span<const uint32_t> values() const { return m_values; }
    [[nodiscard]] uint64_t bytes() const { return m_starts.size() * sizeof(uint32_t) + m_values.size() * sizeof(uint32_t); }

private:
    std::vector<uint32_t> m_starts{0};  ///< one more than cells
    std::vector<uint32_t> m_values;
};

}  // namespace cullscope
