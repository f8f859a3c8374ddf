#pragma once

#include <cstdint>
#include <vector>

#include "core/geometry/angle.h"
#include "core/geometry/types.h"

namespace cullscope::primitive {

/// (cos, sin) of `index` of `count` equal parts of a turn. Unlike the C library's functions it gives the same bits on every
/// machine with IEEE arithmetic, is exact at quarter turns, and its values have the symmetries of the circle bit by bit. The
/// error is below 2e-16. `count` > 0.
[[nodiscard]] Vec2 onCircle(uint64_t index, uint64_t count);

/// (cos, sin) of an angle, by the same means: the same bits on every machine; exact at multiples of the double nearest to a
/// right angle. For |angle| up to a few turns, with an error below 1e-15.
[[nodiscard]] Vec2 onCircle(Angle angle);

/// Unit vectors from `from` to `to`, both unit vectors less than 180° apart: so many equal angles between them, a power of two,
/// that each is at most `largest`. By square roots alone, for the same reason.
[[nodiscard]] std::vector<Vec2> arcBetween(const Vec2& from, const Vec2& to, Angle largest);

}  // namespace cullscope::primitive
