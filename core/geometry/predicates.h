#pragma once

#include "core/geometry/types.h"

namespace cullscope {

/// On which side of the plane through a, b and c a point lies: 1 in front, from where a, b, c turn counter-clockwise; −1 behind;
/// 0 in the plane. Exact for the doubles as they are (Shewchuk 1997): a filter in double decides nearly always, else the
/// determinant is summed without rounding. Coordinates are finite, and 0 or between 1e-70 and 1e90 in magnitude.
[[nodiscard]] int sideOfPlane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point);

/// The same for a point that was rounded: 0 also where it lies so near to the plane that a few roundings of its coordinates could
/// put it on the other side.
[[nodiscard]] int clearSideOfPlane(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& point);

/// The turn from a over b to c in the plane: 1 counter-clockwise, −1 clockwise, 0 on one line. Exact, as above.
[[nodiscard]] int turnOf(const Vec2& a, const Vec2& b, const Vec2& c);

/// Whether three points lie on one line, or coincide. Exact, as above.
[[nodiscard]] bool onOneLine(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace cullscope
