#include "core/mesh/primitive/turn.h"

#include <cassert>
#include <cmath>
#include <utility>

namespace cullscope::primitive {
namespace {

/// (cos, sin) of an angle of 0 to 45° in radians, by their power series; the first term left out is below 1e-17.
Vec2 ofOctant(double angle) {
    const double square = angle * angle;
    double cosine = 1.0, sine = 1.0;
    for (int n = 16; n >= 2; n -= 2) {
        cosine = 1.0 - square / double((n - 1) * n) * cosine;
        sine = 1.0 - square / double(n * (n + 1)) * sine;
    }
    return {cosine, angle * sine};
}

/// A point of the first quarter turned by quarter turns.
Vec2 inQuarter(uint64_t quarter, const Vec2& point) {
    switch (quarter % 4) {
        case 0:
            return point;
        case 1:
            return {-point.y, point.x};
        case 2:
            return {-point.x, -point.y};
        default:
            return {point.y, -point.x};
    }
}

}  // namespace

Vec2 onCircle(uint64_t index, uint64_t count) {
    assert(count > 0 && count < (uint64_t{1} << 50));
    // Eighths of parts, so that quarters and eighths of the turn are whole numbers.
    const uint64_t turn = 8 * count, quarter = turn / 4;
    const uint64_t place = 8 * (index % count);
    const uint64_t within = place % quarter;
    const bool lowerHalf = 2 * within <= quarter;
    const uint64_t fromAxis = lowerHalf ? within : quarter - within;
    const Vec2 point = 2 * within == quarter ? Vec2(std::sqrt(0.5)) : ofOctant(kTurn * double(fromAxis) / double(turn));
    return inQuarter(place / quarter, lowerHalf ? point : Vec2(point.y, point.x)) + 0.0;  // no negative zeros
}

Vec2 onCircle(Angle angle) {
    const double quarters = std::nearbyint(angle.radians() / kRightAngle);
    const double rest = angle.radians() - quarters * kRightAngle;  // −45° to 45°
    const Vec2 point = ofOctant(std::abs(rest));
    const auto quarter = static_cast<uint64_t>(static_cast<int64_t>(quarters) & 3);
    return inQuarter(quarter, {point.x, rest < 0.0 ? -point.y : point.y}) + 0.0;
}

std::vector<Vec2> arcBetween(const Vec2& from, const Vec2& to, Angle largest) {
    const double wanted = onCircle(largest).x;
    std::vector<Vec2> arc{from, to};
    constexpr size_t kMostParts = 1024;
    while (glm::dot(arc[0], arc[1]) < wanted && arc.size() <= kMostParts) {
        std::vector<Vec2> halved;
        for (size_t i = 0; i + 1 < arc.size(); ++i) {
            halved.push_back(arc[i]);
            halved.push_back(glm::normalize(arc[i] + arc[i + 1]));
        }
        halved.push_back(arc.back());
        arc = std::move(halved);
    }
    return arc;
}

}  // namespace cullscope::primitive
