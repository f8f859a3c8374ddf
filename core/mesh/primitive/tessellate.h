#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mesh/primitive/primitive.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope::primitive {

/// How finely curves are cut into chords. All corners lie on the exact surface.
struct Fineness {
    /// The largest distance of the triangles from the exact surface, in the primitive's unit. The number of chords of a circle is
    /// a multiple of 4, at least 8 and at most 1024.
    double chordError = 1e-3;
    /// Where not 0: so many chords for any full circle, at least 3, in place of `chordError`.
    uint32_t segments = 0;
};
/// The number of chords of a full circle.
[[nodiscard]] uint32_t chordsOfCircle(double radius, const Fineness& fineness);

/// Triangles with their own corners where the surface has an edge. Counter-clockwise seen from outside.
struct Surface {
    std::vector<Vec3> positions, normals;
    std::vector<uint32_t> triangles;
};

/// Appends a primitive's triangles, transformed; a mirroring transform keeps them facing outward. The surface is closed and
/// consistently oriented: corners at one position counted as one, each edge is traversed once in each direction. Triangles
/// without an area because two of their corners coincide are left out. `primitive` is possible (whyImpossible). The same bits on
/// every machine.
void appendSurface(Surface& surface, const Primitive& primitive, const Fineness& fineness, const Mat4& transform = Mat4(1.0));

/// A surface as a mesh about the centre of its box.
[[nodiscard]] MeshPointer meshOf(const Surface& surface, std::string name);

}  // namespace cullscope::primitive
