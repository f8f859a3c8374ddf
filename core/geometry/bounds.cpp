#include "core/geometry/bounds.h"

#include <cmath>

namespace cullscope {
namespace {

/// Relative bound on the rounding of a three-term dot product plus a sum in double: fewer than 8 roundings of half an ulp each.
constexpr double kRoundingRoom = 8.0 * std::numeric_limits<double>::epsilon();

Vec3f farthestFrom(std::span<const Vec3f> points, const Vec3& from) {
    Vec3f farthest = points.front();
    double largest = -1.0;
    for (const Vec3f& point : points) {
        const Vec3 difference = Vec3(point) - from;
        const double squared = glm::dot(difference, difference);
        if (squared > largest) {
            largest = squared;
            farthest = point;
        }
    }
    return farthest;
}

double radiusAround(std::span<const Vec3f> points, const Vec3& centre) {
    return glm::length(Vec3(farthestFrom(points, centre)) - centre) * (1.0 + kRoundingRoom);
}

}  // namespace

Box3 transformed(const Box3& box, const Mat4& transform) {
    if (box.empty()) return {};
    const Vec3 centre = box.centre();
    const Vec3 half = box.halfExtent();
    Vec3 newCentre(transform[3]);
    Vec3 newHalf(0.0);
    Vec3 magnitude = glm::abs(Vec3(transform[3]));
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 column(transform[axis]);
        newCentre += column * centre[axis];
        newHalf += glm::abs(column) * half[axis];
        magnitude += glm::abs(column) * (std::abs(centre[axis]) + half[axis]);
    }
    newHalf += magnitude * kRoundingRoom;
    return {newCentre - newHalf, newCentre + newHalf};
}

Sphere boundingSphere(std::span<const Vec3f> points) {
    if (points.empty()) return {};
    Box3 box;
    for (const Vec3f& point : points) box.add(Vec3(point));

    const Vec3 first = Vec3(farthestFrom(points, Vec3(points.front())));
    const Vec3 second = Vec3(farthestFrom(points, first));
    Vec3 centre = 0.5 * (first + second);
    double radius = 0.5 * glm::length(second - first);
    for (const Vec3f& point : points) {
        const double distance = glm::length(Vec3(point) - centre);
        if (distance <= radius) continue;
        const double grown = 0.5 * (radius + distance);
        centre += (Vec3(point) - centre) * ((distance - grown) / distance);
        radius = grown;
    }
    const Sphere ritter{centre, radiusAround(points, centre)};
    const Sphere boxCentred{box.centre(), radiusAround(points, box.centre())};
    return ritter.radius < boxCentred.radius ? ritter : boxCentred;
}

Sphere transformed(const Sphere& sphere, const Mat4& transform) {
    const Vec3 centre = Vec3(transform * Vec4(sphere.centre, 1.0));
    // The spectral norm is bounded by sqrt(norm_1 * norm_inf) of M^T M; for rotations with a uniform scale it is exact.
    const Mat3 linear(transform);
    const Mat3 gram = glm::transpose(linear) * linear;
    double stretchSquared = 0.0;
    for (int column = 0; column < 3; ++column)
        stretchSquared = std::max(stretchSquared, std::abs(gram[column].x) + std::abs(gram[column].y) + std::abs(gram[column].z));
    Vec3 magnitude = glm::abs(Vec3(transform[3]));
    for (int axis = 0; axis < 3; ++axis) magnitude += glm::abs(Vec3(transform[axis]) * sphere.centre[axis]);
    const double rounding = kRoundingRoom * glm::length(magnitude);
    return {centre, sphere.radius * std::sqrt(stretchSquared) * (1.0 + kRoundingRoom) + rounding};
}

}  // namespace cullscope
