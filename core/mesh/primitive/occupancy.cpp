#include "core/mesh/primitive/occupancy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

namespace cullscope::primitive {
namespace {

double halfDiagonal(double across, double along) { return 0.5 * std::hypot(across, along); }

/// Half the largest distance between two of some points.
double halfDiameter(std::span<const Vec3> points) {
    double largest = 0.0;
    for (size_t i = 0; i < points.size(); ++i)
        for (size_t j = 0; j < i; ++j) largest = std::max(largest, glm::length(points[i] - points[j]));
    return 0.5 * largest;
}

/// The largest distance between two points of a sector of an annulus.
double acrossSector(double inner, double outer, Angle sweep) {
    const double angle = sweep.radians();
    if (angle >= std::numbers::pi) return 2.0 * outer;
    const double oblique = std::sqrt(inner * inner + outer * outer - 2.0 * inner * outer * std::cos(angle));
    return std::max(2.0 * outer * std::sin(0.5 * angle), oblique);
}

struct OccupancyOf {
    double operator()(const Sphere& sphere) const { return sphere.radius; }
    double operator()(const Cylinder& cylinder) const { return halfDiagonal(2.0 * cylinder.radius, cylinder.height); }
    double operator()(const Cone& cone) const {
        return std::max({cone.bottomRadius, cone.topRadius, halfDiagonal(cone.bottomRadius + cone.topRadius, cone.height)});
    }
    double operator()(const EccentricCone& cone) const {
        // An end's plane rises by at most the length of its slopes.
        const double bottom = glm::length(slopes(cone.bottom)), top = glm::length(slopes(cone.top));
        const double height = cone.height + cone.bottomRadius * bottom + cone.topRadius * top;
        return std::max({cone.bottomRadius * std::hypot(1.0, bottom), cone.topRadius * std::hypot(1.0, top),
                         halfDiagonal(glm::length(cone.offset) + cone.bottomRadius + cone.topRadius, height)});
    }
    double operator()(const MitredCylinder& cylinder) const { return (*this)(asEccentricCone(cylinder)); }
    double operator()(const CircularTorus& torus) const {
        if (torus.sweep.radians() >= std::numbers::pi) return torus.ringRadius + torus.tubeRadius;
        const double outer = torus.ringRadius + torus.tubeRadius;
        return halfDiagonal(acrossSector(std::max(torus.ringRadius - torus.tubeRadius, 0.0), outer, torus.sweep),
                            2.0 * torus.tubeRadius);
    }
    double operator()(const RectangularTorus& torus) const {
        return halfDiagonal(acrossSector(torus.innerRadius, torus.outerRadius, torus.sweep), torus.height);
    }
    double operator()(const EllipsoidalDish& dish) const {
        // From a point of the rim to the point of the ellipse at the cosine c.
        const double radius = dish.radius * dish.radius, height = dish.height * dish.height;
        const double c = height > 2.0 * radius ? radius / (height - radius) : 1.0;
        return 0.5 * std::sqrt(radius * (1.0 + c) * (1.0 + c) + height * (1.0 - c * c));
    }
    double operator()(const SphericalDish& dish) const {
        if (dish.height <= dish.radius) return dish.radius;
        return (dish.radius * dish.radius + dish.height * dish.height) / (2.0 * dish.height);
    }
    double operator()(const TorisphericalHead& head) const {
        const double height = torisphericalHeight(head);
        return height <= head.radius ? head.radius : halfDiagonal(2.0 * head.radius, height);
    }
    double operator()(const Box& box) const { return 0.5 * glm::length(box.size); }
    double operator()(const Wedge& wedge) const { return 0.5 * glm::length(wedge.size); }
    double operator()(const Pyramid& pyramid) const {
        return (*this)(PyramidFrustum{pyramid.base, Vec2(0.0), pyramid.height, pyramid.apexOffset});
    }
    double operator()(const PyramidFrustum& frustum) const {
        std::array<Vec3, 8> corners;
        for (size_t i = 0; i < 8; ++i) {
            const double end = i < 4 ? -0.5 : 0.5;
            const Vec2 size = i < 4 ? frustum.bottom : frustum.top;
            corners[i] = {end * frustum.offset.x + ((i & 1) != 0 ? 0.5 : -0.5) * size.x,
                          end * frustum.offset.y + ((i & 2) != 0 ? 0.5 : -0.5) * size.y, end * frustum.height};
        }
        return halfDiameter(corners);
    }
    double operator()(const Prism& prism) const {
        const double across =
            prism.sides % 2 == 0 ? 2.0 * prism.radius : 2.0 * prism.radius * std::cos(0.5 * std::numbers::pi / prism.sides);
        return halfDiagonal(across, prism.height);
    }
    double operator()(const Disc& disc) const { return disc.radius; }
    double operator()(const Ring& ring) const { return ring.outerRadius; }
    double operator()(const HollowCylinder& cylinder) const { return halfDiagonal(2.0 * cylinder.outerRadius, cylinder.height); }
};

}  // namespace

double occupancy(const Primitive& primitive) { return std::visit(OccupancyOf(), primitive); }

}  // namespace cullscope::primitive
