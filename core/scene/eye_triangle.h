#pragma once

#include <array>
#include <optional>

#include "core/scene/camera.h"
#include "core/scene/scene.h"

namespace cullscope {

/// The triangles of one instance in world axes with the origin at an eye. Translations are summed in double before any rounding.
/// The scene must outlive this object.
class InstanceFromEye {
public:
    InstanceFromEye(const Scene& scene, size_t instance, const Vec3& eye);
    /// From a camera's eye; facing is judged along the view direction where the camera is a parallel one.
    InstanceFromEye(const Scene& scene, size_t instance, const Camera& camera);

    /// The corners of a triangle, counted from 0 within the instance, in the mesh's order.
    [[nodiscard]] std::array<Vec3, 3> corners(uint64_t triangle) const;
    /// Whether a triangle is back-facing for the eye, in double arithmetic; a mirrored instance reverses the winding, as in the
    /// renderer. False for a triangle that is seen exactly edge-on or has no area.
    [[nodiscard]] bool facesAway(uint64_t triangle) const;

private:
    const TriangleMesh& m_mesh;
    Mat3 m_linear;
    Vec3 m_translation;
    bool m_mirrored;
    std::optional<Vec3> m_sight;  ///< the direction of all lines of sight; none: they begin at the eye
};

}  // namespace cullscope
