#include "core/scene/frustum_share.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include "core/scene/eye_triangle.h"

namespace cullscope {
namespace {

/// A convex polygon during clipping: a triangle gets at most one more corner at each plane.
struct Polygon {
    std::array<Vec3, 9> corners{};
    size_t count = 0;

    void add(const Vec3& corner) { corners[count++] = corner; }
};

/// Clips against one plane (Sutherland & Hodgman 1974); points on the plane are kept.
Polygon clipped(const Polygon& polygon, const Plane& plane) {
    Polygon result;
    for (size_t i = 0; i < polygon.count; ++i) {
        const Vec3 &from = polygon.corners[i], &to = polygon.corners[(i + 1) % polygon.count];
        const double a = plane.distance(from), b = plane.distance(to);
        if (a >= 0.0) result.add(from);
        if ((a < 0.0) != (b < 0.0) && a != 0.0 && b != 0.0) result.add(from + (a / (a - b)) * (to - from));
    }
    return result;
}

bool touches(const Frustum& frustum, const std::array<Vec3, 3>& corners) {
    Polygon polygon{{corners[0], corners[1], corners[2]}, 3};
    for (const Plane& plane : frustum.planes) {
        size_t inside = 0;
        for (size_t i = 0; i < polygon.count; ++i) inside += plane.distance(polygon.corners[i]) >= 0.0 ? 1 : 0;
        if (inside == 0) return false;
        if (inside < polygon.count) polygon = clipped(polygon, plane);
    }
    return polygon.count > 0;
}

}  // namespace

uint64_t trianglesInFrustum(const Scene& scene, const View& view, uint64_t step) {
    uint64_t found = 0;
    for (uint32_t i = 0; i < scene.instances().size(); ++i) {
        const InstanceFromEye instance(scene, i, view.eye());
        const uint64_t first = scene.firstTriangle(i), count = scene.meshOf(i).triangleCount();
        // Every step-th triangle by scene number is tested, so that small objects are not all tested in full.
        const uint64_t begin = (first + step - 1) / step, end = (first + count + step - 1) / step;
        found += tbb::parallel_reduce(
            tbb::blocked_range<uint64_t>(begin, end, 1024), uint64_t{0},
            [&](const auto& block, uint64_t number) {
                for (uint64_t k = block.begin(); k < block.end(); ++k)
                    number += touches(view.frustum(), instance.corners(k * step - first)) ? 1 : 0;
                return number;
            },
            std::plus<>());
    }
    return found;
}

}  // namespace cullscope
