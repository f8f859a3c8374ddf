#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/base/progress.h"

namespace cullscope {

/// The values of each cell in compressed rows: one array of values ordered by cell, and the start of each cell in it.
class CellLists {
public:
    using Entry = std::pair<uint32_t, uint32_t>;  ///< cell, value

    CellLists() = default;
    /// From lists of entries, in their order: equal lists give equal cells, independent of the threads that filled them.
    /// Checks the progress between lists; throws Error(Interrupted) on a stop request.
    CellLists(uint32_t cells, std::span<const std::vector<Entry>> lists, const Progress& progress = {});

    [[nodiscard]] uint32_t cellCount() const { return uint32_t(m_starts.size() - 1); }
    [[nodiscard]] uint64_t size() const { return m_values.size(); }
    /// The place of a cell's first value among all; for the number one past the last cell, the end.
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
    std::vector<uint32_t> m_starts{0};  ///< one element more than cells
    std::vector<uint32_t> m_values;
};

}  // namespace cullscope
