#pragma once

#include "core/base/progress.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// Looks for pockets of a closed, consistently oriented mesh that are inside out: whether the winding number is negative at any
/// point. Seen from where it is 0, a back face comes first only where such a pocket begins.
///
/// Where triangles meet, they cut each other into faces, and in front of a face the winding number is the same along all of it
/// and beyond those edges along which nothing else meets it. So it is asked beside every line of contact, on both of its sides in
/// both triangles, and of one triangle of each component. It is counted along an axis by exact predicates: +1 for each triangle
/// that a line leaves through its front, −1 for each that it enters.
///
/// A pocket that is thinner than a millionth of a millionth of the mesh is not found. Costs about 1 s for a million triangles.
/// Throws Error(Interrupted) on a stop request.
[[nodiscard]] Pockets pocketsInsideOut(const TriangleMesh& mesh, const Progress& progress);

}  // namespace cullscope
