// Volumes, areas and boxes of the exact solids. Where a formula is not a textbook's, its derivation stands beside it.
#include <algorithm>
#include <cmath>

#include "core/mesh/primitive/primitive.h"
#include "core/mesh/primitive/turn.h"

namespace cullscope::primitive {
namespace {

double square(double value) { return value * value; }

/// By the divergence theorem, V = ∮ z dx dy over the closed surface. The caps give height/2 · π r² each, as the slanted parts
/// are odd about the centres. The wall's points are (1 − t) of the bottom's and t of the top's at the same angle, so that
/// dx dy = −r (offset·u + Δr) dθ dt with u = (cos θ, sin θ); the integral over θ leaves the two terms below.
double coneVolume(const EccentricCone& s) {
    const double b = s.bottomRadius, t = s.topRadius;
    const double upright = kPi * s.height / 3.0 * (b * b + b * t + t * t);
    const double slanted =
        b * (2.0 * b + t) * glm::dot(slopes(s.bottom), s.offset) + t * (b + 2.0 * t) * glm::dot(slopes(s.top), s.offset);
    return upright - kPi / 6.0 * slanted;
}

double volumeOf(const Sphere& s) { return 4.0 / 3.0 * kPi * s.radius * s.radius * s.radius; }
double volumeOf(const EccentricCone& s) { return coneVolume(s); }
double volumeOf(const MitredCylinder& s) { return kPi * s.radius * s.radius * s.height; }
double volumeOf(const Cylinder& s) { return kPi * s.radius * s.radius * s.height; }
double volumeOf(const Cone& s) { return coneVolume({s.bottomRadius, s.topRadius, s.height}); }
double volumeOf(const CircularTorus& s) { return kPi * square(s.tubeRadius) * s.ringRadius * s.sweep.radians(); }
double volumeOf(const RectangularTorus& s) {
    return 0.5 * (square(s.outerRadius) - square(s.innerRadius)) * s.sweep.radians() * s.height;
}
double volumeOf(const EllipsoidalDish& s) { return 2.0 / 3.0 * kPi * s.radius * s.radius * s.height; }
double volumeOf(const SphericalDish& s) { return kPi / 6.0 * s.height * (3.0 * square(s.radius) + square(s.height)); }
/// The knuckle's ∫ π (across + k cos a)² k cos a da up to 90° less the crown's half angle, and the crown's cap.
double volumeOf(const TorisphericalHead& s) {
    const Crown crown = crownOf(s);
    const double k = s.knuckleRadius, across = s.radius - k;
    const double sine = crown.edge.y, cosine = crown.edge.x, angle = std::atan2(sine, cosine);
    const double knuckle =
        kPi * k * (across * across * sine + across * k * (angle + sine * cosine) + k * k * (sine - sine * sine * sine / 3.0));
    const double rise = s.crownRadius * (1.0 - crown.edge.y);
    return knuckle + kPi / 3.0 * rise * rise * (3.0 * s.crownRadius - rise);
}
double volumeOf(const Box& s) { return s.size.x * s.size.y * s.size.z; }
double volumeOf(const Wedge& s) { return 0.5 * s.size.x * s.size.y * s.size.z; }
double volumeOf(const PyramidFrustum& s) {
    const Vec2 twiceMiddle = s.bottom + s.top;
    return s.height / 6.0 * (s.bottom.x * s.bottom.y + twiceMiddle.x * twiceMiddle.y + s.top.x * s.top.y);
}
double volumeOf(const Pyramid& s) { return s.base.x * s.base.y * s.height / 3.0; }
double volumeOf(const Prism& s) { return 0.5 * s.sides * square(s.radius) * onCircle(1, s.sides).y * s.height; }
double volumeOf(const Disc&) { return 0.0; }
double volumeOf(const Ring&) { return 0.0; }
double volumeOf(const HollowCylinder& s) { return kPi * (square(s.outerRadius) - square(s.innerRadius)) * s.height; }

/// The wall's area, by Gauss's rule of 8 points across (the integrand is smooth) and the trapezoidal rule around.
double wallArea(const EccentricCone& s) {
    constexpr size_t kAround = 4096, kAcross = 8;
    constexpr std::array<double, 4> kNodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    constexpr std::array<double, 4> kWeights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    const Vec2 bottom = slopes(s.bottom), top = slopes(s.top);
    double sum = 0.0;
    for (size_t i = 0; i < kAround; ++i) {
        const Vec2 u = onCircle(i, kAround), along(-u.y, u.x);
        const Vec3 rise(s.offset + (s.topRadius - s.bottomRadius) * u,
                        s.height + s.topRadius * glm::dot(top, u) - s.bottomRadius * glm::dot(bottom, u));
        const Vec3 atBottom(s.bottomRadius * along, s.bottomRadius * glm::dot(bottom, along));
        const Vec3 atTop(s.topRadius * along, s.topRadius * glm::dot(top, along));
        for (size_t j = 0; j < kAcross; ++j) {
            const double node = j < 4 ? kNodes[j] : -kNodes[j - 4], t = 0.5 + 0.5 * node;
            sum += 0.5 * kWeights[j % 4] * glm::length(glm::cross((1.0 - t) * atBottom + t * atTop, rise));
        }
    }
    return sum * kTurn / double(kAround);
}

double capArea(double radius, const Vec2& slope) { return kPi * radius * radius * std::sqrt(1.0 + glm::dot(slope, slope)); }

/// Two triangles or trapezoids between the sides of the rectangles, each a planar polygon.
double sideArea(double bottom, double top, double slantHeight) { return 0.5 * (bottom + top) * slantHeight; }

double areaOf(const Sphere& s) { return 4.0 * kPi * square(s.radius); }
double areaOf(const Cylinder& s) { return kTurn * s.radius * (s.radius + s.height); }
double areaOf(const Cone& s) {
    return kPi * (square(s.bottomRadius) + square(s.topRadius) +
                  (s.bottomRadius + s.topRadius) * std::hypot(s.height, s.bottomRadius - s.topRadius));
}
double areaOf(const EccentricCone& s) {
    return capArea(s.bottomRadius, slopes(s.bottom)) + capArea(s.topRadius, slopes(s.top)) + wallArea(s);
}
double areaOf(const MitredCylinder& s) {
    return capArea(s.radius, slopes(s.bottom)) + capArea(s.radius, slopes(s.top)) + kTurn * s.radius * s.height;
}
double areaOf(const CircularTorus& s) {
    const double ends = isWholeTurn(s.sweep) ? 0.0 : kTurn * square(s.tubeRadius);
    return kTurn * s.tubeRadius * s.ringRadius * s.sweep.radians() + ends;
}
double areaOf(const RectangularTorus& s) {
    const double across = s.outerRadius - s.innerRadius, sum = s.outerRadius + s.innerRadius;
    const double ends = isWholeTurn(s.sweep) ? 0.0 : 2.0 * across * s.height;
    return s.sweep.radians() * sum * (across + s.height) + ends;
}
/// Of an oblate or prolate half ellipsoid, each by its own formula; near the sphere by the sphere's.
double areaOf(const EllipsoidalDish& s) {
    const double base = kPi * square(s.radius), ratio = s.radius > 0.0 ? s.height / s.radius : 0.0;
    if (ratio == 0.0) return 2.0 * base;
    const double e = std::sqrt(std::abs(1.0 - (ratio < 1.0 ? ratio * ratio : 1.0 / (ratio * ratio))));
    if (e < 1e-5) return 3.0 * base;
    if (ratio < 1.0) return base * (2.0 + ratio * ratio / e * std::atanh(e));
    return base * (2.0 + ratio / e * std::asin(e));
}
double areaOf(const SphericalDish& s) { return kPi * (2.0 * square(s.radius) + square(s.height)); }
double areaOf(const TorisphericalHead& s) {
    const Crown crown = crownOf(s);
    const double k = s.knuckleRadius;
    const double knuckle = kTurn * k * ((s.radius - k) * std::atan2(crown.edge.y, crown.edge.x) + k * crown.edge.y);
    return kPi * square(s.radius) + knuckle + kTurn * square(s.crownRadius) * (1.0 - crown.edge.y);
}
double areaOf(const Box& s) { return 2.0 * (s.size.x * s.size.y + s.size.y * s.size.z + s.size.z * s.size.x); }
double areaOf(const Wedge& s) {
    return s.size.x * s.size.y + s.size.y * s.size.z + s.size.y * std::hypot(s.size.x, s.size.z) + s.size.x * s.size.z;
}
double areaOf(const PyramidFrustum& s) {
    double sum = s.bottom.x * s.bottom.y + s.top.x * s.top.y;
    for (const double side : {-1.0, 1.0}) {
        sum += sideArea(s.bottom.x, s.top.x, std::hypot(s.height, s.offset.y + side * 0.5 * (s.top.y - s.bottom.y)));
        sum += sideArea(s.bottom.y, s.top.y, std::hypot(s.height, s.offset.x + side * 0.5 * (s.top.x - s.bottom.x)));
    }
    return sum;
}
double areaOf(const Pyramid& s) { return areaOf(PyramidFrustum{s.base, Vec2(0.0), s.height, s.apexOffset}); }
double areaOf(const Prism& s) {
    const double half = kPi / s.sides;
    return s.sides * (square(s.radius) * onCircle(1, s.sides).y + 2.0 * s.radius * std::sin(half) * s.height);
}
double areaOf(const Disc& s) { return kTurn * square(s.radius); }
double areaOf(const Ring& s) { return kTurn * (square(s.outerRadius) - square(s.innerRadius)); }
double areaOf(const HollowCylinder& s) {
    return kTurn * (square(s.outerRadius) - square(s.innerRadius) + (s.outerRadius + s.innerRadius) * s.height);
}

Box3 upright(double radius, double low, double high) { return {{-radius, -radius, low}, {radius, radius, high}}; }

/// Of the part of a ring in the plane, from the x axis by `sweep`, in x and y.
Box3 ofSweep(double inner, double outer, Angle sweep, double halfHeight) {
    Box3 box;
    const auto add = [&](const Vec2& direction) {
        for (const double radius : {inner, outer}) {
            box.add(Vec3(radius * direction, -halfHeight));
            box.add(Vec3(radius * direction, halfHeight));
        }
    };
    for (uint64_t quarter = 0; quarter < 4; ++quarter)
        if (double(quarter) * kRightAngle <= sweep.radians()) add(onCircle(quarter, 4));
    add(onCircle(sweep));
    return box;
}

Box3 boundsOf(const Sphere& s) { return upright(s.radius, -s.radius, s.radius); }
Box3 boundsOf(const Cylinder& s) { return upright(s.radius, -0.5 * s.height, 0.5 * s.height); }
Box3 boundsOf(const Cone& s) { return upright(std::max(s.bottomRadius, s.topRadius), -0.5 * s.height, 0.5 * s.height); }
Box3 boundsOf(const EccentricCone& s) {
    Box3 box;
    const auto add = [&](double radius, const Vec2& centre, double height, const Vec2& slope) {
        const double rise = radius * glm::length(slope);
        box.add(Vec3(centre - radius, height - rise));
        box.add(Vec3(centre + radius, height + rise));
    };
    add(s.bottomRadius, -0.5 * s.offset, -0.5 * s.height, slopes(s.bottom));
    add(s.topRadius, 0.5 * s.offset, 0.5 * s.height, slopes(s.top));
    return box;
}
Box3 boundsOf(const MitredCylinder& s) { return boundsOf(asEccentricCone(s)); }
/// Where the sweep ends between axes, the end's circle reaches furthest at its own outermost points.
Box3 boundsOf(const CircularTorus& s) {
    return ofSweep(s.ringRadius - s.tubeRadius, s.ringRadius + s.tubeRadius, s.sweep, s.tubeRadius);
}
Box3 boundsOf(const RectangularTorus& s) { return ofSweep(s.innerRadius, s.outerRadius, s.sweep, 0.5 * s.height); }
Box3 boundsOf(const EllipsoidalDish& s) { return upright(s.radius, 0.0, s.height); }
/// A cap higher than its radius is wider than its flat side.
Box3 boundsOf(const SphericalDish& s) {
    const double sphere = s.height > s.radius ? (square(s.radius) + square(s.height)) / (2.0 * s.height) : s.radius;
    return upright(std::max(s.radius, sphere), 0.0, s.height);
}
Box3 boundsOf(const TorisphericalHead& s) { return upright(s.radius, 0.0, torisphericalHeight(s)); }
Box3 boundsOf(const Box& s) { return {-0.5 * s.size, 0.5 * s.size}; }
Box3 boundsOf(const Wedge& s) { return {-0.5 * s.size, 0.5 * s.size}; }
Box3 boundsOf(const PyramidFrustum& s) {
    Box3 box;
    for (const double side : {-0.5, 0.5}) {
        box.add(Vec3(-0.5 * s.offset + side * s.bottom, -0.5 * s.height));
        box.add(Vec3(0.5 * s.offset + side * s.top, 0.5 * s.height));
    }
    return box;
}
Box3 boundsOf(const Pyramid& s) { return boundsOf(PyramidFrustum{s.base, Vec2(0.0), s.height, s.apexOffset}); }
Box3 boundsOf(const Prism& s) {
    Box3 box;
    for (uint64_t i = 0; i < s.sides; ++i)
        for (const double z : {-0.5, 0.5}) box.add(Vec3(s.radius * onCircle(i, s.sides), z * s.height));
    return box;
}
Box3 boundsOf(const Disc& s) { return upright(s.radius, 0.0, 0.0); }
Box3 boundsOf(const Ring& s) { return upright(s.outerRadius, 0.0, 0.0); }
Box3 boundsOf(const HollowCylinder& s) { return upright(s.outerRadius, -0.5 * s.height, 0.5 * s.height); }

}  // namespace

double volume(const Primitive& primitive) {
    return std::visit([](const auto& solid) { return volumeOf(solid); }, primitive);
}
double area(const Primitive& primitive) {
    return std::visit([](const auto& solid) { return areaOf(solid); }, primitive);
}
Box3 bounds(const Primitive& primitive) {
    return std::visit([](const auto& solid) { return boundsOf(solid); }, primitive);
}

}  // namespace cullscope::primitive
