#pragma once

#include <cstdint>

#include "core/frame/frame_context.h"
#include "core/spatial/instance_octree.h"
#include "core/visibility/occlusion/chc_history.h"

namespace cullscope::occlusion {

/// The lines of the listing of `occlusion-chc`.
enum class ChcLine : uint8_t { Visit = 1, Frustum, Outside, Unasked, Retest, Ask, Split, Hidden, Parts, Draw };

/// The names in brackets are those of the paper.
struct ChcOptions {
    size_t latency = 0;   ///< 0: what hidden groups answer is used in the same frame; 1: in the next one
    size_t batch = 1;     ///< how many hidden nodes are gathered before OpenGL is asked about them (b)
    size_t together = 1;  ///< how many of them one query covers at most
    RetestOptions retest;
    size_t depth = 0;   ///< levels below a node whose boxes may stand in place of its own (d_max)
    double area = 1.0;  ///< whose surface is together at most so many times that of its own (s_max)
};

struct ChcCounters {
    uint64_t queries = 0;  ///< of OpenGL
    uint64_t boxes = 0;    ///< that were drawn for them
    uint64_t batches = 0;  ///< of queries that are asked at once
    uint64_t multi = 0;    ///< queries about several nodes
    uint64_t split = 0;    ///< of these, those of which something showed
    uint64_t retests = 0;  ///< queries about visible leaves
    uint64_t hidden = 0;   ///< nodes that were left out by an answer
};

/// CHC++ (Mattausch, Bittner & Wimmer 2008, sections 3 to 5) over the octree of the frame's scene: visits its nodes by their
/// distance from the eye, draws the objects of what is visible, and says every decision while the frame records. Looks for the
/// frame's stop request as walkByQueries does; then it throws Error(Interrupted), and `history` is as it was.
///
/// - A node that was visible in the frame before is visited without a question. A leaf is drawn; every `retest.every` frames
/// OpenGL is
///   asked about it at the end of the frame, and the next frame gets the answer.
/// - A node that was hidden, or was not visited, is put into a batch. Of a full batch, and when nothing is left to visit, OpenGL
/// is
///   asked. At latency 0 the walk goes on meanwhile; it waits for the answers before the next batch is asked about. At latency 1
///   the next frame gets them: what was not visited before counts as visible, and what was hidden is left out.
/// - Hidden nodes of a batch that will probably stay hidden are asked about by one query together: of nodes sorted by the
///   probability p = 0.99 - 0.7 exp(-n) of a node that has been hidden for n frames, as many as give the largest |M| / C, where C
///   is 1 + (1 - product of p) |M| for several nodes M (section 4.1), and 1 for one, which is never asked about twice. Where
///   something of several shows, each is asked about by itself at latency 0, and counts as visible at latency 1.
/// - A node is asked about by the boxes of what it holds: of the level below it, at most `depth`, that is the lowest whose boxes
///   have together at most `area` times the surface of its own (section 5). Below a leaf are its objects.
/// - A node with something visible in it is visible; one of which all parts are hidden is hidden.
///
/// What is visible without asking is said in node_walk.h. At latency 0 nothing visible is lost, whatever `history` holds: what is
/// left out is hidden by what this frame has drawn.
ChcCounters walkCoherently(const InstanceOctree& octree, FrameContext& frame, const ChcOptions& options, ChcHistory& history);

}  // namespace cullscope::occlusion
