#include "core/scene/plant/kit.h"

#include <algorithm>
#include <cmath>

namespace cullscope::plant {

Mat4 frame(const Vec3& origin, const Vec3& z, const Vec3& x) {
    return {Vec4(x, 0.0), Vec4(glm::cross(z, x), 0.0), Vec4(z, 0.0), Vec4(origin, 1.0)};
}

Mat4 frame(const Vec3& origin, const Vec3& z) {
    const Vec3 other = std::abs(z.z) > 0.9 ? Vec3(1.0, 0.0, 0.0) : Vec3(0.0, 0.0, 1.0);
    return frame(origin, z, glm::normalize(glm::cross(other, z)));
}

Mat4 at(double x, double y, double z) { return frame({x, y, z}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}); }
Mat4 alongX(double x, double y, double z) { return frame({x, y, z}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}); }
Mat4 alongY(double x, double y, double z) { return frame({x, y, z}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}); }

Solid rod(const Vec3& from, const Vec3& to, double radius) {
    const double length = glm::length(to - from);
    return {primitive::Cylinder{radius, length}, frame(0.5 * (from + to), (to - from) / length)};
}

Solid box(const Vec3& centre, const Vec3& size) { return {primitive::Box{size}, at(centre.x, centre.y, centre.z)}; }

uint32_t Kit::beginGroup(std::string name, uint32_t parent) {
    m_components.groups.push_back({std::move(name), parent});
    m_numbers.clear();
    return uint32_t(m_components.groups.size() - 1);
}

uint32_t Kit::newMesh(const char* kind, uint32_t segments, const Solids& solids) {
    primitive::Surface surface;
    const bool byError = m_chordError > 0.0 && segments != kHexagon;
    const primitive::Fineness fineness = byError ? primitive::Fineness{m_chordError, 0} : primitive::Fineness{1.0, segments};
    for (const Solid& solid : solids) {
        const auto first = uint32_t(surface.triangles.size() / 3);
        primitive::appendSurface(surface, solid.shape, fineness, solid.place);
        m_components.parts.push_back(
            {MeshPart::Kind::Solid, solid.shape, solid.place, first, uint32_t(surface.triangles.size() / 3) - first});
    }
    m_components.endMesh();
    m_meshes.push_back(primitive::meshOf(surface, kind));
    return uint32_t(m_meshes.size() - 1);
}

void Kit::addInstance(uint32_t mesh, const Mat4& place, const char* kind) {
    auto number = std::ranges::find(m_numbers, kind, &std::pair<const char*, uint32_t>::first);
    if (number == m_numbers.end()) {
        m_numbers.emplace_back(kind, 0);
        number = m_numbers.end() - 1;
    }
    const ObjectGroup& group = m_components.groups.back();
    std::string name = group.name;
    name.append("/").append(kind).append(" ").append(std::to_string(++number->second));
    m_instances.push_back({mesh, place, std::move(name), uint32_t(m_components.groups.size() - 1)});
}

ScenePointer Kit::finish(std::string name) {
    SceneRemarks remarks;
    remarks.up = UpAxis::Z;
    m_components.parts.shrink_to_fit();
    remarks.components = std::make_shared<const Components>(std::move(m_components));
    m_instances.shrink_to_fit();
    return std::make_shared<const Scene>(std::move(name), std::move(m_meshes), std::move(m_instances), nullptr,
                                         std::move(remarks));
}

}  // namespace cullscope::plant
