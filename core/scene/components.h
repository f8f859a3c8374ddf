#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/mesh/primitive/primitive.h"

namespace cullscope {

/// What some consecutive triangles of a mesh were made from.
struct MeshPart {
    enum class Kind : uint8_t {
        Solid,   ///< the primitive `solid`, transformed
        Facets,  ///< polygons that were given as such
        Line     ///< without a surface: the segment from the origin to (1, 0, 0), transformed
    };
    Kind kind = Kind::Solid;
    primitive::Primitive solid;
    Mat4 meshFromSolid{1.0};  ///< to the mesh's double coordinates (origin + position)
    uint32_t firstTriangle = 0, triangleCount = 0;
};

/// The name of a part's kind in English, marked for translation: "cylinder", "facet group", "line".
[[nodiscard]] const char* kindName(const MeshPart& part);

inline constexpr uint32_t kNoGroup = 0xffffffffU;

/// What objects belong to: a pipeline, an item of equipment, a file's group. Groups form trees.
struct ObjectGroup {
    std::string name;
    uint32_t parent = kNoGroup;  ///< a smaller number than the group's own
};

/// Of which primitives a scene's meshes consist, for scenes that were modelled of them. Equal objects share their mesh and with
/// it their parts: an object's primitives are its mesh's, placed by the object's transform.
struct Components {
    std::vector<MeshPart> parts;  ///< those of the meshes, one mesh after the other
    /// By mesh: its first part. One element more than meshes; what follows the last mesh's belongs to no mesh and is not drawn,
    /// such as the lines of a file.
    std::vector<uint32_t> firstPart{0};
    std::vector<ObjectGroup> groups;

    /// Ends the list of the parts of the next mesh.
    void endMesh() { firstPart.push_back(uint32_t(parts.size())); }
    [[nodiscard]] size_t bytes() const;
};
using ComponentsPointer = std::shared_ptr<const Components>;

}  // namespace cullscope
