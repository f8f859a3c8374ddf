#pragma once

#include "core/mesh/raw_mesh.h"

namespace cullscope {

/// Removes the faces of `raw` that have an index of no vertex, use a vertex without usable coordinates, or have no area, and
/// counts them in `report`. Also counts the vertices without usable coordinates and those that no face of the file references.
void dropUnusableFaces(RawMesh& raw, LoadReport& report, const Progress& progress);

/// Removes faces that have the same vertices in the same direction as an earlier one, and counts them in `report`.
void dropDuplicateFaces(RawMesh& raw, LoadReport& report, const Progress& progress);

/// Replaces the polygons of `raw` by triangles, appended to its others. Returns how many polygons were too large for ear
/// clipping.
size_t triangulatePolygons(RawMesh& raw, const Progress& progress);

}  // namespace cullscope
