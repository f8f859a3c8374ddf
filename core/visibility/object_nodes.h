#pragma once

#include "core/scene/scene.h"
#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// One node for each object that has events in a trace, in the trace's order, with its result: the boxes of strategies that
/// decide about whole objects. `trace` is from a cull of the scene.
[[nodiscard]] StructureSnapshot objectNodes(const Trace& trace, const Scene& scene);

}  // namespace cullscope
