#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// What was wrong with a file and what became of it. All counts are of faces or vertices of the file.
struct LoadReport {
    size_t facesRead = 0;             ///< face records in the file, before triangulation
    size_t trianglesMade = 0;         ///< triangles that the meshes hold
    size_t degenerateFaces = 0;       ///< dropped: fewer than three different corners, or an area of exactly zero
    size_t duplicateFaces = 0;        ///< dropped: the same three vertices in the same direction as an earlier one
    size_t nonManifoldEdges = 0;      ///< kept and counted: edges with more than two triangles
    size_t nonFiniteVertices = 0;     ///< NaN, infinite or beyond 1e30; the faces that use them are dropped
    size_t outOfRangeFaces = 0;       ///< dropped: a corner's index names no vertex
    size_t unreferencedVertices = 0;  ///< dropped: no face of the file names them
    size_t normalsMade = 0;           ///< vertices whose normal was missing or unusable and was made from the faces
    /// False where duplicate faces and non-manifold edges were not looked for: in meshes above kOptionalAnalysisLimit.
    bool analysed = true;
    std::vector<Message> remarks;  ///< anything else that was ignored or mended, a sentence each

    /// Whether anything was repaired, dropped or found wrong.
    [[nodiscard]] bool clean() const;
    /// One sentence for each kind of repair, for a log or a message box; empty where nothing was wrong.
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
    std::string sha256;  ///< of the file's bytes, lower-case hexadecimal
};

struct LoadOptions {
    /// 0: three quarters of the machine's memory. A file that needs more is refused before anything is allocated for it.
    size_t memoryLimitBytes = 0;
    bool hash = true;  ///< compute `sha256`
};

/// Reads OBJ, PLY (ASCII, binary, triangle strips), STL (ASCII, binary), OFF or OM; the content decides where it is
/// unmistakable, else the extension. Coordinates stay as in the file: doubles are kept as floats about a double origin.
/// Throws Error(Input) with one sentence naming file, line or byte, what is wrong and what to do; Error(Interrupted) within
/// 100 ms of a stop request. Never allocates by a number that the file merely claims.
[[nodiscard]] LoadedFile loadMeshFile(const std::filesystem::path& path, const LoadOptions& options = {},
                                      const Progress& progress = {});

/// Extensions that loadMeshFile reads, lower case without a dot ("obj", "ply", …).
[[nodiscard]] const std::vector<std::string>& readableMeshExtensions();

}  // namespace cullscope
