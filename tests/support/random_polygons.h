#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "core/geometry/random.h"
#include "core/scene/camera.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

/// How the triangles of a scene meet, which is what is hard for a visible-surface method.
enum class Meeting { Intersecting, Cyclic, Coplanar, SharingEdges, Touching };
inline constexpr int kMeetings = 5;
inline Meeting meetingOf(uint64_t seed) { return Meeting(seed % kMeetings); }

namespace random_polygons {

inline Vec3f point(Random& random, double reach) {
    return {float(random.between(-reach, reach)), float(random.between(-reach, reach)), float(random.between(-reach, reach))};
}

/// Triangles anywhere in a cube: nearly every one passes through others.
inline void intersecting(Random& random, std::vector<Vec3f>& corners) {
    for (int i = 0; i < 3 * 40; ++i) corners.push_back(point(random, 1.0));
}

/// Three bars, each over the next one, some of them at several sizes.
inline void cyclic(Random& random, std::vector<Vec3f>& corners) {
    for (int ring = 0; ring < 3; ++ring) {
        const float size = float(random.between(0.1, 0.35)), slope = float(random.between(0.05, 0.5));
        const Vec3f centre = point(random, 0.5);
        for (int bar = 0; bar < 3; ++bar) {
            const double angle = 2.0 * std::numbers::pi * bar / 3;
            const auto turned = [&](float x, float y, float z) {
                return centre + size * Vec3f(float(std::cos(angle) * x - std::sin(angle) * y),
                                             float(std::sin(angle) * x + std::cos(angle) * y), slope * z);
            };
            const std::array quad{turned(-3, -1.2f, 1), turned(3, -1.2f, -1), turned(3, -.8f, -1), turned(-3, -.8f, 1)};
            for (const size_t corner : {0, 1, 2, 0, 2, 3}) corners.push_back(quad[corner]);
        }
    }
}

/// Triangles in few planes, which overlap there; some are there twice.
inline void coplanar(Random& random, std::vector<Vec3f>& corners) {
    for (int plane = 0; plane < 3; ++plane) {
        const Vec3f origin = point(random, 0.5), u = point(random, 1.0), v = point(random, 1.0);
        for (int i = 0; i < 3 * 8; ++i)
            corners.push_back(origin + float(random.between(-1, 1)) * u + float(random.between(-1, 1)) * v);
        corners.insert(corners.end(), corners.end() - 3, corners.end());
    }
}

/// A crumpled sheet: every inner edge belongs to two triangles, every inner corner to six. On a lattice, so that many corners and
/// edges fall on pixel centres, rows and columns where the view looks along an axis.
inline void sharingEdges(Random& random, std::vector<Vec3f>& corners) {
    constexpr int kCells = 8;
    std::array<std::array<Vec3f, kCells + 1>, kCells + 1> at;
    for (int y = 0; y <= kCells; ++y)
        for (int x = 0; x <= kCells; ++x)
            at[size_t(y)][size_t(x)] = {float(x) / 4 - 1, float(y) / 4 - 1, float(random.between(-0.5, 0.5))};
    for (size_t y = 0; y < kCells; ++y)
        for (size_t x = 0; x < kCells; ++x)
            for (const Vec3f& corner : {at[y][x], at[y][x + 1], at[y + 1][x + 1], at[y][x], at[y + 1][x + 1], at[y + 1][x]})
                corners.push_back(corner);
}

/// Corners that lie on other triangles' edges (T-junctions) and inside their surfaces, and triangles that share one corner.
inline void touching(Random& random, std::vector<Vec3f>& corners) {
    for (int group = 0; group < 6; ++group) {
        const Vec3f a = point(random, 1.0), b = point(random, 1.0), c = point(random, 1.0);
        const float t = float(random.between(0.2, 0.8)), s = float(random.between(0.1, 0.4));
        const Vec3f onEdge = a + t * (b - a), inside = a + s * (b - a) + s * (c - a);
        for (const Vec3f& corner : {a, b, c, onEdge, a, point(random, 1.0), b, onEdge, point(random, 1.0), inside,
                                    point(random, 1.0), point(random, 1.0)})
            corners.push_back(corner);
    }
}

}  // namespace random_polygons

/// A scene of about 30 to 130 triangles within the cube of side 2 (cycles and coplanar ones a little beyond), as one object of
/// separate triangles. The same for the same seed.
inline ScenePointer randomPolygons(uint64_t seed) {
    Random random(seed * 7919 + 1);
    std::vector<Vec3f> corners;
    switch (meetingOf(seed)) {
        case Meeting::Intersecting:
            random_polygons::intersecting(random, corners);
            break;
        case Meeting::Cyclic:
            random_polygons::cyclic(random, corners);
            break;
        case Meeting::Coplanar:
            random_polygons::coplanar(random, corners);
            break;
        case Meeting::SharingEdges:
            random_polygons::sharingEdges(random, corners);
            break;
        case Meeting::Touching:
            random_polygons::touching(random, corners);
            break;
    }
    std::vector<uint32_t> indices(corners.size());
    for (uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
    return sceneOf({meshOf(std::move(corners), std::move(indices))});
}

/// A camera around such a scene; every fourth one stands within it, so that triangles cross its near plane, and every fourth one
/// looks along an axis.
inline Camera aroundPolygons(uint64_t seed) {
    Random random(seed * 104729 + 3);
    const bool within = seed % 4 == 3, alongAxis = seed % 4 == 2;
    const Vec3 eye = alongAxis ? Vec3(0, 0, 3) : (within ? 0.5 : random.between(2.0, 5.0)) * random.direction();
    const Vec3 target = alongAxis ? Vec3(0.0) : Vec3(random.between(-.4, .4), random.between(-.4, .4), random.between(-.4, .4));
    return {eye, target, {0.1, 1, 0.05}, Angle::fromDegrees(random.between(30, 90)), 0.05, 50.0};
}

}  // namespace cullscope::test
