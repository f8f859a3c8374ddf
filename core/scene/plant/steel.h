#pragma once

#include <array>

#include "core/scene/plant/kit.h"

namespace cullscope::plant {

/// A unit is a length of a pipe rack with the equipment on both sides of it.
inline constexpr double kUnitLength = 30.0;
inline constexpr uint32_t kPlacesOfRow = 20;

inline constexpr double kRackHalfWidth = 4.0;
/// The tops of the beams on which pipes lie.
inline constexpr std::array<double, 3> kTiers{4.6, 6.6, 8.6};
/// Between the rack's frames, the first of which stands at the unit's corner.
inline constexpr double kBay = 6.0;

/// A unit's rack, from x = `corner`.x, about y = `corner`.y: frames, beams, bracing, foundations, lamps and the ground. `first`:
/// with the frame at its begin, which else is the last one of the unit before.
void addRack(Kit& kit, const Vec3& corner, bool first);

}  // namespace cullscope::plant
