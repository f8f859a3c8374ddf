#pragma once

#include "core/frame/frame_context.h"
#include "core/spatial/instance_octree.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/scene_clusters.h"
#include "core/visibility/strategy.h"

namespace cullscope::occlusion {

/// The lines of the listing of `clusters`.
enum class ClusterLine : uint8_t { Groups = 1, Outside, Objects, Walk, Planes, Cones, Draw, Parts };

struct ClusterScene : Structure {
    using Structure::Structure;
    InstanceOctree octree;
    SceneClusters clusters;
};

struct ClusterMemory : ViewState {
    LastFailedPlanes planes;

    [[nodiscard]] ViewStatePointer clone() const override { return std::make_unique<ClusterMemory>(*this); }
};

struct ClusterOptions {
    bool cones = true;
};

/// Decides one frame, draws it and says why.
void drawClusters(FrameContext& frame, const ClusterScene& structure, ClusterMemory& memory, const ClusterOptions& options);

}  // namespace cullscope::occlusion
