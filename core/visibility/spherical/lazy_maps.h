#pragma once

#include <concepts>
#include <memory>
#include <mutex>

#include "core/spatial/spherical_maps.h"

namespace cullscope::spherical {

/// A mesh's spherical maps for display. A strategy that works with maps passes its own. For other strategies they are built at
/// the first access, at the paper's resolution at most, which takes about half a microsecond per triangle. Thread-safe.
class LazyMaps {
public:
    LazyMaps() = default;
    template <std::convertible_to<SphericalMapsPointer> Pointer>
    LazyMaps(const Pointer& ready) : m_mesh(&ready->mesh()), m_ready(ready) {}  // NOLINT: ready maps are maps
    explicit LazyMaps(MeshPointer mesh) : m_mesh(mesh.get()), m_made(std::make_shared<Made>(std::move(mesh))) {}

    [[nodiscard]] const TriangleMesh& mesh() const { return *m_mesh; }
    [[nodiscard]] const Sphere& sphere() const { return m_ready ? m_ready->sphere() : m_mesh->localSphere(); }
    [[nodiscard]] Mat3 meshFromMap() const { return m_ready ? m_ready->meshFromMap() : Mat3(1.0); }
    [[nodiscard]] const SphericalMaps& operator*() const;
    [[nodiscard]] const SphericalMaps* operator->() const { return &**this; }

    bool operator==(const LazyMaps&) const = default;

private:
    struct Made {
        explicit Made(MeshPointer ofMesh) : mesh(std::move(ofMesh)) {}

        std::once_flag once;
        MeshPointer mesh;
        SphericalMapsPointer maps;
    };

    const TriangleMesh* m_mesh = nullptr;
    SphericalMapsPointer m_ready;
    std::shared_ptr<Made> m_made;
};

}  // namespace cullscope::spherical
