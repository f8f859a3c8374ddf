#pragma once

#include <vector>

#include "core/frame/frame_context.h"
#include "core/raster/occlusion_buffer.h"
#include "core/visibility/occlusion/occluders.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/part_walk.h"

namespace cullscope::occlusion {

/// The lines of a listing at which an occlusion buffer's decisions about objects fall.
struct OccluderLines {
    uint8_t hidden = 0, occlude = 0;
};

struct OccluderOptions {
    double pixels = 0.0;     ///< a triangle of an occluder has at least so many, seen face on at its object's nearest point
    uint64_t triangles = 0;  ///< occluders have at most so many together
    OccluderLines lines{};
};

struct OccluderResult {
    uint64_t occluders = 0;        ///< objects of which triangles were drawn into the buffer
    uint64_t questions = 0;        ///< about objects
    uint64_t hiddenTriangles = 0;  ///< of objects that are hidden as a whole
};

/// Goes through objects, nearest first: leaves out those that the occluders before them hide, and draws the largest triangles of
/// each other one into the buffer. Nothing visible is left out: what hides it is drawn, or is hidden itself by what lies nearer.
/// While the frame is recorded every question is said.
OccluderResult keepUnhidden(std::vector<KeptObject>& nearestFirst, const Occluders& occluders, FrameContext& frame,
                            const OccluderOptions& options, OcclusionBuffer& buffer);

/// Whether a buffer hides a part of one instance. Keeps references. The buffer is asked by one thread at a time.
class BufferHiding final : public HidingTest {
public:
    BufferHiding(OcclusionBuffer& buffer, const View& view, const EyeFromLocal& object)
        : HidingTest(0), m_buffer(buffer), m_view(view), m_object(object) {
        for (int column = 0; column < 3; ++column) m_spread[column] = glm::abs(object.linear[column]);
    }

    [[nodiscard]] Reach test(const Vec3& middle, const Vec3& half, Decision* said) const override;

private:
    OcclusionBuffer& m_buffer;
    const View& m_view;
    const EyeFromLocal& m_object;
    Mat3 m_spread{0.0};  ///< its entries' sizes: of a level box in the world around a box that is level in the mesh
};

}  // namespace cullscope::occlusion
