#pragma once

#include <vector>

namespace cullscope {

/// Keeps of a convex polygon what lies where `inside`, linear in the points, is not negative (Sutherland & Hodgman 1974).
/// `buffer` is scratch space.
template <typename Point, typename Inside>
void clipPolygon(std::vector<Point>& polygon, std::vector<Point>& buffer, const Inside& inside) {
    buffer.clear();
    for (size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double atA = inside(a), atB = inside(b);
        if (atA >= 0.0) buffer.push_back(a);
        if ((atA < 0.0 && atB > 0.0) || (atA > 0.0 && atB < 0.0)) buffer.push_back(a + (b - a) * (atA / (atA - atB)));
    }
    polygon.swap(buffer);
}

}  // namespace cullscope
