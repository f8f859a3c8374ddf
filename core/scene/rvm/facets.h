#pragma once

#include "core/base/progress.h"
#include "core/mesh/primitive/tessellate.h"
#include "core/scene/rvm/rvm_records.h"

namespace cullscope::rvm {

/// Appends a polygon's triangles, transformed: its outline without its holes, in the outline's own orientation (turned by a
/// mirroring transform). False for a polygon without an area, of which nothing is appended.
[[nodiscard]] bool appendPolygon(primitive::Surface& surface, const Polygon& polygon, const Mat4& transform,
                                 const Progress& progress);

}  // namespace cullscope::rvm
