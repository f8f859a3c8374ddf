#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// The defects of a file and how they were repaired. All counts are of faces or vertices of the file.
struct LoadReport {
    size_t facesRead = 0;             ///< face records in the file, before triangulation
    size_t trianglesMade = 0;         ///< triangles of all meshes made
    size_t degenerateFaces = 0;       ///< dropped: fewer than three different corners, or an area of exactly zero
    size_t duplicateFaces = 0;        ///< dropped: the same three vertices in the same direction as an earlier one
    size_t nonManifoldEdges = 0;      ///< kept and counted: edges with more than two triangles
    size_t nonFiniteVertices = 0;     ///< NaN, infinite or beyond 1e30; the faces that use them are dropped
    size_t outOfRangeFaces = 0;       ///< dropped: a corner's index names no vertex
    size_t unreferencedVertices = 0;  ///< dropped: no face of the file names them
    size_t normalsMade = 0;           ///< vertices whose normal was missing or unusable and was computed from the faces
    size_t bentByRounding = 0;        ///< kept: triangles with a side that rounding to floats changes by more than a tenth
    /// False where duplicate faces and non-manifold edges were not searched for: in meshes above kOptionalAnalysisLimit.
    bool analysed = true;
    std::vector<Message> remarks;  ///< other repairs or ignored parts, one sentence for each

    /// Whether the file had no defect.
    [[nodiscard]] bool clean() const;
    /// One sentence for each kind of repair, for a log or a message box; empty where the file had no defect.
    [[nodiscard]] std::vector<Message> sentences() const;
};

/// One object of a file (an OBJ's object or group; other formats have one).
struct LoadedObject {
    std::string name;
    MeshPointer mesh;
};

struct LoadedFile {
    std::vector<LoadedObject> objects;
    LoadReport report;
    std::string sha256;  ///< of the file's bytes, as unpacked, lower-case hexadecimal
};

struct LoadOptions {
    /// 0: three quarters of the machine's memory or of `ulimit -v`. A file that needs more is refused before anything is
    /// allocated for it, and so is a compressed one whose content is larger.
    size_t memoryLimitBytes = 0;
    bool hash = true;  ///< compute `sha256`
};

/// Reads OBJ, PLY (ASCII, binary, triangle strips), STL (ASCII, binary), OFF or OM; the format follows from the content where
/// that is unambiguous, else from the extension. A file compressed with gzip or xz is unpacked while it is
/// read. Coordinates are kept as floats about a double origin among most of an object's vertices; triangles that this rounding
/// changes by more than a tenth of their longest side are counted. Throws Error(Input) with one sentence that names file and line
/// or byte, the defect and what to do; Error(Interrupted) within 100 ms of a stop request. Never allocates memory by a count that
/// the file states but may not contain.
[[nodiscard]] LoadedFile loadMeshFile(const std::filesystem::path& path, const LoadOptions& options = {},
                                      const Progress& progress = {});

/// Extensions that loadMeshFile reads, lower case without a dot ("obj", "ply", …).
[[nodiscard]] const std::vector<std::string>& readableMeshExtensions();

}  // namespace cullscope
