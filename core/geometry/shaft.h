#pragma once

#include <array>
#include <cstddef>

#include "core/geometry/bounds.h"

namespace cullscope {

/// The convex hull of two boxes: all lines of sight from a point of one to a point of the other lie in it (shafts: Haines &
/// Wallace 1991). A facet of it is parallel to an axis at least: for a normal without a zero component both boxes have only a
/// corner farthest out, and two corners make no facet. So it is what the hulls of the boxes' outlines along x, y and z have in
/// common.
class Shaft {
public:
    Shaft(const Box3& from, const Box3& to);

    /// False only where the segment has no point in the shaft; by its rounding, a segment that passes by may count as meeting it.
    [[nodiscard]] bool mayMeet(const Vec3& a, const Vec3& b) const;

private:
    struct Side {
        Vec3 normal;  ///< outward
        double offset = 0.0;
    };
    void add(const Vec3& normal, const Vec3& on);

    Vec3 m_origin;
    double m_slack = 0.0;
    std::array<Side, 18> m_sides;  ///< six of the box around both, and at most four for each pair of axes
    size_t m_count = 0;
};

}  // namespace cullscope
