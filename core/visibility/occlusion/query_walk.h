#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "core/frame/frame_context.h"
#include "core/spatial/instance_octree.h"

namespace cullscope::occlusion {

/// The lines of the listing of `octree-query`.
enum class QueryLine : uint8_t { Visit = 1, Frustum, Outside, Unasked, Ask, Hidden, Children, Draw };

/// The questions of one frame that were not waited for.
struct AskedNodes {
    BoxTicketPointer ticket;
    std::vector<uint32_t> nodes;  ///< by box
};
using AskedFrame = std::vector<AskedNodes>;

struct QueryOptions {
    bool inner = true;   ///< asks about groups that have parts, too
    size_t batch = 1;    ///< boxes that are asked about at once, at most; batches begin with one and double
    size_t latency = 0;  ///< frames between a question and the use of its answer; 0: each batch is waited for
};

struct QueryCounters {
    uint64_t asked = 0;    ///< boxes
    uint64_t hidden = 0;   ///< nodes that were left out by an answer
    uint64_t batches = 0;  ///< of boxes, each of which is waited for at latency 0
};

/// Walks the octree of the frame's scene front to back, depth first, draws the objects of what is visible, and says every
/// decision while the frame records. `past`: the questions of the last frames, oldest first; the walk adds its own and takes out
/// those that no frame will use. Looks for the frame's stop request after some thousand nodes or some boxes that are asked about,
/// and between two batches; then it throws Error(Interrupted), and `past` is as it was.
///
/// A node is tested against the frustum's planes, and by separating axes. Then OpenGL is asked whether its box, grown by
/// boxGrowth, shows before what is drawn so far. A node is visible without asking
///  - while nothing is drawn that could hide it;
///  - where its grown box reaches before the near plane, as a box around the eye does: a box that contains the near rectangle
///    covers no sample, and depths of what crosses the plane of the eye mean nothing;
///  - at a latency, where it was not asked about in the frame whose answers are used.
/// With a batch of more than one box, questions are gathered before any of them is answered, so that there are fewer waits and
/// more questions: boxes of one batch cannot be hidden by what the others hold. As the first things drawn hide most, batches
/// begin with one box and double.
QueryCounters walkByQueries(const InstanceOctree& octree, FrameContext& frame, const QueryOptions& options,
                            std::deque<AskedFrame>& past);

}  // namespace cullscope::occlusion
