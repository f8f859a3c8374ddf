#include "tests/support/spherical_meshes.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/mesh/load.h"
#include "core/mesh/parametric.h"
#include "tests/support/long_mode.h"
#include "tests/support/test_scenes.h"

namespace cullscope::test {

namespace {

const std::filesystem::path kClean = CULLSCOPE_SOURCE_DIR "/../shared/models/clean";

// In small samples: every kind of mesh, none of more triangles.
constexpr size_t kMostTrianglesOfFew = 2'000;

void addClean(std::vector<MeshPointer>& meshes) {
    if (!std::filesystem::is_directory(kClean)) return;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kClean)) {
        const std::string extension = entry.path().extension().string();
        if (entry.is_regular_file() && extension != ".xz" && extension != ".gz") files.push_back(entry.path());
    }
    std::sort(files.begin(), files.end());
    for (const std::filesystem::path& file : files)
        for (const LoadedObject& object : loadMeshFile(file).objects)
            if (object.mesh->triangleCount() > 0 && !(fewSamples() && object.mesh->triangleCount() > kMostTrianglesOfFew))
                meshes.push_back(object.mesh);
}

}  // namespace

MeshPointer looseTriangles(const std::vector<std::array<Vec3f, 3>>& triangles) {
    std::vector<Vec3f> positions;
    std::vector<uint32_t> indices;
    for (const auto& triangle : triangles)
        for (const Vec3f& corner : triangle) {
            indices.push_back(uint32_t(positions.size()));
            positions.push_back(corner);
        }
    return meshOf(std::move(positions), std::move(indices));
}

MeshPointer awkwardTriangles() {
    std::vector<std::array<Vec3f, 3>> triangles;
    for (const float side : {1.0f, -1.0f}) {
        triangles.push_back({Vec3f(0.3f, 0.1f, side), Vec3f(-0.2f, 0.3f, side), Vec3f(-0.1f, -0.3f, side)});  // over a pole
        triangles.push_back({Vec3f(0.0f, 0.0f, side), Vec3f(0.5f, 0.2f, side), Vec3f(0.1f, 0.6f, side)});     // a corner on it
        triangles.push_back({Vec3f(-0.4f, 0.0f, side), Vec3f(0.7f, 0.0f, side), Vec3f(0.1f, 0.6f, side)});  // an edge through it
        triangles.push_back({Vec3f(1e-4f, 1e-4f, side), Vec3f(2e-4f, 1e-4f, side), Vec3f(1e-4f, 3e-4f, side)});  // near it
    }
    // Across the seam, high and low, and with an edge on it.
    triangles.push_back({Vec3f(1.0f, -0.2f, 0.1f), Vec3f(1.0f, 0.2f, 0.0f), Vec3f(1.0f, 0.0f, 0.4f)});
    triangles.push_back({Vec3f(0.1f, -0.02f, 0.9f), Vec3f(0.1f, 0.02f, 0.95f), Vec3f(0.2f, 0.0f, 0.9f)});
    triangles.push_back({Vec3f(0.8f, 0.0f, 0.2f), Vec3f(0.9f, 0.0f, -0.3f), Vec3f(0.7f, 0.5f, 0.0f)});
    triangles.push_back({Vec3f(0.8f, -1e-12f, 0.2f), Vec3f(0.9f, -1e-12f, -0.3f), Vec3f(0.7f, -0.5f, 0.0f)});
    // In a plane through the centre: beside the centre, and around it.
    triangles.push_back({Vec3f(0.5f, 0.5f, 0.0f), Vec3f(0.9f, 0.2f, 0.0f), Vec3f(0.3f, 0.8f, 0.0f)});
    triangles.push_back({Vec3f(0.9f, 0.1f, 0.0f), Vec3f(-0.5f, 0.7f, 0.0f), Vec3f(-0.4f, -0.8f, 0.0f)});
    triangles.push_back({Vec3f(0.5f, 0.3f, 0.2f), Vec3f(-0.5f, -0.3f, -0.2f), Vec3f(0.1f, 0.6f, -0.4f)});
    // Almost around the centre, and with a corner at it.
    triangles.push_back({Vec3f(0.9f, 0.1f, 0.01f), Vec3f(-0.5f, 0.7f, 0.02f), Vec3f(-0.4f, -0.8f, 0.01f)});
    triangles.push_back({Vec3f(0.0f, 0.0f, 0.0f), Vec3f(0.4f, 0.7f, 0.2f), Vec3f(-0.3f, 0.6f, 0.5f)});
    // A needle, a segment and a point.
    triangles.push_back({Vec3f(-0.9f, 0.1f, 0.1f), Vec3f(0.2f, 0.9f, 0.3f), Vec3f(-0.9f, 0.1f, 0.100001f)});
    triangles.push_back({Vec3f(-0.6f, 0.1f, 0.1f), Vec3f(0.2f, -0.7f, 0.3f), Vec3f(-0.6f, 0.1f, 0.1f)});
    triangles.push_back({Vec3f(0.2f, -0.7f, 0.3f), Vec3f(0.2f, -0.7f, 0.3f), Vec3f(0.2f, -0.7f, 0.3f)});
    // Corners that put the bounding sphere's centre at the origin.
    for (const float x : {1.0f, -1.0f})
        for (const float y : {1.0f, -1.0f})
            for (const float z : {1.0f, -1.0f})
                triangles.push_back({Vec3f(x, y, z), 0.99f * Vec3f(x, y, z), Vec3f(x, y, 0.98f * z)});
    return looseTriangles(triangles);
}

MeshPointer randomTriangles(uint64_t seed, size_t count) {
    Random random(seed);
    std::vector<std::array<Vec3f, 3>> triangles;
    for (size_t i = 0; i < count; ++i) {
        // One random number per statement: within one expression the compiler chooses the order.
        const double away = random.unit();
        const Vec3 place = away * random.direction();
        const double size = std::pow(10.0, random.between(-4.0, 0.3));
        std::array<Vec3f, 3> triangle;
        for (Vec3f& corner : triangle) {
            const double reach = size * random.unit();
            corner = Vec3f(place + reach * random.direction());
        }
        triangles.push_back(triangle);
    }
    return looseTriangles(triangles);
}

std::vector<MeshPointer> mapTestMeshes() {
    const size_t triangles = howMany(5'000, 5'000);
    std::vector<MeshPointer> meshes{sphereMesh(triangles), torusMesh(triangles), knotMesh(2 * triangles), starMesh(7, triangles),
                                    teapotMesh(triangles), awkwardTriangles(),   randomTriangles(11, 400)};
    addClean(meshes);
    return meshes;
}

}  // namespace cullscope::test
