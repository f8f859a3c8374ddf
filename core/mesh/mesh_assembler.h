#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/mesh/raw_mesh.h"

namespace cullscope {

/// Turns what the readers found into meshes and keeps the report: checks and repairs, cuts polygons, moves the origin to the
/// object's centre, makes normals. The repairs happen in place, so that little more memory is needed than the mesh has.
class MeshAssembler {
public:
    MeshAssembler(std::string fileName, const LoadOptions& options, const Progress& progress);

    /// Adds one object; objects without a usable face leave only their counts in the report. `from` and `to`: the share of
    /// all objects' work that this one is, for the progress.
    void add(RawMesh raw, double from = 0.0, double to = 1.0);
    /// Refuses the file when it needs more memory than allowed: `bytes` beside the objects that are already made.
    void requireMemory(uint64_t bytes) const;
    /// Refuses the file when it holds no triangle; gives the objects otherwise, with names that differ.
    [[nodiscard]] std::vector<LoadedObject> finish();

    LoadReport report;

private:
    void nameUniquely(std::string& name);

    std::string m_fileName;
    uint64_t m_memoryLimit;
    Progress m_progress;
    uint64_t m_bytesMade = 0;
    size_t m_unusableNormals = 0;
    size_t m_fannedPolygons = 0;
    std::vector<LoadedObject> m_objects;
    std::unordered_map<std::string, int> m_nextNumber;  ///< by name: the number that its next namesake gets
};

}  // namespace cullscope
