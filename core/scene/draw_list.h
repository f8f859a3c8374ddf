#pragma once

#include <cstdint>
#include <vector>

namespace cullscope {

/// Which faces OpenGL draws.
enum class Facing { TwoSided, Front };

/// A run of indices of one instance's mesh, in the mesh's own order.
struct DrawRange {
    uint32_t instance = 0;
    uint32_t firstIndex = 0;  ///< a multiple of 3
    uint32_t indexCount = 0;  ///< a multiple of 3

    bool operator==(const DrawRange&) const = default;
};

/// What a strategy decided to draw, in order. Ranges of the same instance that follow each other go to OpenGL as one multi-draw.
struct DrawList {
    Facing facing = Facing::TwoSided;
    std::vector<DrawRange> ranges;

    [[nodiscard]] uint64_t triangleCount() const {
        uint64_t count = 0;
        for (const DrawRange& range : ranges) count += range.indexCount / 3;
        return count;
    }
};

}  // namespace cullscope
