#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cullscope::benchmark {

/// The arrays that OpenMesh's PLY reader returns when no half-edge mesh is built.
struct BareMesh {
    std::vector<float> positions;
    std::vector<uint32_t> indices;
};

/// Reads a PLY file by OpenMesh's reader through an importer that only stores arrays: the reference for loadMeshFile's time.
[[nodiscard]] BareMesh loadByOpenMesh(const std::filesystem::path& path);

/// Writes a binary little-endian PLY of a wavy sheet with about `faces` triangles (float positions, uchar + int lists).
void writeSheet(const std::filesystem::path& path, uint64_t faces);

}  // namespace cullscope::benchmark
