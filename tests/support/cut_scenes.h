#pragma once

#include <cmath>

#include "core/geometry/random.h"
#include "core/scene/camera.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

/// Triangles as one mesh: three corners each.
inline MeshPointer soupMesh(std::vector<Vec3f> corners) {
    std::vector<uint32_t> indices(corners.size());
    for (uint32_t i = 0; i < indices.size(); ++i) indices[i] = i;
    return meshOf(std::move(corners), std::move(indices));
}

/// A random point of the cube [−1, 1]³. One statement a number: in which order a compiler computes the arguments of a call is its
/// own choice.
inline Vec3 randomPlace(Random& random) {
    const double x = random.between(-1, 1);
    const double y = random.between(-1, 1);
    const double z = random.between(-1, 1);
    return {x, y, z};
}

/// Random triangles in the cube [−1, 1]³ with edges of about `edge`.
inline MeshPointer randomTriangles(uint64_t seed, size_t count, double edge) {
    Random random(seed);
    std::vector<Vec3f> corners;
    for (size_t i = 0; i < count; ++i) {
        const Vec3 middle = randomPlace(random);
        for (int corner = 0; corner < 3; ++corner) corners.push_back(Vec3f(middle + 0.5 * edge * random.direction()));
    }
    return soupMesh(std::move(corners));
}

/// Ten triangles of any size in the cube [−1, 1]³, and thirty as long and of about that width.
inline ScenePointer sliversAmongTriangles(uint64_t seed, double width) {
    Random random(seed * 31 + 7);
    const auto place = [&] { return randomPlace(random); };
    std::vector<Vec3f> corners;
    for (int i = 0; i < 40; ++i) {
        const Vec3 a = place(), b = place();
        const Vec3 c = i % 4 == 0 ? place() : a + random.between(0.1, 0.9) * (b - a) + width * random.direction();
        corners.insert(corners.end(), {Vec3f(a), Vec3f(b), Vec3f(c)});
    }
    return sceneOf({soupMesh(std::move(corners))});
}

/// About so many triangles in one plane, as a lattice.
inline ScenePointer coplanarTriangles(uint64_t count) {
    const auto side = uint32_t(std::sqrt(double(count) / 2.0));
    std::vector<Vec3f> positions;
    std::vector<uint32_t> indices;
    for (uint32_t y = 0; y <= side; ++y)
        for (uint32_t x = 0; x <= side; ++x)
            positions.emplace_back(4.0f * float(x) / float(side) - 2.0f, 4.0f * float(y) / float(side) - 2.0f, 0.5f);
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t at = y * (side + 1) + x;
            for (const uint32_t index : {at, at + 1, at + side + 2, at, at + side + 2, at + side + 1}) indices.push_back(index);
        }
    return sceneOf({meshOf(std::move(positions), std::move(indices))});
}

/// Five squares whose lower edge lies at y = 0, and five whose upper edge does, each along z before the next one. At an odd
/// number of rows a level camera at that height sees these edges on the centres of the middle row.
inline ScenePointer squaresAtEyeHeight() {
    std::vector<Vec3f> corners;
    for (int i = 0; i < 5; ++i)
        for (const float side : {1.0f, -1.0f}) {
            const float x = -1.5f + 0.5f * float(i) + (side < 0 ? 0.3f : 0.0f), z = -2.0f - float(i) + (side < 0 ? 0.5f : 0.0f);
            const Vec3f a(x, 0, z), b(x + 0.7f, 0, z), c(x + 0.7f, side, z), d(x, side, z);
            corners.insert(corners.end(), {a, b, c, a, c, d});
        }
    return sceneOf({soupMesh(std::move(corners))});
}
/// The i-th of eight level views on them.
inline Camera levelCamera(int i) {
    const Vec3 eye(0.1 * i - 0.4, 0, 3.0 - 0.1 * i);
    return {eye, eye - Vec3(0, 0, 10), {0, 1, 0}, Angle::fromDegrees(60), 0.05, 100};
}

/// Three bars that overlap each other in a cycle, seen from (0, 0, 6): stability case 27.
inline MeshPointer threeBars() {
    std::vector<Vec3f> corners;
    for (int turn = 0; turn < 3; ++turn) {
        const double angle = 2.0943951023931953 * turn, c = std::cos(angle), s = std::sin(angle);
        const auto turned = [&](double x, double y, double z) { return Vec3f(Vec3(c * x - s * y, s * x + c * y, z)); };
        const Vec3f a = turned(-3, -1.2, .5), b = turned(3, -1.2, -.5), d = turned(3, -.8, -.5), e = turned(-3, -.8, .5);
        corners.insert(corners.end(), {a, b, d, a, d, e});
    }
    return soupMesh(std::move(corners));
}

/// A scene of some triangles that are hard to order, one kind by seed: through each other, in cycles, in one plane, sharing
/// edges, touching, and all of these. `mirrored`: another scene of the same kind: random corners have x and z exchanged and come
/// in the reverse order.
inline ScenePointer hardScene(uint64_t seed, bool mirrored = false) {
    Random random(seed);
    // One statement a number: in which order a compiler computes the arguments of a call is its own choice.
    const auto place = [&] {
        const double z = random.between(-1, 1);
        const double y = random.between(-1, 1);
        const double x = random.between(-1, 1);
        return mirrored ? Vec3(z, y, x) : Vec3(x, y, z);
    };
    std::vector<Vec3f> corners;
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        corners.insert(corners.end(), {Vec3f(a), Vec3f(b), Vec3f(c)});
    };
    const uint64_t kind = seed % 6;
    if (kind == 0 || kind == 5)
        for (int i = 0; i < 12; ++i) {
            const Vec3 c = place(), b = place(), a = place();
            mirrored ? add(c, b, a) : add(a, b, c);
        }
    if (kind == 1 || kind == 5)  // a cycle of long thin ones around an axis
        for (int i = 0; i < 5; ++i) {
            const double angle = 1.2566370614359172 * i, next = angle + 1.9;
            const Vec3 from(std::cos(angle), std::sin(angle), 0.5), to(std::cos(next), std::sin(next), -0.5);
            add(from, to, to + Vec3(0.2, 0.1, 0.0));
            add(from, to + Vec3(0.2, 0.1, 0.0), from + Vec3(0.2, 0.1, 0.0));
        }
    if (kind == 2 || kind == 5)  // in one plane, side by side, and parallel ones behind; on a grid of halves, so that it is exact
        for (int z = 0; z < 3; ++z)
            for (int x = -2; x < 2; ++x) {
                const Vec3 corner(0.5 * x, -0.5 + 0.25 * z, 0.5 * z - 0.5);
                add(corner, corner + Vec3(0.5, 0, 0), corner + Vec3(0.5, 0.5, 0));
                add(corner, corner + Vec3(0.5, 0.5, 0), corner + Vec3(0, 0.5, 0));
            }
    if (kind == 3 || kind == 5) {  // fans around shared edges
        const Vec3 a = place(), b = place();
        for (int i = 0; i < 8; ++i) add(a, b, place());
    }
    if (kind == 4 || kind == 5)  // corners that lie in other triangles
        for (int i = 0; i < 6; ++i) {
            const Vec3 a(-1, 0.25 * i - 0.75, -0.5), b(1, 0.25 * i - 0.75, -0.5), c(0, 0.25 * i - 0.5, 0.5);
            add(a, b, c);
            const Vec3 third = place(), second = place();
            mirrored ? add(0.5 * (a + c), third, second) : add(0.5 * (a + c), second, third);
        }
    return sceneOf({soupMesh(std::move(corners))});
}

}  // namespace cullscope::test
