#pragma once

#include "core/visibility/registry.h"

namespace cullscope::occlusion {

/// `occlusion-chc`: CHC++, coherent hierarchical culling (Mattausch, Bittner & Wimmer 2008), over the octree of `octree-query`.
/// What was visible in the frame before is drawn without a question, and asked about again every some frames; what was hidden is
/// asked about in batches, several groups by one query, while the walk goes on. See chc_walk.h. Conservative on samples where the
/// answers about what was hidden are waited for (`latency` 0); where the next frame gets them approximate.
[[nodiscard]] RegisteredStrategy occlusionChc();

}  // namespace cullscope::occlusion
