// The borders between contour bands as curves on the map.

#include <cmath>
#include <numbers>

#include "core/measure/map_picture.h"

namespace cullscope {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
/// How far apart two neighbouring points of a curve may lie on the map, radians, and how often a piece is halved for that: a
/// curve that passes close to a pole turns there within a hair's breadth.
constexpr double kStep = std::numbers::pi / 90.0;
constexpr int kHalvings = 12;
constexpr int kFirstPieces = 120;

/// Nearest to another azimuth by whole turns.
double continued(double phi, double after) { return phi + kTurn * std::round((after - phi) / kTurn); }

class Curve {
public:
    Curve(const ContourBands& bands, double alpha) : m_bands(bands), m_alpha(alpha) {
        m_points.push_back(at(0.0));
        for (int i = 0; i < kFirstPieces; ++i) add(kTurn * i / kFirstPieces, kTurn * (i + 1) / kFirstPieces, kHalvings);
    }

    /// (θ, φ) with φ continued over the seam.
    [[nodiscard]] const std::vector<Vec2>& points() const { return m_points; }

private:
    [[nodiscard]] Vec2 at(double beta) const { return mapAngles(m_bands.direction(m_alpha, beta)); }

    /// The piece up to the azimuth `to`, whose beginning is the last point.
    void add(double from, double to, int halvings) {
        Vec2 end = at(to);
        end.y = continued(end.y, m_points.back().y);
        if (halvings > 0 && glm::length(end - m_points.back()) > kStep) {
            const double middle = 0.5 * (from + to);
            add(from, middle, halvings - 1);
            add(middle, to, halvings - 1);
            return;
        }
        m_points.push_back(end);
    }

    const ContourBands& m_bands;
    double m_alpha;
    std::vector<Vec2> m_points;
};

/// Cuts a curve where it goes over the seam, and puts every piece between 0 and 2π.
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

std::vector<Vec2> contour(const ContourBands& bands, double alpha) { return Curve(bands, alpha).points(); }

std::vector<Contour> contours(const ContourBands& bands) {
    std::vector<Contour> result;
    for (uint32_t band = 1; band < bands.bands; ++band) {
        const double alpha = band * bands.width;
        result.push_back({alpha, cutAtSeam(contour(bands, alpha))});
    }
    return result;
}

}  // namespace cullscope
