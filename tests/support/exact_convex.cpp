#include "tests/support/exact_convex.h"

#include <cmath>

namespace cullscope::test {
namespace {

Distances between(const Distances& a, const Distances& b, size_t plane) {
    const Quad share = a[plane] / (a[plane] - b[plane]);
    Distances point;
    for (size_t i = 0; i < 6; ++i) point[i] = a[i] + (b[i] - a[i]) * share;
    point[plane] = 0;
    return point;
}

/// Clips a convex polygon, whose points are given by their distances from the planes, to the inside of one plane.
void clip(std::vector<Distances>& polygon, size_t plane) {
    std::vector<Distances> kept;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Distances& here = polygon[i];
        const Distances& next = polygon[(i + 1) % polygon.size()];
        if (here[plane] >= 0) kept.push_back(here);
        if ((here[plane] < 0) != (next[plane] < 0)) kept.push_back(between(here, next, plane));
    }
    polygon = std::move(kept);
}

}  // namespace

Quad root(Quad square) {
    Quad guess = std::sqrt(static_cast<double>(square));
    if (!(guess > 0)) return 0;
    for (int i = 0; i < 3; ++i) guess = (guess + square / guess) / 2;
    return guess;
}

bool reachesInside(const Distances& a, const Distances& b, const Distances& c) {
    for (size_t plane = 0; plane < 6; ++plane)
        if (a[plane] < 0 && b[plane] < 0 && c[plane] < 0) return false;
    std::vector<Distances> polygon{a, b, c};
    for (size_t plane = 0; plane < 6 && !polygon.empty(); ++plane) clip(polygon, plane);
    return !polygon.empty();
}

QuadVector QuadBox::corner(size_t number) const {
    QuadVector corner = centre;
    for (size_t axis = 0; axis < 3; ++axis) corner = plus(corner, scaled(halves[axis], (number >> axis & 1) != 0 ? 1 : -1));
    return corner;
}

bool QuadBox::contains(const QuadVector& point) const {
    const QuadVector from = minus(point, centre);
    for (size_t axis = 0; axis < 3; ++axis) {
        const QuadVector normal = cross(halves[(axis + 1) % 3], halves[(axis + 2) % 3]);
        const Quad along = dot(normal, from), reach = dot(normal, halves[axis]);
        if (reach == 0 || (along < 0 ? -along : along) > (reach < 0 ? -reach : reach)) return false;
    }
    return true;
}

}  // namespace cullscope::test
