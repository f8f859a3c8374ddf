#pragma once

#include <compare>
#include <numbers>

namespace cullscope {

// In radians.
inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2.0 * std::numbers::pi;
inline constexpr double kRightAngle = 0.5 * std::numbers::pi;

/// An angle as a type of its own, so that degrees and radians cannot be confused.
class Angle {
public:
    constexpr Angle() = default;
    [[nodiscard]] static constexpr Angle fromRadians(double radians) { return Angle(radians); }
    [[nodiscard]] static constexpr Angle fromDegrees(double degrees) { return Angle(degrees * std::numbers::pi / 180.0); }

    [[nodiscard]] constexpr double radians() const { return m_radians; }
    [[nodiscard]] constexpr double degrees() const { return m_radians * 180.0 / std::numbers::pi; }

    constexpr auto operator<=>(const Angle&) const = default;
    [[nodiscard]] constexpr Angle operator*(double factor) const { return Angle(m_radians * factor); }
    [[nodiscard]] constexpr Angle operator/(double divisor) const { return Angle(m_radians / divisor); }
    [[nodiscard]] constexpr Angle operator+(Angle other) const { return Angle(m_radians + other.m_radians); }
    [[nodiscard]] constexpr Angle operator-(Angle other) const { return Angle(m_radians - other.m_radians); }

private:
    constexpr explicit Angle(double radians) : m_radians(radians) {}
    double m_radians = 0.0;
};

}  // namespace cullscope
