#pragma once

#include <cmath>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/geometry/random.h"
#include "core/mesh/primitive/tessellate.h"
#include "core/scene/scene.h"

/// A process plant as a scene. Lengths in metres, z up.
namespace cullscope::plant {

/// A primitive within a component. Where two of one component meet, they overlap or differ by a millimetre, so that no edge of
/// the one coincides with an edge of the other: the component's mesh stays closed as a whole.
struct Solid {
    primitive::Primitive shape;
    Mat4 place{1.0};
};
using Solids = std::vector<Solid>;
inline constexpr double kLip = 0.001;  ///< that millimetre

/// A frame with the given axes z and x, which are perpendicular unit vectors.
[[nodiscard]] Mat4 frame(const Vec3& origin, const Vec3& z, const Vec3& x);
/// The same with some x, for what is round.
[[nodiscard]] Mat4 frame(const Vec3& origin, const Vec3& z);
[[nodiscard]] Mat4 at(double x, double y, double z);
/// At a place with z along the x or the y axis.
[[nodiscard]] Mat4 alongX(double x, double y, double z);
[[nodiscard]] Mat4 alongY(double x, double y, double z);
/// A rod between two points.
[[nodiscard]] Solid rod(const Vec3& from, const Vec3& to, double radius);
[[nodiscard]] Solid box(const Vec3& centre, const Vec3& size);

/// A whole number from 0 to `count` − 1.
[[nodiscard]] inline uint32_t below(Random& random, uint32_t count) { return uint32_t((random.bits() >> 16) % count); }

/// To a grid of 5 cm, so that pipes have few different lengths.
[[nodiscard]] inline double onGrid(double length) { return std::nearbyint(20.0 * length) / 20.0; }
[[nodiscard]] inline int64_t millimetres(double length) { return int64_t(std::nearbyint(1000.0 * length)); }

/// What two components must share to be equal.
struct Key {
    const char* kind;   ///< by address: a literal that stands at one place
    uint32_t size = 0;  ///< such as the place in a table of sizes
    int64_t length = 0;

    bool operator==(const Key&) const = default;
};

/// Of a full circle: a hexagon, as of nuts, is the shape itself and no approximation of a circle.
inline constexpr uint32_t kHexagon = 6;

/// Collects the objects of a plant. Equal components are made once.
class Kit {
public:
    /// `chordError`: the largest distance of triangles from the surfaces that they stand for, in metres; 0: circles have as many
    /// segments as `add` says.
    explicit Kit(double chordError = 0.0) : m_chordError(chordError) {}

    /// Begins a group. Objects are named after the group in hand: "L00042/valve 2".
    uint32_t beginGroup(std::string name, uint32_t parent = kNoGroup);

    /// Places a component in the group in hand: `make()` gives its Solids where no equal one was made before. `segments` of a
    /// full circle.
    template <typename Make>
    void add(const Key& key, uint32_t segments, const Mat4& place, const Make& make) {
        auto known = m_known.find(key);
        if (known == m_known.end()) known = m_known.emplace(key, newMesh(key.kind, segments, make())).first;
        addInstance(known->second, place, key.kind);
    }

    [[nodiscard]] ScenePointer finish(std::string name);

private:
    struct Hash {
        size_t operator()(const Key& key) const {
            return std::hash<const void*>()(key.kind) * 31 + size_t(key.size) * 0x9E3779B97F4A7C15ull +
                   size_t(key.length) * 1000003;
        }
    };

    uint32_t newMesh(const char* kind, uint32_t segments, const Solids& solids);
    void addInstance(uint32_t mesh, const Mat4& place, const char* kind);

    double m_chordError;
    std::unordered_map<Key, uint32_t, Hash> m_known;
    std::vector<MeshPointer> m_meshes;
    std::vector<Instance> m_instances;
    Components m_components;
    std::vector<std::pair<const char*, uint32_t>> m_numbers;  ///< of the group in hand, by kind
};

}  // namespace cullscope::plant
