#pragma once

#include <array>

#include "core/scene/scene.h"

namespace cullscope {

/// One instance's triangles in world axes with the origin at an eye: translations are summed in double before anything is rounded
/// away. The scene must outlive it.
class InstanceFromEye {
public:
    InstanceFromEye(const Scene& scene, size_t instance, const Vec3& eye);

    /// The corners of a triangle, counted from 0 within the instance, in the mesh's order.
    [[nodiscard]] std::array<Vec3, 3> corners(uint64_t triangle) const;
    /// Whether a triangle turns its back to the eye, in double arithmetic; a mirrored instance turns its triangles around, as in
    /// the renderer. False for one that is seen exactly edge-on or has no area.
    [[nodiscard]] bool facesAway(uint64_t triangle) const;

private:
    const TriangleMesh& m_mesh;
    Mat3 m_linear;
    Vec3 m_translation;
    bool m_mirrored;
};

}  // namespace cullscope
