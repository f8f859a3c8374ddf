#include "tests/benchmark/frustum_hierarchy.h"

namespace cullscope::benchmark {
namespace {

MeshPointer meshOf(std::vector<Vec3f> positions, std::vector<uint32_t> indices) {
    TriangleMesh::Data data;
    data.positions = std::move(positions);
    data.indices = std::move(indices);
    return std::make_shared<TriangleMesh>(std::move(data));
}

/// A triangle from corner to corner of the cube [-1, 1]³, which is its box.
MeshPointer cubeSpanningTriangle() { return meshOf({{-1, -1, -1}, {1, 1, 1}, {-1, 1, 1}}, {0, 1, 2}); }

/// Two triangles between the six points of the unit sphere on the axes: the sphere is their bounding sphere, the cube [-1, 1]³
/// their box.
MeshPointer sphereSpanningTriangles() {
    return meshOf({{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 1, 2, 3, 4, 5});
}

Instance placed(const Vec3& centre, const Vec3& half) {
    Mat4 transform(1.0);
    for (int axis = 0; axis < 3; ++axis) transform[axis][axis] = half[axis];
    transform[3] = Vec4(centre, 1.0);
    return {0, transform, {}};
}

ScenePointer sceneWith(const std::vector<Box3>& boxes) {
    std::vector<Instance> instances;
    instances.reserve(boxes.size());
    for (const Box3& box : boxes) instances.push_back(placed(box.centre(), box.halfExtent()));
    return std::make_shared<Scene>("boxes", std::vector<MeshPointer>{cubeSpanningTriangle()}, std::move(instances));
}

ScenePointer sceneWith(const std::vector<Sphere>& spheres) {
    std::vector<Instance> instances;
    instances.reserve(spheres.size());
    for (const Sphere& sphere : spheres) instances.push_back(placed(sphere.centre, Vec3(sphere.radius)));
    return std::make_shared<Scene>("spheres", std::vector<MeshPointer>{sphereSpanningTriangles()}, std::move(instances));
}

}  // namespace

Hierarchy::Hierarchy(ScenePointer scene)
    : m_scene(std::move(scene)), m_octree(*m_scene), m_memory(m_octree.nodes().size(), m_scene->instances().size()) {}

Hierarchy::Hierarchy(const std::vector<Box3>& boxes) : Hierarchy(sceneWith(boxes)) {}

Hierarchy::Hierarchy(const std::vector<Sphere>& spheres) : Hierarchy(sceneWith(spheres)) {}

size_t Hierarchy::kept(const View& view) {
    FrameContext frame(*m_scene, view, false);
    return keptObjects(m_octree, frame, nullptr, {true, &m_memory}).size();
}

}  // namespace cullscope::benchmark
