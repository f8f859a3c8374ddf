#pragma once

#include <cassert>

#include "core/gpu/drawing.h"

namespace cullscope {

/// A run of ranges of one instance, which is bound by then.
struct SubmittedRun {
    std::span<const DrawRange> ranges;
    const std::vector<GLsizei>& counts;
    const std::vector<const void*>& addresses;
    GLenum indexType = GL_UNSIGNED_INT;
};

/// Whether a run is the whole mesh in no order of the list's own, so that its triangles may be drawn in whichever is fastest.
inline bool isWhole(std::span<const DrawRange> run, const DrawList& list, const Scene& scene) {
    const uint32_t mesh = scene.instances()[run.front().instance].mesh;
    return run.size() == 1 && list.orderOf(mesh).indices.empty() &&
           run.front().indexCount == scene.meshes()[mesh]->indices().size();
}

/// Walks a list: `perInstance(run)` once for each run of ranges of one instance. `numbered`: its triangles are told apart by
/// where they stand, so that none may change places.
template <typename PerInstance>
void submit(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray, bool numbered,
            const PerInstance& perInstance) {
    using Indices = VertexInput::Indices;
    VertexInput input(buffers, vertexArray, list.order);
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

/// The same with one multi-draw for each run.
inline void submitAll(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray) {
    submit(buffers, view, list, vertexArray, false, [](const SubmittedRun& run) {
        if (run.counts.size() == 1)
            glDrawElements(GL_TRIANGLES, run.counts[0], run.indexType, run.addresses[0]);
        else
            glMultiDrawElements(GL_TRIANGLES, run.counts.data(), run.indexType, run.addresses.data(),
                                static_cast<GLsizei>(run.counts.size()));
    });
}

/// The same with one draw a range, after the uniform kFirstTriangle says where it starts: gl_PrimitiveID counts from 0 in each.
/// Of a list in the meshes' own order.
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
