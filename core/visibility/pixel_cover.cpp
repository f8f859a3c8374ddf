#include "core/visibility/pixel_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/visibility/eye_bounds.h"

namespace cullscope {
namespace {

struct Interval {
    double least = std::numeric_limits<double>::infinity(), most = -std::numeric_limits<double>::infinity();

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

/// The number of pixel centres, at k + ½ for k from 0 to size − 1, in an interval.
uint64_t centresIn(const Interval& interval, int size) {
    const double first = std::max(std::ceil(interval.least - 0.5), 0.0);
    const double last = std::min(std::floor(interval.most - 0.5), double(size - 1));
    return last < first ? 0 : uint64_t(last - first) + 1;
}

}  // namespace

PixelCover::PixelCover(const View& view)
    : m_frustum(view.frustum()),
      m_size(view.viewport()),
      m_pixels(std::max(m_size.width / (2.0 * m_frustum.halfWidthAt(1.0)), m_size.height / (2.0 * m_frustum.halfHeightAt(1.0)))),
      // A vertex is displaced by up to 2^-21 of its distance (geometry/frustum.h, conservativeMargin), which at the picture's
      // corner is more than the distance ahead and moves it by more than that, and then snapped to 2^-8 of a pixel.
      m_room(m_pixels * 0x1p-20 *
                 (1.0 + m_frustum.tanHalfWidth * m_frustum.tanHalfWidth + m_frustum.tanHalfHeight * m_frustum.tanHalfHeight) +
             0x1p-7) {}

double PixelCover::roomFor(const EyeBox& box) const {
    // The displacement is relative to the distance; in a parallel view the size on the screen is not.
    if (m_frustum.parallel()) return m_pixels * 0x1p-20 * (glm::length(box.centre) + glm::length(box.halfExtent)) + 0x1p-7;
    return m_room;
}

uint64_t PixelCover::of(const EyeBox& box) const {
    const uint64_t all = uint64_t(m_size.width) * uint64_t(m_size.height);
    // Of a box that reaches to the eye's plane the projection has no bounds. NaN is not above 0.
    if (!(nearestAhead(box, m_frustum) > 0.0)) return all;
    Interval x, y;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 at =
            box.centre +
            Vec3((corner & 1) != 0 ? 1.0 : -1.0, (corner & 2) != 0 ? 1.0 : -1.0, (corner & 4) != 0 ? 1.0 : -1.0) * box.halfExtent;
        const double ahead = glm::dot(m_frustum.forward, at);
        if (!(ahead > 0.0)) return all;
        x.add((glm::dot(m_frustum.right, at) / m_frustum.halfWidthAt(ahead) + 1.0) * 0.5 * m_size.width);
        y.add((glm::dot(m_frustum.up, at) / m_frustum.halfHeightAt(ahead) + 1.0) * 0.5 * m_size.height);
    }
    const double room = roomFor(box);
    for (Interval* interval : {&x, &y}) {
        interval->least -= room;
        interval->most += room;
    }
    return centresIn(x, m_size.width) * centresIn(y, m_size.height);
}

}  // namespace cullscope
