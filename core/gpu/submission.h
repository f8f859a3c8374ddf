#pragma once

#include <cassert>

#include "core/gpu/drawing.h"

namespace cullscope {

/// Walks a list: `perInstance(ranges, counts, addresses)` once for each run of ranges of one instance, which is bound by then.
template <typename PerInstance>
void submit(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray,
            const PerInstance& perInstance) {
    VertexInput input(buffers, vertexArray, list.order);
    std::vector<GLsizei> counts;
    std::vector<const void*> addresses;
    for (size_t begin = 0, end = 0; begin < list.ranges.size(); begin = end) {
        const uint32_t number = list.ranges[begin].instance;
        input.bind(view, number);
        counts.clear();
        addresses.clear();
        for (; end < list.ranges.size() && list.ranges[end].instance == number; ++end) {
            counts.push_back(static_cast<GLsizei>(list.ranges[end].indexCount));
            addresses.push_back(input.indexAddress(list.ranges[end].firstIndex));
        }
        perInstance(std::span(list.ranges).subspan(begin, end - begin), counts, addresses);
    }
}

/// The same with one multi-draw for each run.
inline void submitAll(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray) {
    submit(buffers, view, list, vertexArray,
           [](std::span<const DrawRange>, const std::vector<GLsizei>& counts, const std::vector<const void*>& addresses) {
               if (counts.size() == 1)
                   glDrawElements(GL_TRIANGLES, counts[0], GL_UNSIGNED_INT, addresses[0]);
               else
                   glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, addresses.data(),
                                       static_cast<GLsizei>(counts.size()));
           });
}

/// The same with one draw a range, after the uniform kFirstTriangle says where it starts: gl_PrimitiveID counts from 0 in each.
/// Of a list in the meshes' own order.
inline void submitNumbered(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray) {
    assert(list.order == nullptr);
    submit(buffers, view, list, vertexArray,
           [&](std::span<const DrawRange> ranges, const std::vector<GLsizei>& counts, const std::vector<const void*>& addresses) {
               for (size_t i = 0; i < ranges.size(); ++i) {
                   const uint64_t first = buffers.scene().firstTriangle(ranges[i].instance) + ranges[i].firstIndex / 3;
                   glUniform1ui(kFirstTriangle, static_cast<GLuint>(first));
                   glDrawElements(GL_TRIANGLES, counts[i], GL_UNSIGNED_INT, addresses[i]);
               }
           });
}

}  // namespace cullscope
