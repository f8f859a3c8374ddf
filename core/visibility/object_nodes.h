#pragma once

#include "core/visibility/structure_snapshot.h"

namespace cullscope {

/// One node for each object that a recorded frame decided about, by itself or within a group, in the order of the decisions, with
/// its result: the boxes of strategies that decide about whole objects. The log is of a frame of the scene.
[[nodiscard]] StructureSnapshot objectNodes(const FrameLog& log, const Scene& scene);

}  // namespace cullscope
