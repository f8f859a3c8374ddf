#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/scene/scene.h"

namespace cullscope::fuzz {

/// The values that an input is decoded to, from its front to its end; 0 beyond it. So every input decodes, and a change of a few
/// bytes is a change of a few values.
class Values {
public:
    explicit Values(std::string_view input) : m_rest(input) {}

    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
    template <typename Number>
    [[nodiscard]] Number number() {
        Number value{};
        const size_t bytes = std::min(sizeof(Number), m_rest.size());
        std::memcpy(&value, m_rest.data(), bytes);
        m_rest.remove_prefix(bytes);
        return value;
    }
    [[nodiscard]] uint8_t byte() { return number<uint8_t>(); }
    /// Below `count`, which is from 1 to 256.
    [[nodiscard]] size_t below(size_t count) { return byte() % count; }
    /// From `least` to `most`, in 256 steps.
    [[nodiscard]] double between(double least, double most) { return least + (most - least) * byte() / 255.0; }
    /// A multiple of a quarter in [-32, 32): equal and symmetric values are frequent.
    [[nodiscard]] double quarter() { return double(number<int8_t>()) / 4.0; }

private:
    std::string_view m_rest;
};

/// Meshes of up to some dozens of triangles as the readers make them of a file with these values: with duplicate, degenerate and
/// non-manifold faces, polygons, extreme coordinates, or solids with moved corners. None where the readers would refuse it.
[[nodiscard]] std::vector<MeshPointer> meshesOf(Values& values);
/// The first of them.
[[nodiscard]] MeshPointer meshOf(Values& values);

/// Instances of such meshes, scaled, mirrored and moved; null where there is no mesh.
[[nodiscard]] ScenePointer sceneOf(Values& values);

/// A view of a scene, at most 64 pixels wide and high: from around it, from one of its vertices, or from anywhere. None where the
/// camera would be refused.
[[nodiscard]] std::optional<View> viewOf(Values& values, const Scene& scene);

}  // namespace cullscope::fuzz
