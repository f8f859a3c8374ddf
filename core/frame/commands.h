#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/base/uninitialized.h"
#include "core/frame/cause.h"
#include "core/frame/draw_list.h"
#include "core/geometry/frustum.h"
#include "core/geometry/types.h"
#include "core/scene/camera.h"

namespace cullscope {

/// Triangles that a strategy made itself, such as the parts of a triangle that a plane cut, drawn in their order. Corners are in
/// the coordinates of an instance's mesh, relative to the mesh's origin: a triangle that was not cut falls on the same samples as
/// when it is drawn from the scene.
struct OwnTriangles {
    /// Consecutive triangles with one instance's transform.
    struct Run {
        uint32_t instance = 0;
        uint32_t first = 0;  ///< the number of the run's first triangle
        uint32_t count = 0;  ///< of triangles
    };
    Facing facing = Facing::TwoSided;
    DepthRule depth = DepthRule::InOrder;
    std::vector<Vec3f> positions;     ///< three for each triangle
    std::vector<Vec3f> normals;       ///< of the same corners
    std::vector<uint32_t> triangles;  ///< the scene triangle number of each triangle, which it is or is a part of
    std::vector<Run> runs;            ///< all triangles, ascending
};
using OwnTrianglesPointer = std::shared_ptr<const OwnTriangles>;

/// A picture that a strategy made without OpenGL, for the culling view. Rows count from the bottom. In the frame it stands in
/// place of everything before it.
struct FinishedPicture {
    Viewport size;                           ///< the culling view's
    UninitializedVector<uint32_t> triangle;  ///< scene triangle number + 1; 0: nothing
    UninitializedVector<float> depth;        ///< reversed; 0 where there is nothing
};
using FinishedPicturePointer = std::shared_ptr<const FinishedPicture>;

/// How OpenGL is asked about boxes.
enum class BoxQuestion {
    Selection,   ///< in selection mode: which boxes intersect the view
    Samples,     ///< by occlusion queries without depth test: which boxes cover a sample
    DepthSoFar,  ///< by occlusion queries against the depth that the frame has drawn so far
    Pyramid      ///< by a compute shader against a pyramid of that depth (PyramidReading)
};

/// What a box was compared with by BoxQuestion::Pyramid. The depth that the frame has drawn so far is reduced to a pyramid: a
/// texel of level n has the farthest depth of 2^n × 2^n pixels. A box is hidden where it lies behind all texels of a level that
/// it may cover; the level is the lowest at which they are few.
struct PyramidReading {
    uint32_t level = 0;
    uint32_t texels = 0;    ///< so many; 0: the box reaches before the near plane, and is visible
    float nearest = 1.0f;   ///< reversed depth of the box's nearest point
    float farthest = 0.0f;  ///< reversed depth of the farthest of those texels
};

/// Memory of the pyramid of a picture, without the depth itself, which is its level 0.
[[nodiscard]] inline uint64_t pyramidBytes(Viewport size) {
    uint64_t texels = 0;
    while (size.width > 1 || size.height > 1) {
        size = {(size.width + 1) / 2, (size.height + 1) / 2};
        texels += uint64_t(size.width) * uint64_t(size.height);
    }
    return texels * sizeof(float);
}

/// The nearest and the farthest of what a hit record says of a box's faces within the view, as forward distances from the eye.
struct HitDistances {
    double nearest = 0.0, farthest = 0.0;
};

/// Boxes that OpenGL was asked about, and the answer. Draws nothing.
struct AskedBoxes {
    BoxQuestion question = BoxQuestion::Samples;
    std::vector<EyeBox> boxes;
    std::vector<uint32_t> hits;             ///< indices into `boxes`, or numbers of groups of them (`ends`), ascending
    bool answered = true;                   ///< false: the answer is got later, and `hits` is empty
    std::vector<HitDistances> distances{};  ///< of BoxQuestion::Selection, by hit
    size_t bufferWords = 0;                 ///< of BoxQuestion::Selection: of the hit buffer that held all records
    int overflows = 0;                      ///< how often a smaller one was too small before
    std::vector<uint32_t> ends{};  ///< of groups with one answer each: behind its last box; empty: each box has its answer
};

/// A question whose answer is got later, in this or a later frame (FrameContext::ask). It is kept by the strategy, as a rule in a
/// view's memory, whose copies share it; it may outlive the OpenGL context.
class BoxTicket {
public:
    explicit BoxTicket(size_t answers) : m_answers(answers) {}
    virtual ~BoxTicket() = default;
    BoxTicket(const BoxTicket&) = delete;
    BoxTicket& operator=(const BoxTicket&) = delete;

    /// How many boxes, or groups of boxes, have an answer.
    [[nodiscard]] size_t answers() const { return m_answers; }

private:
    size_t m_answers;
};
using BoxTicketPointer = std::shared_ptr<BoxTicket>;

/// One command of a frame. Draw lists hold what was drawn, also where the GPU chose it.
using Command = std::variant<DrawList, OwnTrianglesPointer, FinishedPicturePointer, AskedBoxes>;

/// Ranges of which a compute shader chooses those that are drawn, one invocation for each.
struct GpuChoice {
    DrawList candidates;
    /// GLSL: the body of `bool chosen(uint candidate)`, which reads `float data[]`.
    std::string body;
    std::vector<float> data;
    Cause leftOut = Cause::Hidden;  ///< why a candidate that is not chosen is left out
};

}  // namespace cullscope
