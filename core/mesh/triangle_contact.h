#pragma once

#include <array>
#include <span>

#include "core/geometry/triangle.h"

namespace cullscope {

/// Where two triangles meet besides the corners and the edge that they share.
struct TriangleContact {
    struct Piece {
        Vec3 from, to;
    };
    /// One line for planes that cross. Where both lie in one plane: the edges of both, whole, that bound what they share.
    std::array<Piece, 6> pieces;
    size_t count = 0;

    [[nodiscard]] std::span<const Piece> lines() const { return {pieces.data(), count}; }
};

/// Coordinates are at most about 1 in magnitude. What is nearer than kContactRoom counts as touching, and contacts shorter than
/// it are none: in double, so that a contact may be named that is not quite one. Equal corners are shared. A triangle without an
/// area meets nothing.
inline constexpr double kContactRoom = 1e-12;
[[nodiscard]] TriangleContact contactOf(const TriangleCorners& a, const TriangleCorners& b);

}  // namespace cullscope
