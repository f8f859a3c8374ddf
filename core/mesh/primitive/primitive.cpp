#include "core/mesh/primitive/primitive.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/mesh/primitive/turn.h"

namespace cullscope::primitive {
namespace {

constexpr std::array<const char*, kKinds> kNames{CULLSCOPE_TR("sphere"),
                                                 CULLSCOPE_TR("cylinder"),
                                                 CULLSCOPE_TR("cone"),
                                                 CULLSCOPE_TR("eccentric cone"),
                                                 CULLSCOPE_TR("mitred cylinder"),
                                                 CULLSCOPE_TR("circular torus"),
                                                 CULLSCOPE_TR("rectangular torus"),
                                                 CULLSCOPE_TR("ellipsoidal dish"),
                                                 CULLSCOPE_TR("spherical dish"),
                                                 CULLSCOPE_TR("torispherical head"),
                                                 CULLSCOPE_TR("box"),
                                                 CULLSCOPE_TR("wedge"),
                                                 CULLSCOPE_TR("pyramid"),
                                                 CULLSCOPE_TR("frustum of a pyramid"),
                                                 CULLSCOPE_TR("prism"),
                                                 CULLSCOPE_TR("disc"),
                                                 CULLSCOPE_TR("ring"),
                                                 CULLSCOPE_TR("hollow cylinder")};

using Refusal = std::optional<const char*>;

constexpr const char* kNoPoint = CULLSCOPE_TR("%1: of these sizes it has no surface, but is a point or a line.");

/// Lengths whose cubes stay within the range of double.
bool lengths(std::initializer_list<double> values) {
    return std::ranges::all_of(values, [](double value) { return value >= 0.0 && value <= 1e30; });
}

bool numbers(std::initializer_list<double> values) {
    return std::ranges::all_of(values, [](double value) { return std::abs(value) <= 1e30; });
}

constexpr const char* kLengths = CULLSCOPE_TR("%1: its lengths are numbers from 0 to 1e30.");
constexpr const char* kSweep = CULLSCOPE_TR("%1: its angle is more than 0 and at most 360 degrees.");
constexpr const char* kHole = CULLSCOPE_TR("%1: its inner radius is smaller than its outer one.");

Refusal sweepRefusal(Angle sweep) {
    // One part in 10^6 of room: files keep angles in single precision.
    return sweep.radians() > 0.0 && sweep.radians() <= kTurn * (1.0 + 1e-6) ? Refusal() : Refusal(kSweep);
}

/// At least two of three extents make a surface.
Refusal surfaceRefusal(double a, double b, double c) {
    return int(a > 0.0) + int(b > 0.0) + int(c > 0.0) >= 2 ? Refusal() : Refusal(kNoPoint);
}

Refusal refusalOf(const Sphere& s) {
    if (!lengths({s.radius})) return kLengths;
    return s.radius > 0.0 ? Refusal() : kNoPoint;
}
Refusal refusalOf(const Cylinder& s) {
    if (!lengths({s.radius, s.height})) return kLengths;
    return s.radius > 0.0 ? Refusal() : kNoPoint;
}
Refusal refusalOf(const Cone& s) {
    if (!lengths({s.bottomRadius, s.topRadius, s.height})) return kLengths;
    return s.bottomRadius > 0.0 || s.topRadius > 0.0 ? Refusal() : kNoPoint;
}
Refusal refusalOf(const EccentricCone& s) {
    if (!lengths({s.bottomRadius, s.topRadius, s.height}) || !numbers({s.offset.x, s.offset.y})) return kLengths;
    if (s.bottomRadius == 0.0 && s.topRadius == 0.0) return kNoPoint;
    for (const double angle : {s.bottom.x.radians(), s.bottom.y.radians(), s.top.x.radians(), s.top.y.radians()})
        if (!(std::abs(angle) < 0.999 * kRightAngle)) return CULLSCOPE_TR("%1: its ends are cut at less than 90 degrees.");
    // The wall's height at an angle is height + (topRadius · top − bottomRadius · bottom) along that direction.
    if (s.height < glm::length(s.topRadius * slopes(s.top) - s.bottomRadius * slopes(s.bottom)) * (1.0 - 1e-6))
        return CULLSCOPE_TR("%1: its slanted ends do not cut each other. Make it longer or cut it less.");
    return {};
}
Refusal refusalOf(const MitredCylinder& s) { return refusalOf(asEccentricCone(s)); }
Refusal refusalOf(const CircularTorus& s) {
    if (!lengths({s.ringRadius, s.tubeRadius})) return kLengths;
    if (s.tubeRadius == 0.0) return kNoPoint;
    if (s.tubeRadius > s.ringRadius) return CULLSCOPE_TR("%1: its tube is no thicker than its ring allows.");
    return sweepRefusal(s.sweep);
}
Refusal refusalOf(const RectangularTorus& s) {
    if (!lengths({s.innerRadius, s.outerRadius, s.height})) return kLengths;
    if (s.outerRadius == 0.0) return kNoPoint;
    if (s.innerRadius >= s.outerRadius) return kHole;
    return sweepRefusal(s.sweep);
}
Refusal refusalOf(const EllipsoidalDish& s) { return refusalOf(Cylinder{s.radius, s.height}); }
Refusal refusalOf(const SphericalDish& s) { return refusalOf(Cylinder{s.radius, s.height}); }
Refusal refusalOf(const TorisphericalHead& s) {
    if (!lengths({s.radius, s.crownRadius, s.knuckleRadius})) return kLengths;
    if (s.radius == 0.0) return kNoPoint;
    if (s.crownRadius < s.radius || s.knuckleRadius > s.radius)
        return CULLSCOPE_TR("%1: its crown is at least as wide as its vessel, and its knuckle at most.");
    return {};
}
Refusal refusalOf(const Box& s) {
    if (!lengths({s.size.x, s.size.y, s.size.z})) return kLengths;
    return surfaceRefusal(s.size.x, s.size.y, s.size.z);
}
Refusal refusalOf(const Wedge& s) { return refusalOf(Box{s.size}); }
Refusal refusalOf(const PyramidFrustum& s) {
    if (!lengths({s.bottom.x, s.bottom.y, s.top.x, s.top.y, s.height}) || !numbers({s.offset.x, s.offset.y})) return kLengths;
    return surfaceRefusal(std::max(s.bottom.x, s.top.x), std::max(s.bottom.y, s.top.y), s.height);
}
Refusal refusalOf(const Pyramid& s) { return refusalOf(PyramidFrustum{s.base, Vec2(0.0), s.height, s.apexOffset}); }
Refusal refusalOf(const Prism& s) {
    if (s.sides < 3 || s.sides > 1000) return CULLSCOPE_TR("%1: it has 3 to 1000 sides.");
    return refusalOf(Cylinder{s.radius, s.height});
}
Refusal refusalOf(const Disc& s) { return refusalOf(Sphere{s.radius}); }
Refusal refusalOf(const HollowCylinder& s) { return refusalOf(RectangularTorus{s.innerRadius, s.outerRadius, s.height}); }
Refusal refusalOf(const Ring& s) { return refusalOf(HollowCylinder{s.innerRadius, s.outerRadius, 0.0}); }

}  // namespace

const char* kindName(size_t kind) {
    assert(kind < kKinds);
    return kNames[kind];
}

std::optional<Message> whyImpossible(const Primitive& primitive) {
    const Refusal refusal = std::visit([](const auto& solid) { return refusalOf(solid); }, primitive);
    if (!refusal) return std::nullopt;
    return Message{*refusal, {kindName(primitive.index())}};
}

EccentricCone asEccentricCone(const MitredCylinder& cylinder) {
    return {cylinder.radius, cylinder.radius, cylinder.height, Vec2(0.0), cylinder.bottom, cylinder.top};
}

bool isWholeTurn(Angle sweep) { return sweep.radians() >= kTurn * (1.0 - 1e-6); }

Vec2 slopes(const Mitre& mitre) {
    const auto tangent = [](Angle angle) {
        const Vec2 point = onCircle(angle);
        return point.y / point.x;
    };
    return {tangent(mitre.x), tangent(mitre.y)};
}

Crown crownOf(const TorisphericalHead& head) {
    const double fromCrown = head.crownRadius - head.knuckleRadius, across = head.radius - head.knuckleRadius;
    if (!(fromCrown > 0.0)) return {{1.0, 0.0}, 0.0};  // crown, knuckle and vessel of one radius: half a sphere
    const double sine = std::min(1.0, across / fromCrown);
    const double cosine = std::sqrt(std::max(0.0, 1.0 - sine * sine));
    return {{sine, cosine}, -fromCrown * cosine};
}

double torisphericalHeight(const TorisphericalHead& head) { return crownOf(head).centre + head.crownRadius; }

}  // namespace cullscope::primitive
