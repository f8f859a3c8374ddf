#pragma once

#include <cassert>

#include "core/gpu/drawing.h"

namespace cullscope {

/// Consecutive ranges of one instance, which is bound when they are passed on.
struct SubmittedRun {
    std::span<const DrawRange> ranges;
    const std::vector<GLsizei>& counts;
    const std::vector<const void*>& addresses;
    GLenum indexType = GL_UNSIGNED_INT;
};

/// Whether the ranges are a whole mesh for which the draw list has no order of its own, so that its triangles may be drawn in the
/// fastest order.
inline bool isWhole(std::span<const DrawRange> run, const DrawList& list, const Scene& scene) {
    const uint32_t mesh = scene.instances()[run.front().instance].mesh;
    return run.size() == 1 && list.orderOf(mesh).indices.empty() &&
           run.front().indexCount == scene.meshes()[mesh]->indices().size();
}

/// Goes through a list: binds each instance and calls `perInstance(run)` for each run of ranges of one instance. `numbered`:
/// triangles are identified by their place, so their order must be kept.
template <typename PerInstance>
void submit(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray, bool numbered,
            const PerInstance& perInstance) {
    using Indices = VertexInput::Indices;
    VertexInput input(buffers, vertexArray, list.order, list.facing);
    std::vector<GLsizei> counts;
    std::vector<const void*> addresses;
    for (size_t begin = 0, end = 0; begin < list.ranges.size(); begin = end) {
        const uint32_t number = list.ranges[begin].instance;
        while (end < list.ranges.size() && list.ranges[end].instance == number) ++end;
        const std::span<const DrawRange> ranges = std::span(list.ranges).subspan(begin, end - begin);
        input.bind(view, number, !numbered && isWhole(ranges, list, buffers.scene()) ? Indices::Whole : Indices::InOrder);
        counts.clear();
        addresses.clear();
        for (const DrawRange& range : ranges) {
            counts.push_back(static_cast<GLsizei>(range.indexCount));
            addresses.push_back(input.indexAddress(range.firstIndex));
        }
        perInstance(SubmittedRun{ranges, counts, addresses, input.indexType()});
    }
}

/// Draws a list with one multi-draw call for each run.
inline void submitAll(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray) {
    submit(buffers, view, list, vertexArray, false, [](const SubmittedRun& run) {
        if (run.counts.size() == 1)
            glDrawElements(GL_TRIANGLES, run.counts[0], run.indexType, run.addresses[0]);
        else
            glMultiDrawElements(GL_TRIANGLES, run.counts.data(), run.indexType, run.addresses.data(),
                                static_cast<GLsizei>(run.counts.size()));
    });
}

/// Draws a list in the meshes' own order with one call for each range; the uniform kFirstTriangle holds the number of its first
/// triangle, because gl_PrimitiveID starts at 0 in each call.
inline void submitNumbered(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray) {
    assert(list.order == nullptr);
    submit(buffers, view, list, vertexArray, true, [&](const SubmittedRun& run) {
        for (size_t i = 0; i < run.ranges.size(); ++i) {
            const uint64_t first = buffers.scene().firstTriangle(run.ranges[i].instance) + run.ranges[i].firstIndex / 3;
            glUniform1ui(kFirstTriangle, static_cast<GLuint>(first));
            glDrawElements(GL_TRIANGLES, run.counts[i], run.indexType, run.addresses[i]);
        }
    });
}

}  // namespace cullscope
