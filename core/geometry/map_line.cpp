#include "core/geometry/map_line.h"

#include <cmath>
#include <numbers>

#include "core/geometry/angle.h"
#include "core/geometry/spherical_grid.h"

namespace cullscope {
namespace {

/// The largest distance of neighbouring points on the map, in radians, and how often a piece may be halved to reach it: a line
/// that passes close to a pole changes its azimuth within a very short piece.
constexpr double kStep = std::numbers::pi / 90.0;
constexpr int kHalvings = 12;

/// The angle equal to `phi` up to whole turns that is nearest to `after`.
double continued(double phi, double after) { return phi + kTurn * std::round((after - phi) / kTurn); }

bool isPole(const Vec3& direction) { return std::hypot(direction.x, direction.y) < 1e-12 * glm::length(direction); }

}  // namespace

MapLine::MapLine(const Vec3& start) : m_points{mapAngles(start)} {}

void MapLine::add(Vec2 angles) {
    angles.y = continued(angles.y, m_points.back().y);
    m_points.push_back(angles);
}

void MapLine::follow(const std::function<Vec3(double)>& at, double from, double to) { halve(at, from, to, kHalvings); }

void MapLine::halve(const std::function<Vec3(double)>& at, double from, double to, int halvings) {
    Vec2 end = mapAngles(at(to));
    end.y = continued(end.y, m_points.back().y);
    if (halvings > 0 && glm::length(end - m_points.back()) > kStep) {
        const double middle = 0.5 * (from + to);
        halve(at, from, middle, halvings - 1);
        halve(at, middle, to, halvings - 1);
        return;
    }
    m_points.push_back(end);
}

void MapLine::arc(const Vec3& from, const Vec3& to) {
    const Vec3 a = glm::normalize(from), b = glm::normalize(to);
    if (isPole(a) && isPole(b)) return;
    // A line through a pole consists of meridians.
    if (isPole(a)) {
        const double phi = mapAngles(b).y;
        if (m_points.size() > 1)
            add({m_points.back().x, phi});
        else
            m_points.back().y = phi;
    }
    const auto at = [&](double t) { return glm::mix(a, b, t); };
    if (!isPole(b)) return follow(at, 0.0, 1.0);
    const Vec2 last = m_points.back();
    const double theta = b.z > 0.0 ? 0.0 : std::numbers::pi;
    const int steps = std::max(1, int(std::ceil(std::abs(theta - last.x) / kStep)));
    for (int i = 1; i <= steps; ++i) m_points.emplace_back(last.x + (theta - last.x) * i / steps, last.y);
}

}  // namespace cullscope
