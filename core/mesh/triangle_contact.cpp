#include "core/mesh/triangle_contact.h"

#include <algorithm>
#include <cmath>

namespace cullscope {
namespace {

Vec3 normalOf(const TriangleCorners& corners) {
    const Vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(across);
    return length > 0.0 ? across / length : Vec3(0.0);
}

bool isCorner(const Vec3& point, const TriangleCorners& of) { return point == of[0] || point == of[1] || point == of[2]; }

/// The distances of a triangle's corners from another's plane; 0 of corners that are shared or nearly in the plane.
std::array<double, 3> distances(const TriangleCorners& of, const TriangleCorners& plane, const Vec3& normal) {
    std::array<double, 3> result{};
    for (size_t i = 0; i < 3; ++i) {
        const double distance = glm::dot(normal, of[i] - plane[0]);
        if (!isCorner(of[i], plane) && std::abs(distance) > kContactRoom) result[i] = distance;
    }
    return result;
}

/// The part of a triangle in another's plane: between two points, or none.
bool cutByPlane(const TriangleCorners& corners, const std::array<double, 3>& distances, TriangleContact::Piece& cut) {
    std::array<Vec3, 3> points;
    size_t count = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t next = (i + 1) % 3;
        if (distances[i] == 0.0) points[count++] = corners[i];
        if (distances[i] * distances[next] < 0.0)
            points[count++] = glm::mix(corners[i], corners[next], distances[i] / (distances[i] - distances[next]));
    }
    if (count != 2) return false;
    cut = {points[0], points[1]};
    return true;
}

bool allZero(const std::array<double, 3>& values) { return values[0] == 0.0 && values[1] == 0.0 && values[2] == 0.0; }

/// Whether two triangles of one plane share an area: none of their edges separates them.
bool overlapInPlane(const TriangleCorners& a, const TriangleCorners& b, const Vec3& normal) {
    const auto separates = [](const TriangleCorners& one, const Vec3& up, const TriangleCorners& other) {
        for (size_t i = 0; i < 3; ++i) {
            const Vec3 outward = glm::normalize(glm::cross(one[(i + 1) % 3] - one[i], up));
            const auto beyond = [&](const Vec3& point) { return glm::dot(outward, point - one[i]) >= -kContactRoom; };
            if (std::ranges::all_of(other, beyond)) return true;
        }
        return false;
    };
    const Vec3 otherNormal = glm::dot(normalOf(b), normal) < 0.0 ? -normal : normal;
    return !separates(a, normal, b) && !separates(b, otherNormal, a);
}

}  // namespace

TriangleContact contactOf(const TriangleCorners& a, const TriangleCorners& b) {
    TriangleContact contact;
    const Vec3 normalA = normalOf(a), normalB = normalOf(b);
    if (normalA == Vec3(0.0) || normalB == Vec3(0.0)) return contact;
    const std::array<double, 3> ofB = distances(b, a, normalA);
    if (std::ranges::all_of(ofB, [](double d) { return d > 0.0; }) || std::ranges::all_of(ofB, [](double d) { return d < 0.0; }))
        return contact;
    const std::array<double, 3> ofA = distances(a, b, normalB);
    if (allZero(ofA) || allZero(ofB)) {
        if (!overlapInPlane(a, b, normalA)) return contact;
        for (const TriangleCorners* corners : {&a, &b})
            for (size_t i = 0; i < 3; ++i) contact.pieces[contact.count++] = {(*corners)[i], (*corners)[(i + 1) % 3]};
        return contact;
    }
    // In two planes: what they share as an edge is where these meet.
    if (std::ranges::count_if(a, [&](const Vec3& corner) { return isCorner(corner, b); }) >= 2) return contact;
    TriangleContact::Piece inA, inB;
    if (!cutByPlane(a, ofA, inA) || !cutByPlane(b, ofB, inB)) return contact;
    const Vec3 alongA = inA.to - inA.from, alongB = inB.to - inB.from;
    const Vec3 along = glm::dot(alongA, alongA) > glm::dot(alongB, alongB) ? alongA : alongB;
    const double length = glm::length(along);
    if (!(length > kContactRoom)) return contact;
    const Vec3 direction = along / length;
    const auto at = [&](const Vec3& point) { return glm::dot(direction, point - inA.from); };
    const auto [leastA, mostA] = std::minmax({at(inA.from), at(inA.to)});
    const auto [leastB, mostB] = std::minmax({at(inB.from), at(inB.to)});
    const double least = std::max(leastA, leastB), most = std::min(mostA, mostB);
    if (!(most - least > kContactRoom)) return contact;
    contact.pieces[contact.count++] = {inA.from + least * direction, inA.from + most * direction};
    return contact;
}

}  // namespace cullscope
