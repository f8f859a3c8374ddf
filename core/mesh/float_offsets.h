#pragma once

#include "core/base/progress.h"
#include "core/geometry/bounds.h"
#include "core/mesh/raw_mesh.h"

namespace cullscope {

/// The origin for the float coordinates of a mesh with these bounds: their middle, as a rule. A float keeps a coordinate to a
/// part in 16 million of its distance from the origin. So where a few vertices lie far away from all others, the origin is the
/// median of a sample of the vertices, about which these others keep their places.
[[nodiscard]] Vec3 originForFloats(const RawMesh& raw, const Box3& bounds);

/// The number of triangles of which a side changes by more than a tenth of the longest one, in length or direction, when their
/// corners are rounded to floats about an origin: from there on it shows, up to triangles that become a point. The triangles'
/// corners are vertices.
[[nodiscard]] size_t trianglesBentByRounding(const RawMesh& raw, const Vec3& origin, const Progress& progress);

/// The positions as offsets from an origin; frees the memory of the old positions.
[[nodiscard]] std::vector<Vec3f> takeOffsets(RawMesh& raw, const Vec3& origin, const Progress& progress);

}  // namespace cullscope
