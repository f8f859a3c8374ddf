#pragma once

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "core/geometry/types.h"

namespace cullscope::test {

/// Writes a level of Quake 3. The arrays are added to in any order; `bytes` lays them out behind the directory.
class IbspBytes {
public:
    enum Lump : size_t {
        Entities = 0,
        Shaders = 1,
        Planes = 2,
        Nodes = 3,
        Leaves = 4,
        LeafSurfaces = 5,
        Models = 7,
        Vertices = 10,
        Corners = 11,
        Surfaces = 13,
        Visibility = 16
    };

    IbspBytes& entities(const std::string& text) {
        m_lumps[Entities] += text;
        return *this;
    }
    IbspBytes& shader(std::string name, int32_t flags = 0) {
        name.resize(64, '\0');
        m_lumps[Shaders] += name;
        return wholes(Shaders, {flags, 1});
    }
    IbspBytes& plane(const Vec3f& normal, float distance) { return reals(Planes, {normal.x, normal.y, normal.z, distance}); }
    IbspBytes& node(int32_t plane, int32_t front, int32_t back) {
        return wholes(Nodes, {plane, front, back, -9, -9, -9, 9, 9, 9});
    }
    IbspBytes& leaf(int32_t cluster, int32_t firstSurface, int32_t surfaces) {
        return wholes(Leaves, {cluster, 0, -9, -9, -9, 9, 9, 9, firstSurface, surfaces, 0, 0});
    }
    IbspBytes& leafSurface(int32_t surface) { return wholes(LeafSurfaces, {surface}); }
    IbspBytes& model(int32_t firstSurface, int32_t surfaces) {
        return reals(Models, {-9, -9, -9, 9, 9, 9}).wholes(Models, {firstSurface, surfaces, 0, 0});
    }
    IbspBytes& vertex(const Vec3f& position, const Vec3f& normal = {0, 0, 1}) {
        reals(Vertices, {position.x, position.y, position.z, 0, 0, 0, 0, normal.x, normal.y, normal.z});
        return wholes(Vertices, {-1});
    }
    IbspBytes& corners(std::initializer_list<int32_t> values) { return wholes(Corners, values); }
    IbspBytes& surface(int32_t shader, int32_t kind, int32_t firstVertex, int32_t vertices, int32_t firstCorner, int32_t corners,
                       int32_t patchWidth = 0, int32_t patchHeight = 0) {
        wholes(Surfaces, {shader, -1, kind, firstVertex, vertices, firstCorner, corners, 0, 0, 0, 0, 0});
        return reals(Surfaces, {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}).wholes(Surfaces, {patchWidth, patchHeight});
    }
    IbspBytes& visibility(int32_t clusters, const std::string& bits) {
        wholes(Visibility, {clusters, int32_t(bits.size()) / clusters});
        m_lumps[Visibility] += bits;
        return *this;
    }
    IbspBytes& version(int32_t number) {
        m_version = number;
        return *this;
    }

    [[nodiscard]] std::string bytes() const {
        std::string all = "IBSP", content;
        const auto whole = [&](size_t value) {
            const auto bits = uint32_t(value);
            all.append(reinterpret_cast<const char*>(&bits), sizeof(bits));
        };
        whole(size_t(m_version));
        for (const std::string& lump : m_lumps) {
            whole(8 + 8 * m_lumps.size() + content.size());
            whole(lump.size());
            content += lump;
        }
        return all + content;
    }
    /// Where an array begins in the file.
    [[nodiscard]] size_t placeOf(Lump lump) const {
        size_t place = 8 + 8 * m_lumps.size();
        for (size_t i = 0; i < lump; ++i) place += m_lumps[i].size();
        return place;
    }

private:
    template <typename Value>
    IbspBytes& add(Lump lump, std::initializer_list<Value> values) {
        for (const Value value : values) m_lumps[lump].append(reinterpret_cast<const char*>(&value), sizeof(value));
        return *this;
    }
    IbspBytes& wholes(Lump lump, std::initializer_list<int32_t> values) { return add(lump, values); }
    IbspBytes& reals(Lump lump, std::initializer_list<float> values) { return add(lump, values); }

    int32_t m_version = 46;
    std::array<std::string, 17> m_lumps;
};

/// A level with a surface of every kind, a door that stands at (100, 0, 0), two clusters of which the first sees the second and
/// not the other way round, and a player at (1, 2, 3) who looks along y.
inline IbspBytes ibspSample() {
    IbspBytes level;
    level.entities(
        "{\n\"classname\" \"worldspawn\"\n}\n{\n\"classname\" \"func_door\"\n\"model\" \"*1\"\n\"origin\" \"100 0 0\"\n}\n"
        "{\n\"classname\" \"info_player_deathmatch\"\n\"origin\" \"1 2 3\"\n\"angle\" \"90\"\n}\n");
    level.shader("textures/wall").shader("textures/sky", 0x4).shader("textures/door");
    for (const Vec3f corner : {Vec3f(0, 0, 0), Vec3f(0, 8, 0), Vec3f(8, 8, 0), Vec3f(8, 0, 0)}) level.vertex(corner);
    level.corners({0, 1, 2, 0, 2, 3});
    level.surface(0, 1, 0, 4, 0, 6);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            level.vertex({float(4 * column), 16.0F + float(4 * row), row == 1 ? 4.0F : 0.0F});
    level.surface(0, 2, 4, 9, 0, 0, 3, 3);
    level.surface(0, 4, 0, 0, 0, 0);
    level.surface(1, 1, 0, 4, 0, 6);
    level.surface(2, 3, 0, 4, 0, 3);
    level.model(0, 4).model(4, 1);
    level.plane({1, 0, 0}, 4).node(0, -2, -1).leaf(0, 0, 2).leaf(1, 2, 1);
    level.leafSurface(0).leafSurface(1).leafSurface(0);
    return level.visibility(2, std::string("\x03\x02", 2));
}

}  // namespace cullscope::test
