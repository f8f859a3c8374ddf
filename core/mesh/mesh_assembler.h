#pragma once

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/mesh/raw_mesh.h"

namespace cullscope {

/// Makes meshes of the objects that the readers find, and keeps the report: checks and repairs faces, triangulates polygons,
/// moves the origin to where most of an object is, computes normals. It works in place, so that it needs little more memory than
/// the mesh.
class MeshAssembler {
public:
    MeshAssembler(std::string fileName, const LoadOptions& options, const Progress& progress);

    /// Adds one object; an object without a usable face only adds to the counts of the report. Returns whether it has one.
    /// `from` and `to`: this object's part of the progress of all objects.
    bool add(RawMesh raw, double from = 0.0, double to = 1.0);
    /// Throws Error(Input) when the file needs more memory than allowed: `bytes` in addition to the objects already made.
    void requireMemory(uint64_t bytes) const;
    /// Throws Error(Input) when the file has no triangle; else returns the objects, with distinct names.
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
    std::unordered_map<std::string, int> m_nextNumber;  ///< by name: the number appended to the next object of the same name
};

}  // namespace cullscope
