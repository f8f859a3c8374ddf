// Scenes of the gallery for cases that compute: what they compute with, to be looked at.
#include <cmath>

#include "core/mesh/parametric.h"
#include "core/scene/gallery/gallery_parts.h"

namespace cullscope::gallery {
namespace {

/// As the maps of directions count: from the z axis, and about it from the x axis.
Vec3 direction(double zenithDegrees, double azimuthDegrees) {
    const double theta = Angle::fromDegrees(zenithDegrees).radians(), phi = Angle::fromDegrees(azimuthDegrees).radians();
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

/// A small octahedron at the origin, and triangles on the unit sphere about it with their reflections through the origin, so that
/// the centre of the bounding sphere is the origin.
MeshPointer aboutTheOrigin(const std::vector<Vec3>& triangles) {
    constexpr double kCore = 0.25;
    std::vector<Vec3f> corners;
    for (const double x : {-kCore, kCore})
        for (const double y : {-kCore, kCore})
            for (const double z : {-kCore, kCore}) {
                const bool even = x * y * z > 0.0;
                corners.emplace_back(Vec3(x, 0, 0));
                corners.emplace_back(even ? Vec3(0, y, 0) : Vec3(0, 0, z));
                corners.emplace_back(even ? Vec3(0, 0, z) : Vec3(0, y, 0));
            }
    for (size_t i = 0; i + 2 < triangles.size(); i += 3) {
        for (size_t corner = 0; corner < 3; ++corner) corners.emplace_back(triangles[i + corner]);
        // A reflection turns the front to the back: two corners change places.
        for (const size_t corner : {0, 2, 1}) corners.emplace_back(-triangles[i + corner]);
    }
    return soup(std::move(corners));
}

/// A triangle whose corners lie a few degrees around a direction.
std::vector<Vec3> around(const Vec3& middle) {
    const Vec3 aside = glm::normalize(glm::cross(middle, std::abs(middle.z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
    const Vec3 up = glm::cross(aside, middle);
    constexpr double kSpread = 0.2;
    const auto corner = [&](double x, double y) { return glm::normalize(middle + kSpread * (x * aside + y * up)); };
    return {corner(-1, -1), corner(0, 1), corner(1, -1)};
}

/// From a direction, with a field of view that the triangles fill.
Parts seenFrom(const MeshPointer& mesh, const Vec3& at, double fovyDegrees) {
    return Parts().add(mesh).from(cameraAt(3.0 * at, fovyDegrees));
}

}  // namespace

Parts flatBoxAboveAPlane() {
    // The plane y = 0, below which lies what its half-space holds, as a thin slab.
    return Parts().add(box({-60, 9, -1}, {60, 11, 1})).add(box({-60, -0.1, -20}, {60, 0, 20})).from(cameraAt({20, 30, 90}, 60));
}

Parts sphereAtAFarPlane() {
    const Vec3 on(1e7 + 5.5, 0, -1e7 + 6.5), centre(1e7 + 8.5, 0, -1e7 + 7.5), normal(.6, 0, -.8);
    Mat4 plane = moved(on) * turned({0, 1, 0}, std::atan2(normal.x, normal.z));
    // The plane's normal points to the side of the eye.
    const Vec3 eye = centre + Vec3(5, 3, -7);
    return Parts()
        .add(sphereMesh(4000), moved(centre))
        .add(square(6, 0.0f), plane)
        .from({eye, centre, {0, 1, 0}, Angle::fromDegrees(60), 0.05, 100});
}

Parts whatIsLeftOfABrokenFile() {
    return Parts().add(soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})).from(cameraAt({0.3, 0.3, 2}, 45, {0.3, 0.3, 0}));
}

Parts triangleOverTheSeam() {
    return seenFrom(aboutTheOrigin({direction(89.2, 359.5), direction(89.5, 0.2), direction(89.8, 0.5)}), direction(89.5, 0.07),
                    0.8);
}

Parts triangleOverThePole() {
    return seenFrom(aboutTheOrigin({direction(1, 0), direction(1, 120), direction(1, 240)}), {0, 0, 1}, 1.5);
}

Parts azimuthsOfOtherQuadrants() {
    std::vector<Vec3> triangles = around(direction(90, 225));
    for (const Vec3& corner : around(direction(90, 90))) triangles.push_back(corner);
    return seenFrom(aboutTheOrigin(triangles), glm::normalize(Vec3(-1, 0.5, 0.5)), 45);
}

Parts azimuthThatRoundsToATurn() {
    return seenFrom(aboutTheOrigin({Vec3(1, -1e-17, 0), direction(85, 5), direction(85, 10)}), direction(87, 5), 8);
}

Parts smallZenithAngle() {
    return seenFrom(aboutTheOrigin({glm::normalize(Vec3(1e-9, 0, 1)), direction(5, 10), direction(5, 50)}), direction(3, 30), 6);
}

Parts boxesToBeNamed() {
    Parts parts;
    const MeshPointer one = box(Vec3(-0.05), Vec3(0.05));
    for (int i = 0; i < 400; ++i) {
        const Mat4 place = moved({0.2 * (i % 20) - 1.9, 0.2 * (i / 20) - 1.9, -5});
        i == 0 ? parts.add(one, place) : parts.copy(place);
    }
    return parts.from(usualCamera());
}

}  // namespace cullscope::gallery
