#pragma once

#include "core/scene/plant/kit.h"

namespace cullscope::plant {

/// Where a pipeline ends at an item of equipment.
struct Nozzle {
    Vec3 face{0.0};
    Vec3 out{0.0};  ///< up, or level towards the pipe rack
};

/// Items of equipment stand in a row beside a pipe rack that leads along x. They take some places of kNozzlePitch along the rack
/// and have a nozzle at the middle of each.
inline constexpr double kNozzlePitch = 1.5;

struct EquipmentKind {
    const char* letter;  ///< of its name
    uint32_t places;
    uint32_t chance;  ///< relative to the others
    /// `origin`: on the ground at the begin of its places, `inward` from its middle line to the rack (+1 or −1 along y). Adds its
    /// objects to the group in hand and its nozzles' faces to `nozzles`.
    void (*build)(Kit& kit, Random& random, const Vec3& origin, double inward, std::vector<Nozzle>& nozzles);
};
[[nodiscard]] const std::vector<EquipmentKind>& equipmentKinds();

/// Parts that several items have. A ring is about z, seen from its axis open over a quarter; the places are of the floor.
void addRingPlatform(Kit& kit, const Mat4& place, double inner, double outer);
void addLadder(Kit& kit, const Mat4& foot, double height);

}  // namespace cullscope::plant
