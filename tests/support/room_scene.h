#pragma once

#include <cmath>

#include "core/geometry/random.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

/// Rooms whose floor, ceiling and walls are closed slabs, of which some walls are missing; where fronts are drawn alone, too,
/// what is in other rooms is hidden. A room is 1 wide and high.
inline ScenePointer slabRoomScene(int rooms, Random& random) {
    constexpr float kThick = 0.05f, kBeyond = 0.03f;  // a slab reaches into those that it meets
    const auto size = float(rooms);
    std::vector<MeshPointer> meshes;
    for (const float y : {-kThick, 1.0f})
        meshes.push_back(boxMesh(Vec3f(-kThick, y, -kThick), Vec3f(size + kThick, y + kThick, size + kThick)));
    for (int line = 0; line <= rooms; ++line)
        for (int room = 0; room < rooms; ++room)
            for (const bool alongX : {false, true}) {
                if (line != 0 && line != rooms && random.unit() < 0.15) continue;
                const float across = float(line) - kThick / 2, begin = float(room) - kBeyond, end = float(room + 1) + kBeyond;
                const Vec3f low(alongX ? begin : across, -kBeyond, alongX ? across : begin);
                const Vec3f high(alongX ? end : across + kThick, 1.0f + kBeyond, alongX ? across + kThick : end);
                meshes.push_back(boxMesh(low, high));
            }
    std::vector<Mat4> places(meshes.size(), Mat4(1.0));
    const MeshPointer box = boxMesh(Vec3f(-0.5f), Vec3f(0.5f));
    for (int i = 0; i < 3 * rooms * rooms; ++i) {
        const double x = random.between(0.2, rooms - 0.2), y = random.between(0.1, 0.9), z = random.between(0.2, rooms - 0.2);
        meshes.push_back(box);
        places.push_back(translation(Vec3(x, y, z)) * scaling(Vec3(random.between(0.02, 0.2))));
    }
    return sceneOf(std::move(meshes), places);
}

/// Rooms side by side on a square floor, with a ceiling: walls of tiles, of which some are missing, each wall a mesh of its own
/// about the common `origin`, and closed boxes that stand about. A room is 1 wide and high.
inline ScenePointer roomScene(int rooms, Random& random, const Vec3& origin = Vec3(0.0), double missing = 0.04) {
    constexpr int kTiles = 4;
    std::vector<MeshPointer> meshes;
    std::vector<Mat4> places;
    const auto addWall = [&](const Vec3f& corner, const Vec3f& u, const Vec3f& v, bool whole) {
        std::vector<Vec3f> positions;
        std::vector<uint32_t> indices;
        for (int row = 0; row <= kTiles; ++row)
            for (int column = 0; column <= kTiles; ++column)
                positions.push_back(corner + (float(column) / kTiles) * u + (float(row) / kTiles) * v);
        for (int row = 0; row < kTiles; ++row)
            for (int column = 0; column < kTiles; ++column) {
                if (!whole && random.unit() < missing) continue;
                const auto at = [&](int r, int c) { return uint32_t((row + r) * (kTiles + 1) + column + c); };
                for (const uint32_t index : {at(0, 0), at(0, 1), at(1, 1), at(0, 0), at(1, 1), at(1, 0)})
                    indices.push_back(index);
            }
        if (indices.empty()) return;
        meshes.push_back(meshOf(std::move(positions), std::move(indices), origin));
        places.emplace_back(1.0);
    };
    for (int x = 0; x < rooms; ++x)
        for (int z = 0; z < rooms; ++z) {
            const Vec3f corner(static_cast<float>(x), 0.0f, static_cast<float>(z));
            addWall(corner, {1, 0, 0}, {0, 0, 1}, true);
            addWall(corner + Vec3f(0, 1, 0), {1, 0, 0}, {0, 0, 1}, true);
        }
    for (int line = 0; line <= rooms; ++line)
        for (int room = 0; room < rooms; ++room) {
            const bool outside = line == 0 || line == rooms;
            addWall(Vec3f(static_cast<float>(line), 0, static_cast<float>(room)), {0, 0, 1}, {0, 1, 0}, outside);
            addWall(Vec3f(static_cast<float>(room), 0, static_cast<float>(line)), {1, 0, 0}, {0, 1, 0}, outside);
        }
    const MeshPointer box = boxMesh(Vec3f(-0.5f), Vec3f(0.5f));
    for (int i = 0; i < 3 * rooms * rooms; ++i) {
        const double x = random.between(0.1, rooms - 0.1), y = random.between(0.1, 0.9), z = random.between(0.1, rooms - 0.1);
        meshes.push_back(box);
        places.push_back(translation(origin + Vec3(x, y, z)) * scaling(Vec3(random.between(0.02, 0.3))));
    }
    return sceneOf(std::move(meshes), places);
}

}  // namespace cullscope::test
