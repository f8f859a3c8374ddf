#pragma once

#include "core/mesh/raw_mesh.h"

namespace cullscope {

/// Takes the faces of `raw` that name no vertex, use a vertex without usable coordinates, or have no area out, and counts them in
/// `report`; counts vertices without usable coordinates and, by all faces as they stand in the file, unreferenced ones.
void dropUnusableFaces(RawMesh& raw, LoadReport& report, const Progress& progress);

/// Takes faces out that have the same vertices in the same direction as an earlier one.
void dropDuplicateFaces(RawMesh& raw, LoadReport& report, const Progress& progress);

/// Turns the polygons of `raw` into triangles after the others. Returns how many were too large to be cut along their ears.
size_t triangulatePolygons(RawMesh& raw, const Progress& progress);

}  // namespace cullscope
