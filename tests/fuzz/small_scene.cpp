#include "tests/fuzz/small_scene.h"

#include <cmath>

#include "core/mesh/mesh_assembler.h"
#include "core/mesh/parametric.h"
#include "tests/fuzz/support.h"

namespace cullscope::fuzz {
namespace {

enum class Coordinates { Quarters, NearQuarters, Floats, Doubles };

Vec3 pointOf(Values& values, Coordinates kind) {
    Vec3 point(0.0);
    for (int axis = 0; axis < 3; ++axis) switch (kind) {
            case Coordinates::Quarters:
                point[axis] = values.quarter();
                break;
            case Coordinates::NearQuarters:
                point[axis] = values.quarter() + std::ldexp(double(values.number<int8_t>()), -30);
                break;
            case Coordinates::Floats:
                point[axis] = values.number<float>();
                break;
            case Coordinates::Doubles:
                point[axis] = values.number<double>();
                break;
        }
    return point;
}

/// Any faces between any points.
RawMesh anyMesh(Values& values) {
    constexpr size_t kMostVertices = 24, kMostFaces = 24, kMostCorners = 6;
    RawMesh raw;
    const auto kind = Coordinates(values.below(4));
    const Vec3 away(values.below(8) == 7 ? 1e7 : 0.0);
    const size_t vertices = 3 + values.below(kMostVertices);
    const size_t faces = 1 + values.below(kMostFaces);
    for (size_t i = 0; i < vertices; ++i) raw.wide.push_back(pointOf(values, kind) + away);
    for (size_t i = 0; i < faces && !values.atEnd(); ++i) {
        std::vector<uint32_t> corners(3);
        // The first corner's byte says beyond the vertices that the face is a polygon.
        const uint8_t first = values.byte();
        if (first >= 192) corners.resize(4 + first % (kMostCorners - 3));
        corners[0] = uint32_t(first % vertices);
        for (size_t corner = 1; corner < corners.size(); ++corner) corners[corner] = uint32_t(values.below(vertices));
        raw.addFace(corners);
    }
    return raw;
}

/// A closed solid with some corners moved: what kernels and horizons are built for.
RawMesh solid(Values& values) {
    constexpr size_t kTriangles = 80;
    MeshPointer mesh;
    switch (values.below(4)) {
        case 0:
            mesh = sphereMesh(kTriangles);
            break;
        case 1:
            mesh = starMesh(values.byte(), kTriangles);
            break;
        case 2:
            mesh = bowlMesh(kTriangles);
            break;
        default:
            mesh = torusMesh(kTriangles);
    }
    RawMesh raw;
    for (size_t vertex = 0; vertex < mesh->vertexCount(); ++vertex) raw.wide.push_back(mesh->position(vertex));
    for (size_t moved = values.below(16); moved > 0; --moved)
        raw.wide[values.below(raw.wide.size())] = pointOf(values, Coordinates::Quarters);
    const size_t missing = 3 * values.below(4);
    raw.triangles.assign(mesh->indices().begin(), mesh->indices().end() - std::ptrdiff_t(missing));
    return raw;
}

Vec3 scaleOf(Values& values) {
    constexpr std::array kScales{1.0, 1.0, 0.5, 4.0, -1.0, 1e-3, 1e3, 1e6};
    const double scale = kScales[values.below(kScales.size())];
    return values.below(4) == 3 ? Vec3(scale, std::abs(scale), 1.0) : Vec3(scale);
}

}  // namespace

std::vector<MeshPointer> meshesOf(Values& values) {
    constexpr size_t kMostMeshes = 3;
    LoadOptions options;
    options.memoryLimitBytes = kMemory;
    std::vector<MeshPointer> meshes;
    accepted({ErrorKind::Input}, [&] {
        MeshAssembler assembler("input", options, {});
        for (size_t count = 1 + values.below(kMostMeshes); count > 0; --count) {
            RawMesh raw = values.below(2) == 0 ? anyMesh(values) : solid(values);
            raw.name = "object";
            assembler.add(std::move(raw));
        }
        for (LoadedObject& object : assembler.finish()) meshes.push_back(std::move(object.mesh));
    });
    return meshes;
}

MeshPointer meshOf(Values& values) {
    std::vector<MeshPointer> meshes = meshesOf(values);
    return meshes.empty() ? nullptr : meshes.front();
}

ScenePointer sceneOf(Values& values) {
    constexpr size_t kMostInstances = 5;
    std::vector<MeshPointer> meshes = meshesOf(values);
    if (meshes.empty()) return nullptr;
    std::vector<Instance> instances;
    for (size_t count = 1 + values.below(kMostInstances); count > 0; --count) {
        const auto mesh = uint32_t(values.below(meshes.size()));
        Mat4 place(1.0);
        const Vec3 scale = scaleOf(values);
        for (int axis = 0; axis < 3; ++axis) place[axis][axis] = scale[axis];
        for (int axis = 0; axis < 3; ++axis) place[3][axis] = values.quarter();
        instances.push_back({mesh, place, "object " + std::to_string(count)});
    }
    SceneRemarks remarks;
    for (size_t count = values.below(4); count > 0; --count) {
        const Vec3 normal = pointOf(values, Coordinates::Quarters);
        if (normal != Vec3(0.0)) remarks.planes.push_back({"plane " + std::to_string(count), normal, values.quarter()});
    }
    return std::make_shared<const Scene>("input", std::move(meshes), std::move(instances), nullptr, std::move(remarks));
}

std::optional<View> viewOf(Values& values, const Scene& scene) {
    constexpr size_t kMostPixels = 64;
    const Sphere& sphere = scene.boundingSphere();
    Camera camera;
    const size_t from = values.below(4);
    if (from == 0) {
        camera.eye = sphere.centre + Vec3(values.quarter(), values.quarter(), values.quarter()) * (sphere.radius / 8.0);
    } else if (from == 1) {
        const size_t instance = values.below(std::min<size_t>(scene.instances().size(), 256));
        const TriangleMesh& mesh = scene.meshOf(instance);
        const size_t vertex = values.below(std::min<size_t>(mesh.vertexCount(), 256));
        camera.eye = Vec3(scene.instances()[instance].worldFromMesh * Vec4(mesh.position(vertex), 1.0));
    } else {
        camera.eye = pointOf(values, from == 2 ? Coordinates::Quarters : Coordinates::Doubles);
    }
    camera.target = values.below(2) == 0 ? sphere.centre : camera.eye + pointOf(values, Coordinates::Quarters);
    camera.fovy = Angle::fromDegrees(values.between(0.5, 179.0));
    camera.nearDistance = sphere.radius * std::pow(10.0, values.between(-6.0, 1.0));
    camera.farDistance = camera.nearDistance * std::pow(10.0, values.between(0.0, 8.0));
    const Viewport size{int(1 + values.below(kMostPixels)), int(1 + values.below(kMostPixels))};
    std::optional<View> view;
    accepted({ErrorKind::Usage}, [&] { view.emplace(camera, size); });
    return view;
}

}  // namespace cullscope::fuzz
