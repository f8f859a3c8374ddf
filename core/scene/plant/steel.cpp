#include "core/scene/plant/steel.h"

#include <cmath>

namespace cullscope::plant {
namespace {

using namespace primitive;

/// An I-shaped beam along z, from 0 to its length; its web lies in the plane of z and x.
Solids beam(double length, double depth, double width) {
    constexpr double kFlange = 0.02, kWeb = 0.012;
    const double x = 0.5 * (depth - kFlange), z = 0.5 * length;
    return {box({x, 0, z}, {kFlange, width, length}), box({-x, 0, z}, {kFlange, width, length}),
            box({0, 0, z}, {depth - 2.0 * kFlange, kWeb, length})};
}

void addFrame(Kit& kit, const Vec3& foot) {
    for (const double side : {-kRackHalfWidth, kRackHalfWidth}) {
        const Vec3 own = foot + Vec3(0.0, side, 0.0);
        kit.add({"post"}, 8, frame(own, {0, 0, 1}, {0, 1, 0}), [] { return beam(kTiers.back() + 0.4, 0.3, 0.28); });
        kit.add({"foundation"}, 8, at(own.x, own.y, own.z), [] {
            return Solids{{PyramidFrustum{{1.0, 1.0}, {0.6, 0.6}, 0.4}, at(0, 0, 0.2)}};
        });
    }
    for (const double tier : kTiers)
        kit.add({"beam"}, 8, frame(foot + Vec3(0.0, -kRackHalfWidth, tier - 0.15), {0, 1, 0}, {0, 0, 1}),
                [] { return beam(2.0 * kRackHalfWidth, 0.3, 0.2); });
}

}  // namespace

void addRack(Kit& kit, const Vec3& corner, bool first) {
    const auto bays = int(kUnitLength / kBay);
    for (int bay = 0; bay <= bays; ++bay) {
        const Vec3 foot = corner + Vec3(bay * kBay, 0.0, 0.0);
        if (bay > 0 || first) addFrame(kit, foot);
        if (bay == bays) break;
        for (const double side : {-kRackHalfWidth, kRackHalfWidth})
            for (const double tier : kTiers)
                kit.add({"stringer"}, 8, frame(foot + Vec3(0.0, side, tier - 0.5), {1, 0, 0}, {0, 0, 1}),
                        [] { return beam(kBay, 0.25, 0.18); });
    }
    // The middle bay is braced.
    const Vec3 braced = corner + Vec3(std::floor(0.5 * bays) * kBay, 0.0, 0.0);
    for (const double side : {-kRackHalfWidth, kRackHalfWidth})
        kit.add({"brace"}, 8, at(braced.x, braced.y + side, braced.z), [] {
            const double top = kTiers.front() - 0.6;
            return Solids{rod({0, 0, 0.4}, {kBay, 0, top}, 0.06), rod({kBay, 0, 0.4}, {0, 0, top}, 0.06)};
        });
    kit.add({"lamp"}, 8, at(corner.x, corner.y + kRackHalfWidth, corner.z), [] {
        const double top = kTiers.back() + 2.4;
        return Solids{{Cylinder{0.04, 2.2}, at(0, 0, top - 1.0)},
                      {CircularTorus{0.3, 0.03, Angle::fromDegrees(90)}, frame({0, 0.3, top + 0.1}, {1, 0, 0}, {0, -1, 0})},
                      {Cone{0.2, 0.06, 0.15}, at(0, 0.45, top + 0.4)}};
    });
    kit.add({"ground"}, 8, at(corner.x + 0.5 * kUnitLength, corner.y, corner.z), [] {
        return Solids{box({0, 0, -0.1}, {kUnitLength, 30.0, 0.2})};
    });
}

}  // namespace cullscope::plant
