#pragma once

#include <cstdint>

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// Parametric solids, tessellated to about the requested number of triangles (the nearest that the tessellation's grid allows).
/// All are counter-clockwise seen from outside, share vertices across seams, and have analytic or averaged unit normals. Throw
/// Error(Usage) for fewer triangles than the shape needs or more than 2e9, Error(Interrupted) on a stop request.

/// A unit sphere: an icosahedron with every face divided f × f (20 f² triangles), projected. Closed.
[[nodiscard]] MeshPointer sphereMesh(size_t triangles, const Progress& progress = {});

/// Half a hollow sphere of radii 1 and 0.92, open towards +z. Closed; from its centre most rays intersect it twice.
[[nodiscard]] MeshPointer bowlMesh(size_t triangles, const Progress& progress = {});

/// A torus about y with radii 1 and 0.25. Closed.
[[nodiscard]] MeshPointer torusMesh(size_t triangles, const Progress& progress = {});

/// A tube of radius 0.25 around the (2, 3) torus knot, in a ball of radius about 1.75. Closed.
[[nodiscard]] MeshPointer knotMesh(size_t triangles, const Progress& progress = {});

/// A closed surface that is star-shaped about the origin: radius 1 plus smooth random bumps and dents of up to 0.45.
[[nodiscard]] MeshPointer starMesh(uint64_t seed, size_t triangles, const Progress& progress = {});

/// Newell's teapot (1975) with the bottom that Blinn added: 32 bicubic Bézier patches, y up. Open: the lid does not touch the rim
/// and handle and spout pass through the body.
[[nodiscard]] MeshPointer teapotMesh(size_t triangles, const Progress& progress = {});

}  // namespace cullscope
