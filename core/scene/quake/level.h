#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/types.h"
#include "core/mesh/byte_source.h"
#include "core/scene/quake/entities.h"

/// Levels of Quake 3 (IBSP files of version 46) and of the games that share its format. The records are those of the source code
/// that id Software published (code/qcommon/qfiles.h): little-endian, in the level's units, z up.
namespace cullscope::quake {

/// A material by its name. Its images are not read.
struct Shader {
    std::string name;
    uint32_t flags = 0;

    [[nodiscard]] bool isSky() const { return (flags & 0x4U) != 0; }
    [[nodiscard]] bool isDrawn() const { return (flags & (0x4U | 0x80U)) == 0; }
};

struct Vertex {
    Vec3f position{0.0F}, normal{0.0F};
};

/// What the renderer of the game decides about as a whole (a draw surface).
struct Surface {
    enum class Kind : int32_t { Polygon = 1, Patch = 2, Mesh = 3, Billboard = 4 };
    uint32_t shader = 0;  ///< index into Level::shaders
    Kind kind = Kind::Polygon;
    uint32_t firstVertex = 0, vertexCount = 0;  ///< in Level::vertices; of a patch its control points, row by row
    uint32_t firstCorner = 0, cornerCount = 0;  ///< in Level::corners, three for each triangle; none of a patch
    uint32_t patchWidth = 0, patchHeight = 0;   ///< odd, at least 3; their product is vertexCount
};

/// { p : normal·p = distance }; the front is where normal·p is larger.
struct Plane {
    Vec3 normal{0.0, 0.0, 1.0};
    double distance = 0.0;
};

/// An inner node of the level's BSP tree. A child is a node, or a leaf where it is negative: leaf −1 − child.
struct Node {
    uint32_t plane = 0;
    std::array<int32_t, 2> children{};  ///< in front of the plane and behind it
};

struct Leaf {
    int32_t cluster = -1;                         ///< −1: within a solid or outside of the level, from where nothing is drawn
    uint32_t firstSurface = 0, surfaceCount = 0;  ///< in Level::leafSurfaces
};

/// Surfaces that move together. Model 0 is the level itself; the others belong to entities, such as doors.
struct Model {
    uint32_t firstSurface = 0, surfaceCount = 0;  ///< in Level::surfaces
};

/// A level as its file has it. All indices lie in their arrays; the nodes are a tree whose root is node 0. Corners alone may name
/// vertices that their surface does not have.
struct Level {
    std::vector<Entity> entities;
    std::vector<Shader> shaders;
    std::vector<Plane> planes;
    std::vector<Node> nodes;
    std::vector<Leaf> leaves;
    std::vector<uint32_t> leafSurfaces;  ///< indices into surfaces; a surface may lie in several leaves
    std::vector<Model> models;
    std::vector<Vertex> vertices;
    std::vector<uint32_t> corners;  ///< from their surface's first vertex
    std::vector<Surface> surfaces;
    uint32_t clusters = 0;  ///< 0 where the level was compiled without visibility
    uint32_t bytesOfCluster = 0;
    std::string visibleBits;  ///< for each cluster bytesOfCluster bytes: bit j of them says whether cluster j may be seen

    /// The leaf in which a place lies; a place on a plane is in front of it. `nodes` is not empty.
    [[nodiscard]] uint32_t leafAt(const Vec3& place) const;
    /// Whether the level's potentially visible set of the cluster `from` has the cluster `to`. True for all pairs in a level
    /// without visibility, false where either is −1.
    [[nodiscard]] bool mayBeSeen(int32_t from, int32_t to) const;
    [[nodiscard]] std::span<const uint32_t> surfacesOf(const Leaf& leaf) const {
        return std::span(leafSurfaces).subspan(leaf.firstSurface, leaf.surfaceCount);
    }
};

/// Reads a level from the begin of a file. `requireMemory` throws where so many bytes are too many. Throws Error(Input) with a
/// sentence that names the file, the byte and the defect: for other versions and games, for a file that breaks off, and for
/// records that name what the file does not have.
[[nodiscard]] Level readLevel(ByteSource& source, const std::function<void(uint64_t bytes)>& requireMemory);

}  // namespace cullscope::quake
