#include "core/scene/eye_triangle.h"

namespace cullscope {

InstanceFromEye::InstanceFromEye(const Scene& scene, size_t instance, const Vec3& eye)
    : m_mesh(scene.meshOf(instance)), m_linear(scene.instances()[instance].worldFromMesh) {
    m_translation = Vec3(scene.instances()[instance].worldFromMesh[3]) - eye + m_linear * m_mesh.origin();
    m_mirrored = glm::determinant(m_linear) < 0.0;
}

InstanceFromEye::InstanceFromEye(const Scene& scene, size_t instance, const Camera& camera)
    : InstanceFromEye(scene, instance, camera.eye) {
    if (camera.projection == ProjectionKind::Parallel) m_sight = camera.target - camera.eye;
}

std::array<Vec3, 3> InstanceFromEye::corners(uint64_t triangle) const {
    std::array<Vec3, 3> corners;
    for (size_t i = 0; i < 3; ++i)
        corners[i] = m_linear * Vec3(m_mesh.positions()[m_mesh.indices()[3 * triangle + i]]) + m_translation;
    return corners;
}

bool InstanceFromEye::facesAway(uint64_t triangle) const {
    const auto [a, b, c] = corners(triangle);
    // A line of sight from the origin, which is the eye, to a corner: a value above 0 means that it meets the back of a
    // counter-clockwise triangle.
    const double behind = glm::dot(glm::cross(b - a, c - a), m_sight.value_or(a));
    return m_mirrored ? behind < 0.0 : behind > 0.0;
}

}  // namespace cullscope
