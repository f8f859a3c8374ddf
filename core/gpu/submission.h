#pragma once

#include <cassert>
#include <optional>

#include "core/base/error.h"
#include "core/gpu/drawing.h"

namespace cullscope {

/// Consecutive ranges of one instance, which is bound when they are passed on.
struct SubmittedRun {
    std::span<const DrawRange> ranges;
    const std::vector<GLsizei>& counts;
    const std::vector<const void*>& addresses;
    GLenum indexType = GL_UNSIGNED_INT;
    unsigned indexBuffer = 0;  ///< that the addresses are offsets in; 0 with client arrays
};

/// Whether the ranges are a whole mesh whose triangles may be drawn in any order, the fastest one.
inline bool isWhole(std::span<const DrawRange> run, const DrawList& list, const Scene& scene) {
    const uint32_t mesh = scene.instances()[run.front().instance].mesh;
    return list.depth == DepthRule::Nearest && run.size() == 1 &&
           run.front().indexCount == scene.meshes()[mesh]->indices().size() && !list.standIn(mesh, run.front());
}

/// Goes through a list: binds each instance and calls `perInstance(run)` for each run of ranges of one instance. Where the sides
/// that are drawn differ from object to object, those of which fronts alone are drawn come first: OpenGL begins anew at each
/// change. `numbered`: triangles are identified by their place, so their order must be kept. Throws Error(Interrupted) before an
/// instance where a stop is requested.
template <typename PerInstance>
void submit(const SceneBuffers& buffers, const View& view, const DrawList& list, const TriangleInput& by, bool numbered,
            const PerInstance& perInstance) {
    using Indices = VertexInput::Indices;
    VertexInput input(buffers, by.vertexArray, list.order, list.facing);
    std::vector<GLsizei> counts;
    std::vector<const void*> addresses;
    const bool apart = list.facing == Facing::ByObject && list.depth == DepthRule::Nearest;
    const auto draw = [&](const std::optional<Facing>& only) {
        for (size_t begin = 0, end = 0; begin < list.ranges.size(); begin = end) {
            if (by.stop.stop_requested()) throwInterrupted();
            const uint32_t number = list.ranges[begin].instance;
            while (end < list.ranges.size() && list.ranges[end].instance == number) ++end;
            if (only && facingOf(buffers.scene(), number, list.facing) != *only) continue;
            const std::span<const DrawRange> ranges = std::span(list.ranges).subspan(begin, end - begin);
            input.bind(view, number, !numbered && isWhole(ranges, list, buffers.scene()) ? Indices::Whole : Indices::InOrder);
            counts.clear();
            addresses.clear();
            for (const DrawRange& range : ranges) {
                counts.push_back(static_cast<GLsizei>(range.indexCount));
                addresses.push_back(input.indexAddress(range.firstIndex));
            }
            perInstance(SubmittedRun{ranges, counts, addresses, input.indexType(), input.indexBuffer()});
        }
    };
    if (!apart) return draw(std::nullopt);
    draw(Facing::Front);
    draw(Facing::TwoSided);
}

/// Copies the indices of a run's ranges one after the other into `by.gathered` and draws them by one call: the same triangles in
/// the same order. Of buffer objects only. Within `submit`. False, and nothing is drawn, where memory runs out.
bool drawGathered(const SceneBuffers& buffers, const DrawList& list, const SubmittedRun& run, const TriangleInput& by);

/// Whether copying a run's indices costs less than its ranges: a software OpenGL begins each range anew, shading vertices that it
/// shares with the one before a second time (docs/measuring.md, "Ranges").
[[nodiscard]] bool worthGathering(const SubmittedRun& run);

/// Draws a list with one call for each run: a multi-draw, or a draw of the gathered ranges.
inline void submitAll(const SceneBuffers& buffers, const View& view, const DrawList& list, const TriangleInput& input) {
    const bool mayGather = input.gathered != nullptr && buffers.upload() == Upload::Vbo;
    submit(buffers, view, list, input, false, [&](const SubmittedRun& run) {
        if (run.counts.size() == 1)
            glDrawElements(GL_TRIANGLES, run.counts[0], run.indexType, run.addresses[0]);
        else if (!mayGather || !worthGathering(run) || !drawGathered(buffers, list, run, input))
            glMultiDrawElements(GL_TRIANGLES, run.counts.data(), run.indexType, run.addresses.data(),
                                static_cast<GLsizei>(run.counts.size()));
    });
}

/// Draws a list in the meshes' own order with one call for each range; the uniform kFirstTriangle holds the number of its first
/// triangle, because gl_PrimitiveID starts at 0 in each call.
inline void submitNumbered(const SceneBuffers& buffers, const View& view, const DrawList& list, const TriangleInput& input) {
    assert(list.order == nullptr);
    submit(buffers, view, list, input, true, [&](const SubmittedRun& run) {
        for (size_t i = 0; i < run.ranges.size(); ++i) {
            const uint64_t first = buffers.scene().firstTriangle(run.ranges[i].instance) + run.ranges[i].firstIndex / 3;
            glUniform1ui(kFirstTriangle, static_cast<GLuint>(first));
            glDrawElements(GL_TRIANGLES, run.counts[i], run.indexType, run.addresses[i]);
        }
    });
}

}  // namespace cullscope
