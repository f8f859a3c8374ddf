#pragma once

#include <filesystem>

#include "core/scene/scene_source.h"
#include "tests/support/spherical_scenes.h"

namespace cullscope::test {

/// A mesh's triangles with every corner moved and the winding of some reversed.
template <typename Move, typename Turned>
MeshPointer changed(const TriangleMesh& mesh, const Move& move, const Turned& turned) {
    std::vector<Vec3f> positions;
    for (const Vec3f& position : mesh.positions()) positions.push_back(Vec3f(move(Vec3(position))));
    std::vector<uint32_t> indices(mesh.indices().begin(), mesh.indices().end());
    for (size_t i = 0; i + 2 < indices.size(); i += 3)
        if (turned(i / 3)) std::swap(indices[i + 1], indices[i + 2]);
    return meshOf(std::move(positions), std::move(indices));
}

inline constexpr auto kStay = [](const Vec3& p) { return p; };
inline constexpr auto kNone = [](size_t) { return false; };
inline constexpr auto kEvery = [](size_t) { return true; };

/// The triangles of several meshes as one mesh.
inline MeshPointer joined(const std::vector<MeshPointer>& meshes) {
    std::vector<Vec3f> positions;
    std::vector<uint32_t> indices;
    for (const MeshPointer& mesh : meshes) {
        const auto first = uint32_t(positions.size());
        positions.insert(positions.end(), mesh->positions().begin(), mesh->positions().end());
        for (const uint32_t index : mesh->indices()) indices.push_back(first + index);
    }
    return meshOf(std::move(positions), std::move(indices));
}

/// A square wavy sheet, open on all sides.
inline MeshPointer sheetMesh(uint32_t side) {
    std::vector<Vec3f> positions;
    std::vector<uint32_t> indices;
    for (uint32_t y = 0; y <= side; ++y)
        for (uint32_t x = 0; x <= side; ++x) {
            const double u = 2.0 * x / side - 1.0, v = 2.0 * y / side - 1.0;
            positions.push_back(Vec3f(Vec3(u, v, 0.2 * std::sin(5.0 * u) * std::cos(4.0 * v))));
        }
    for (uint32_t y = 0; y < side; ++y)
        for (uint32_t x = 0; x < side; ++x) {
            const uint32_t a = y * (side + 1) + x, b = a + 1, c = a + side + 1, d = c + 1;
            indices.insert(indices.end(), {a, b, d, a, d, c});
        }
    return meshOf(std::move(positions), std::move(indices));
}

/// Half of a sphere without thickness.
inline MeshPointer openBowlMesh(size_t triangles) {
    const MeshPointer sphere = sphereMesh(2 * triangles);
    std::vector<uint32_t> indices;
    for (size_t i = 0; i + 2 < sphere->indices().size(); i += 3) {
        const auto corner = [&](size_t k) { return sphere->positions()[sphere->indices()[i + k]]; };
        if (corner(0).z + corner(1).z + corner(2).z < 0.0f)
            for (size_t k = 0; k < 3; ++k) indices.push_back(sphere->indices()[i + k]);
    }
    return meshOf({sphere->positions().begin(), sphere->positions().end()}, std::move(indices));
}

/// A real mesh where its file is installed, else a substitute.
inline MeshPointer realMesh(const std::string& file, const std::string& count, const MeshPointer& standIn) {
    const std::string path = CULLSCOPE_SOURCE_DIR "/../shared/models/" + file;
    if (!std::filesystem::exists(path)) return standIn;
    return openScene(count.empty() ? path : "mesh:" + path + ",triangles=" + count).scene->meshes().front();
}

struct NamedMesh {
    const char* name;
    MeshPointer mesh;
};

/// The meshes on which `spherical-lossless` must lose no pixel. `large`: with those of a million triangles.
inline std::vector<NamedMesh> losslessMeshes(bool large) {
    const MeshPointer sphere = sphereMesh(4'000), star = starMesh(5, 12'000);
    const auto half = [](double by) { return [by](const Vec3& p) { return Vec3(0.4 * p.x + by, 0.4 * p.y, 0.4 * p.z); }; };
    // Reading and simplifying files takes the sanitizers longer than the views, and other tests do both.
    const bool few = fewSamples();
    std::vector<NamedMesh> meshes{
        {"bunny", few ? realMesh("bunny-5000.obj", "", bumpyMesh(4, 5'000, 0.03))
                      : realMesh("bunny.obj", large ? "144046" : "30000", bumpyMesh(4, 144'000, 0.03))},
        {"dragon", few ? knotMesh(10'000) : realMesh("clean/classics/dragon-50002v-100000f.ply", "", knotMesh(100'000))},
        {"torus", torusMesh(30'000)},
        {"knot", knotMesh(30'000)},
        {"sheet", sheetMesh(80)},
        {"open bowl", openBowlMesh(8'000)},
        {"two parts", joined({changed(*sphere, half(-0.9), kNone), changed(*star, half(1.3), kNone)})},
        {"star", star},
        {"another star", bumpyMesh(9, 20'000, 0.5)},
        {"inverted", changed(*star, kStay, kEvery)},
        {"needle", changed(
                       *sphereMesh(10'000), [](const Vec3& p) { return Vec3(1e-3 * p.x, p.y, 2e-3 * p.z); }, kNone)},
        {"cube", boxMesh({-1, -1, -1}, {1, 1, 1})},
        {"inconsistent", changed(*star, kStay, [](size_t i) { return i % 7 == 3; })},
        {"thick bowl", bowlMesh(20'000)},
    };
    if (large) meshes.push_back({"a million", starMesh(3, 1'000'000)});
    return meshes;
}

}  // namespace cullscope::test
