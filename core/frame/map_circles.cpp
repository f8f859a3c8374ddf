#include "core/frame/map_circles.h"

#include "core/geometry/angle.h"
#include "core/geometry/map_line.h"
#include "core/geometry/spherical_grid.h"

namespace cullscope {
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

std::vector<Vec2> circleOnMap(const MapCircles& circles, double alpha) {
    const auto at = [&](double beta) { return circles.direction(alpha, beta); };
    MapLine line(at(0.0));
    for (int i = 0; i < kFirstPieces; ++i) line.follow(at, kTurn * i / kFirstPieces, kTurn * (i + 1) / kFirstPieces);
    return std::move(line).take();
}

std::vector<CutCircle> cutCircles(const MapCircles& circles) {
    std::vector<CutCircle> result;
    for (uint32_t band = 1; band < circles.bands; ++band) {
        const double alpha = band * circles.width;
        result.push_back({alpha, cutAtSeam(circleOnMap(circles, alpha))});
    }
    return result;
}

std::vector<std::vector<Vec2>> meridianOnMap(const MapCircles& circles, double beta) {
    constexpr int kSteps = 180;
    std::vector<std::vector<Vec2>> lines(1);
    for (int step = 0; step <= kSteps; ++step) {
        Vec2 point = mapAngles(circles.direction(step * std::numbers::pi / kSteps, beta));
        if (!lines.back().empty()) {
            const double before = lines.back().back().y;
            point.y += std::round((before - point.y) / kTurn) * kTurn;
            // φ jumps at a pole: begin a new line.
            if (std::abs(point.y - before) > kTurn / 4) lines.emplace_back();
        }
        lines.back().push_back(point);
    }
    return lines;
}

}  // namespace cullscope
