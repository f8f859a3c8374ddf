#pragma once

#include <bit>
#include <cstring>
#include <span>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/steps.h"

namespace cullscope {

/// Gives exactly equal positions (-0 equals 0) the same number. Open addressing in one flat table, which grows as positions are
/// added.
template <typename Position>
class Welder {
public:
    /// `expected`: an estimate of the number of positions.
    explicit Welder(const Progress& progress, size_t expected = 0) : m_progress(&progress) {
        if (expected > 0) m_table.assign(std::bit_ceil(2 * expected + 2), kFree);
    }

    /// The number of the first position equal to `position`; where there is none, `count`, the number of `position` itself.
    /// `at(i)` returns the position with number i.
    template <typename At>
    uint32_t findOrAdd(const Position& position, uint32_t count, At&& at) {
        if (position != position) return count;  // NaN equals no position, and many of them would fill one slot
        if (2 * (m_used + 1) > m_table.size()) grow(at);
        size_t slot = hash(position) & (m_table.size() - 1);
        while (m_table[slot] != kFree) {
            if (at(m_table[slot]) == position) return m_table[slot];
            slot = (slot + 1) & (m_table.size() - 1);
        }
        m_table[slot] = count;
        ++m_used;
        return count;
    }

private:
    static constexpr uint32_t kFree = 0xffffffffU;

    static size_t hash(const Position& position) {
        uint64_t mixed = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const auto coordinate = position[axis] + 0;  // -0 becomes 0
            uint64_t bits = 0;
            std::memcpy(&bits, &coordinate, sizeof(coordinate));
            mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15ULL;
            mixed ^= mixed >> 29;
        }
        return static_cast<size_t>(mixed ^ (mixed >> 32));
    }

    template <typename At>
    void grow(At&& at) {
        const std::vector<uint32_t> old = std::move(m_table);
        m_table.assign(std::max<size_t>(64, 2 * old.size()), kFree);
        inSteps(old.size(), *m_progress, [&](size_t begin, size_t end) {
            for (size_t i = begin; i < end; ++i) {
                if (old[i] == kFree) continue;
                size_t slot = hash(at(old[i])) & (m_table.size() - 1);
                while (m_table[slot] != kFree) slot = (slot + 1) & (m_table.size() - 1);
                m_table[slot] = old[i];
            }
        });
    }

    const Progress* m_progress;
    std::vector<uint32_t> m_table;
    size_t m_used = 0;
};

/// For each position the number of the first one with exactly the same coordinates.
template <typename Position>
std::vector<uint32_t> firstOfEqualPositions(std::span<const Position> positions, const Progress& progress) {
    std::vector<uint32_t> first(positions.size());
    Welder<Position> welder(progress, positions.size());
    inSteps(positions.size(), progress, [&](size_t begin, size_t end) {
        for (size_t vertex = begin; vertex < end; ++vertex)
            first[vertex] =
                welder.findOrAdd(positions[vertex], static_cast<uint32_t>(vertex), [&](uint32_t i) { return positions[i]; });
    });
    return first;
}

}  // namespace cullscope
