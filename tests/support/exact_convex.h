#pragma once

#include <array>
#include <vector>

#include "core/geometry/types.h"

// Exact tests of a convex region of six half-spaces, sharing no code with the library. __float128 has 113 bits of mantissa: a sum
// whose terms are within a factor of 2^38 has an error of at most 2^-75 of them.

namespace cullscope::test {

__extension__ typedef __float128 Quad;

using QuadVector = std::array<Quad, 3>;

inline Quad dot(const QuadVector& a, const QuadVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline QuadVector cross(const QuadVector& a, const QuadVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline QuadVector scaled(const QuadVector& a, Quad by) { return {a[0] * by, a[1] * by, a[2] * by}; }
inline QuadVector plus(const QuadVector& a, const QuadVector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline QuadVector minus(const QuadVector& a, const QuadVector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline QuadVector quad(const Vec3& v) { return {v.x, v.y, v.z}; }

/// Newton's iteration from the square root in double: 53, 106, 212 correct bits.
[[nodiscard]] Quad root(Quad square);

/// Signed distances of one point from the six planes (of any scale: one scale for each plane), positive inside.
using Distances = std::array<Quad, 6>;

[[nodiscard]] inline bool inside(const Distances& distances) {
    for (const Quad distance : distances)
        if (distance < 0) return false;
    return true;
}

/// Whether a point of a triangle lies in the closed region.
[[nodiscard]] bool reachesInside(const Distances& a, const Distances& b, const Distances& c);

/// A parallelepiped: centre ± three half edges.
struct QuadBox {
    QuadVector centre;
    std::array<QuadVector, 3> halves;

    /// Bit i of the number is the sign of half edge i.
    [[nodiscard]] QuadVector corner(size_t number) const;
    /// False for a flat box.
    [[nodiscard]] bool contains(const QuadVector& point) const;
};

/// Whether a box intersects the region: `distances` returns those of any point, `within` is some point of the region.
template <typename DistancesOf>
[[nodiscard]] bool meets(const QuadBox& box, const DistancesOf& distances, const QuadVector& within) {
    std::array<Distances, 8> corners;
    for (size_t i = 0; i < 8; ++i) {
        corners[i] = distances(box.corner(i));
        if (inside(corners[i])) return true;
    }
    constexpr size_t kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    for (const auto& face : kFaces)
        if (reachesInside(corners[face[0]], corners[face[1]], corners[face[2]]) ||
            reachesInside(corners[face[0]], corners[face[2]], corners[face[3]]))
            return true;
    // No face of the box intersects the region: the region lies inside the box, or they are separate.
    return box.contains(within);
}

}  // namespace cullscope::test
