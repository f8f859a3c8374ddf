#include "core/spatial/occupancy.h"

#include <algorithm>

#include "core/mesh/primitive/occupancy.h"

namespace cullscope {
namespace {

/// By how much a transform stretches along its axes, at most.
double largestStretch(const Mat4& transform) {
    double largest = 0.0;
    for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, glm::length(Vec3(transform[axis])));
    return largest;
}

/// The largest half extent of a box that a transform turns and stretches.
double halfExtentOf(const Box3& box, const Mat4& transform) {
    if (box.empty()) return 0.0;
    const Vec3 half = box.halfExtent();
    double value = 0.0;
    for (int axis = 0; axis < 3; ++axis) value = std::max(value, half[axis] * glm::length(Vec3(transform[axis])));
    return value;
}

Box3 boxOfTriangles(const TriangleMesh& mesh, const MeshPart& part) {
    Box3 box;
    for (uint64_t i = 3 * uint64_t(part.firstTriangle); i < 3 * uint64_t(part.firstTriangle + part.triangleCount); ++i)
        box.add(Vec3(mesh.positions()[mesh.indices()[i]]));
    return box;
}

/// The largest value of an instance's parts.
double ofParts(const TriangleMesh& mesh, std::span<const MeshPart> parts, const Mat4& worldFromMesh) {
    double value = 0.0;
    for (const MeshPart& part : parts) {
        if (part.triangleCount == 0) continue;
        value = std::max(value, part.kind == MeshPart::Kind::Solid
                                    ? primitive::occupancy(part.solid) * largestStretch(worldFromMesh * part.meshFromSolid)
                                    : halfExtentOf(boxOfTriangles(mesh, part), worldFromMesh));
    }
    return value;
}

}  // namespace

std::vector<double> occupancyValues(const Scene& scene) {
    std::vector<double> values;
    values.reserve(scene.instances().size());
    for (size_t i = 0; i < scene.instances().size(); ++i) {
        const TriangleMesh& mesh = scene.meshOf(i);
        const Mat4& placed = scene.instances()[i].worldFromMesh;
        const std::span<const MeshPart> parts = scene.partsOf(i);
        if (mesh.triangleCount() == 0)
            values.push_back(0.0);
        else if (parts.empty())
            values.push_back(halfExtentOf(mesh.localBounds(), placed));
        else
            values.push_back(ofParts(mesh, parts, placed));
    }
    return values;
}

}  // namespace cullscope
