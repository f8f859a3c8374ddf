#pragma once

#include <optional>

#include "core/frame/frame_context.h"
#include "core/spatial/instance_octree.h"
#include "core/visibility/occlusion/buffer_walk.h"
#include "core/visibility/occlusion/cluster_occlusion.h"
#include "core/visibility/occlusion/two_passes.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/sampled_triangles.h"
#include "core/visibility/scene_clusters.h"
#include "core/visibility/strategy.h"

namespace cullscope::occlusion {

/// The lines of the listing of `clusters`.
enum class ClusterLine : uint8_t { Groups = 1, Outside, Hidden, Occlude, Objects, Planes, Cones, HiddenPart, Draw, Triangles };

struct ClusterScene : Structure {
    using Structure::Structure;
    InstanceOctree octree;
    SceneClusters clusters;
    std::vector<CornerBlocks> corners;  ///< by mesh, in the clusters' order; where triangles are tested
    Occluders occluders;
    PartBoxes parts;
};

struct ClusterMemory : ViewState {
    LastFailedPlanes planes;
    LastVisible last;                       ///< clusters, where a pyramid hides
    std::optional<OcclusionBuffer> buffer;  ///< begins anew with every frame: only its memory is kept

    [[nodiscard]] ViewStatePointer clone() const override {
        auto copy = std::make_unique<ClusterMemory>();
        static_cast<ViewState&>(*copy) = *this;
        copy->planes = planes;
        copy->last = last;
        return copy;
    }
};

struct ClusterOptions {
    bool cones = true;
    std::optional<OcclusionForm> occlusion{};  ///< none: no occluders hide
    double pixels = 0.0;                       ///< as BufferOptions
    uint64_t triangles = 0;
    bool samples = false;  ///< single triangles are left out that show nothing; not with a pyramid
    bool pyramid = false;  ///< what the frame has drawn hides, in two passes (two_passes.h); without `occlusion`
};

/// Decides one frame, draws it and says why.
void drawClusters(FrameContext& frame, const ClusterScene& structure, ClusterMemory& memory, const ClusterOptions& options);

}  // namespace cullscope::occlusion
