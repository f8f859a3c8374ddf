#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "core/geometry/triangle.h"

namespace cullscope {

/// The boxes of triangles in a tree (Embree): which of them overlap, and which lie along an axis from a point. The triangles must
/// outlive this object; their coordinates are at most 1 in magnitude, and the boxes are kBoxRoom larger on each side, for what
/// Embree's floats round.
class TriangleBoxes {
public:
    static constexpr double kBoxRoom = 0x1p-22;

    explicit TriangleBoxes(std::span<const TriangleCorners> triangles);
    ~TriangleBoxes();
    TriangleBoxes(const TriangleBoxes&) = delete;
    TriangleBoxes& operator=(const TriangleBoxes&) = delete;

    /// Calls `visit` for each pair of triangles whose boxes overlap, the smaller number first, at least once; from several
    /// threads. It must not throw.
    void visitOverlapping(const std::function<void(uint32_t, uint32_t)>& visit) const;
    /// Calls `visit` at least once for each triangle whose box a ray from a point meets: along an axis (0 to 2), in its direction
    /// or against it. It must not throw.
    void visitAlong(const Vec3& from, int axis, bool forward, const std::function<void(uint32_t)>& visit) const;

private:
    struct Tree;
    std::unique_ptr<const Tree> m_tree;
};

}  // namespace cullscope
