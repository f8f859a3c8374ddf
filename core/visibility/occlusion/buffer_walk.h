#pragma once

#include <cstdint>
#include <vector>

#include "core/frame/frame_context.h"
#include "core/raster/occlusion_buffer.h"
#include "core/spatial/part_boxes.h"
#include "core/visibility/occlusion/occluders.h"
#include "core/visibility/octree_walk.h"

namespace cullscope::occlusion {

/// The lines of a strategy's listing at which the decisions of a walk with a buffer fall: those of the walk through the octree,
/// then the questions about groups and objects, what is hidden, the next occluder, and the last question about an object.
struct BufferLines {
    OctreeWalkLines walk{};
    uint8_t group = 0, object = 0, hidden = 0, occlude = 0, again = 0;
};

struct BufferOptions {
    double pixels = 0.0;     ///< the triangles of an occluder have so many on average, face on at its object's nearest point
    uint64_t triangles = 0;  ///< occluders have at most so many together
    BufferLines lines{};
};

struct BufferCounters {
    OctreeWalkCounters walk;
    uint64_t questions = 0;
    uint64_t hiddenNodes = 0;
    uint64_t hiddenObjects = 0;    ///< one by one, besides those of hidden nodes
    uint64_t hiddenTriangles = 0;  ///< of both
    uint64_t occluders = 0;        ///< objects that were drawn into the buffer
};

/// Walks the octree of the frame's scene, near parts first (octree_walk.h), and returns the objects that are left, nearest first.
///  - A group or an object outside the frustum is left out.
///  - Of one that is not, the buffer is asked whether occluders hide its box (occluders.h). What they hide is left out, of a
///  group
///    all its objects.
///  - The largest triangles of an object that they do not hide are drawn into the buffer: it is the next occluder. So what lies
///    behind others adds nothing to the buffer. It ends where it has as many triangles as the options allow.
///  - At last the buffer is asked once more about each object left, as an occluder that came later may hide it.
/// Nothing visible is hidden: at each of its pixels a triangle of the scene that the frame's picture may show lies nearer; that
/// one is seen there, or what is nearer still.
[[nodiscard]] std::vector<KeptObject> walkWithBuffer(const GroupTree& tree, const Occluders& occluders, const PartBoxes& parts,
                                                     FrameContext& frame, const BufferOptions& options, LastFailedPlanes& memory,
                                                     OcclusionBuffer& buffer, BufferCounters& counters);

}  // namespace cullscope::occlusion
