#include "core/scene/scene.h"

#include <algorithm>
#include <cassert>

#include "core/base/sha256.h"

namespace cullscope {
namespace {

/// The mesh's bounds in its own double coordinates. The sum of origin and offset is rounded once more, so the box grows by that
/// rounding.
Box3 absoluteBounds(const TriangleMesh& mesh) {
    Box3 box = mesh.localBounds();
    if (box.empty()) return box;
    const Vec3 room =
        (glm::abs(mesh.origin()) + glm::max(glm::abs(box.min), glm::abs(box.max))) * std::numeric_limits<double>::epsilon();
    box.min += mesh.origin() - room;
    box.max += mesh.origin() + room;
    return box;
}

Sphere absoluteSphere(const TriangleMesh& mesh) {
    Sphere sphere = mesh.localSphere();
    const double magnitude = glm::length(mesh.origin()) + glm::length(sphere.centre) + sphere.radius;
    sphere.centre += mesh.origin();
    sphere.radius += 2.0 * magnitude * std::numeric_limits<double>::epsilon();
    return sphere;
}

/// Grows a box and a sphere by the same length.
void grow(Box3& box, Sphere& sphere, double by) {
    sphere.radius += by;
    if (box.empty()) return;
    box.min -= by;
    box.max += by;
}

Sphere around(const std::vector<Sphere>& spheres, const Box3& bounds) {
    if (bounds.empty()) return {};
    if (spheres.size() == 1) return spheres.front();
    Sphere sphere{bounds.centre(), 0.0};
    for (const Sphere& part : spheres)
        sphere.radius = std::max(sphere.radius, glm::length(part.centre - sphere.centre) + part.radius);
    return sphere;
}

}  // namespace

Scene::Scene(std::string name, std::vector<MeshPointer> meshes, std::vector<Instance> instances, const Scene* sameSurface,
             SceneRemarks remarks)
    : m_name(std::move(name)), m_meshes(std::move(meshes)), m_instances(std::move(instances)), m_remarks(std::move(remarks)) {
    std::vector<Box3> meshBoxes;
    std::vector<Sphere> meshSpheres;
    for (const MeshPointer& mesh : m_meshes) {
        meshBoxes.push_back(absoluteBounds(*mesh));
        meshSpheres.push_back(absoluteSphere(*mesh));
    }
    assert(!m_remarks.components || m_remarks.components->firstPart.size() == m_meshes.size() + 1);
    m_instanceBoxes.reserve(m_instances.size());
    m_instanceSpheres.reserve(m_instances.size());
    m_firstTriangle.reserve(m_instances.size() + 1);
    m_firstTriangle.push_back(0);
    std::vector<Sphere> exactSpheres;
    exactSpheres.reserve(m_instances.size());
    for (const Instance& instance : m_instances) {
        assert(instance.mesh < m_meshes.size());
        m_firstTriangle.push_back(m_firstTriangle.back() + m_meshes[instance.mesh]->triangleCount());
        m_instanceBoxes.push_back(transformed(meshBoxes[instance.mesh], instance.worldFromMesh));
        m_instanceSpheres.push_back(transformed(meshSpheres[instance.mesh], instance.worldFromMesh));
        m_bounds.add(m_instanceBoxes.back());
        exactSpheres.push_back(m_instanceSpheres.back());
        grow(m_instanceBoxes.back(), m_instanceSpheres.back(), pictureRounding(instance));
    }
    m_sphere = around(exactSpheres, m_bounds);
    size_t triangles = 0;
    const std::vector<bool> shown = shownMeshes();
    for (size_t i = 0; i < m_meshes.size(); ++i) triangles += shown[i] ? m_meshes[i]->triangleCount() : 0;
    m_topologyAsked = triangles <= kOptionalAnalysisLimit;
    if (sameSurface == nullptr) return;
    assert(triangleCount() == sameSurface->triangleCount());
    m_bounds = sameSurface->m_bounds;
    m_sphere = sameSurface->m_sphere;
}

double Scene::pictureRounding(const Instance& instance) const {
    const Sphere& sphere = m_meshes[instance.mesh]->localSphere();
    const Mat3 linear(instance.worldFromMesh);
    double stretch = 0.0;
    // Absolute values of the products: the sum is rounded in proportion to its terms, also where they cancel.
    Vec3 products(0.0);
    for (int column = 0; column < 3; ++column) {
        stretch = std::max(stretch, glm::length(linear[column]));
        products += glm::abs(linear[column]) * std::abs(sphere.centre[column]);
    }
    return 0x1p-19 * std::max(0.0, glm::length(products) - 0.5 * stretch * sphere.radius);
}

UpAxis guessedUpAxis(const Box3& bounds) {
    if (bounds.empty()) return UpAxis::Y;
    const Vec3 half = bounds.halfExtent();
    return half.z > 0.0 && 2.0 * half.z <= std::min(half.x, half.y) ? UpAxis::Z : UpAxis::Y;
}

size_t Scene::instanceOf(uint64_t triangle) const {
    assert(triangle < triangleCount());
    const auto after = std::upper_bound(m_firstTriangle.begin(), m_firstTriangle.end(), triangle);
    return static_cast<size_t>(after - m_firstTriangle.begin()) - 1;
}

std::span<const MeshPart> Scene::partsOf(size_t instance) const {
    if (!m_remarks.components) return {};
    const Components& components = *m_remarks.components;
    const size_t mesh = m_instances[instance].mesh, first = components.firstPart[mesh];
    return std::span(components.parts).subspan(first, components.firstPart[mesh + 1] - first);
}

std::map<std::string, uint64_t> Scene::partCounts() const {
    std::map<std::string, uint64_t> counts;
    if (!m_remarks.components) return counts;
    const Components& components = *m_remarks.components;
    std::vector<uint64_t> uses(m_meshes.size(), 0);
    for (const Instance& instance : m_instances) ++uses[instance.mesh];
    for (size_t mesh = 0, part = 0; part < components.parts.size(); ++part) {
        while (mesh < uses.size() && part >= components.firstPart[mesh + 1]) ++mesh;
        const uint64_t times = mesh < uses.size() ? uses[mesh] : 1;
        if (times > 0) counts[kindName(components.parts[part])] += times;
    }
    return counts;
}

std::vector<bool> Scene::shownMeshes() const {
    std::vector<bool> shown(m_meshes.size(), false);
    for (const Instance& instance : m_instances)
        if (m_meshes[instance.mesh]->triangleCount() > 0) shown[instance.mesh] = true;
    return shown;
}

std::string Scene::sha256() const {
    Sha256 hash;
    for (const MeshPointer& mesh : m_meshes) {
        const Vec3 origin = mesh->origin();
        hash.addValues(std::span<const double>(&origin.x, 3));
        hash.addValues(mesh->positions());
        hash.addValues(mesh->indices());
    }
    for (const Instance& instance : m_instances) {
        hash.addValues(std::span<const uint32_t>(&instance.mesh, 1));
        hash.addValues(std::span<const double>(&instance.worldFromMesh[0][0], 16));
    }
    return hash.hexadecimal();
}

size_t Scene::bytes() const {
    size_t bytes = m_instances.size() * (sizeof(Instance) + sizeof(Box3) + sizeof(Sphere) + sizeof(uint64_t));
    for (const MeshPointer& mesh : m_meshes) bytes += mesh->bytes();
    for (const Instance& instance : m_instances)
        if (instance.name.capacity() > std::string().capacity()) bytes += instance.name.capacity() + 1;
    if (m_remarks.components) bytes += m_remarks.components->bytes();
    return bytes;
}

bool Scene::frontFacesSuffice() const {
    for (size_t i = 0; i < m_instances.size(); ++i)
        if (meshOf(i).triangleCount() > 0 && !frontFacesSuffice(i)) return false;
    return m_topologyAsked;
}

bool Scene::hasNoPockets(const Progress& progress) const {
    for (size_t i = 0; i < m_instances.size(); ++i)
        if (meshOf(i).triangleCount() > 0 && meshOf(i).pockets(progress) != Pockets::None) return false;
    return true;
}

}  // namespace cullscope
