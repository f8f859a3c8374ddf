#pragma once

#include "core/scene/scene.h"
#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// One node an object that a trace's events tell of, in their order, with what became of it: the boxes of strategies that decide
/// about whole objects. `trace` is of a cull of the scene.
[[nodiscard]] StructureSnapshot objectNodes(const Trace& trace, const Scene& scene);

}  // namespace cullscope
