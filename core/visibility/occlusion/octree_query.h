#pragma once

#include "core/visibility/registry.h"

namespace cullscope::occlusion {

/// `octree-query`: the octree method of the lecture. A non-uniform octree over the objects is walked front to back, depth first;
/// a group outside the frustum is left out; of any other OpenGL is asked, by an occlusion query on the group's box, whether the
/// box shows before what is drawn so far, and a group whose box does not is left out as hidden. The objects of the leaves that
/// are left are drawn. See query_walk.h for what is asked, and when. Conservative on samples where it waits for the answers
/// (`latency` 0); with the answers of one or two frames ago approximate.
[[nodiscard]] RegisteredStrategy octreeQuery();

}  // namespace cullscope::occlusion
