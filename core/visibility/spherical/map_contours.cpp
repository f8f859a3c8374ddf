// The borders of the contour bands as curves on the map.

#include <cmath>

#include "core/geometry/angle.h"
#include "core/visibility/spherical/map_line.h"
#include "core/visibility/spherical/map_picture.h"

namespace cullscope::spherical {
namespace {

constexpr int kFirstPieces = 120;

/// Cuts a curve where it crosses the seam, and shifts every piece into 0 … 2π.
std::vector<std::vector<Vec2>> cutAtSeam(const std::vector<Vec2>& points) {
    const auto turnOf = [](double phi) { return std::floor(phi / kTurn); };
    const auto back = [](const Vec2& point, double turn) { return Vec2(point.x, point.y - turn * kTurn); };
    double turn = turnOf(points.front().y);
    std::vector<std::vector<Vec2>> lines{{back(points.front(), turn)}};
    for (size_t i = 1; i < points.size(); ++i) {
        const double next = turnOf(points[i].y);
        if (next != turn) {
            const double seam = kTurn * std::max(turn, next);
            const double share = (seam - points[i - 1].y) / (points[i].y - points[i - 1].y);
            const Vec2 cut(points[i - 1].x + share * (points[i].x - points[i - 1].x), seam);
            lines.back().push_back(back(cut, turn));
            lines.push_back({back(cut, next)});
            turn = next;
        }
        lines.back().push_back(back(points[i], turn));
    }
    return lines;
}

}  // namespace

Vec2 mapAngles(const Vec3& direction) {
    const SphericalPoint point = sphericalPoint(direction);
    return {point.theta, point.phi};
}

std::vector<Vec2> contour(const ContourBands& bands, double alpha) {
    const auto at = [&](double beta) { return bands.direction(alpha, beta); };
    MapLine line(at(0.0));
    for (int i = 0; i < kFirstPieces; ++i) line.follow(at, kTurn * i / kFirstPieces, kTurn * (i + 1) / kFirstPieces);
    return std::move(line).take();
}

std::vector<Contour> contours(const ContourBands& bands) {
    std::vector<Contour> result;
    for (uint32_t band = 1; band < bands.bands; ++band) {
        const double alpha = band * bands.width;
        result.push_back({alpha, cutAtSeam(contour(bands, alpha))});
    }
    return result;
}

}  // namespace cullscope::spherical
