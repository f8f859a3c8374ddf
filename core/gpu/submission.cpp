#include "core/gpu/submission.h"

#include <algorithm>

namespace cullscope {
namespace {

/// Ranges of at most this many triangles on average are gathered: copying them takes less time than beginning them.
constexpr uint64_t kSmallRange = 128;

template <typename Index>
void copyRanges(std::span<const uint32_t> indices, std::span<const DrawRange> ranges, void* into) {
    auto* to = static_cast<Index*>(into);
    for (const DrawRange& range : ranges)
        to = std::ranges::transform(indices.subspan(range.firstIndex, range.indexCount), to, [](uint32_t index) {
                 return static_cast<Index>(index);
             }).out;
}

uint64_t indicesOf(const SubmittedRun& run) {
    uint64_t sum = 0;
    for (const DrawRange& range : run.ranges) sum += range.indexCount;
    return sum;
}

}  // namespace

bool worthGathering(const SubmittedRun& run) { return indicesOf(run) <= run.ranges.size() * 3 * kSmallRange; }

void drawGathered(const SceneBuffers& buffers, const DrawList& list, const SubmittedRun& run, unsigned vertexArray) {
    const uint32_t mesh = buffers.scene().instances()[run.ranges.front().instance].mesh;
    const std::span<const uint32_t> ordered = list.orderOf(mesh).indices;
    const std::span<const uint32_t> indices = ordered.empty() ? buffers.scene().meshes()[mesh]->indices() : ordered;
    const uint64_t count = indicesOf(run);
    const bool narrow = run.indexType == GL_UNSIGNED_SHORT;
    // A buffer of its own for each draw: OpenGL keeps it until it is drawn, and nothing waits for the draw before.
    GLuint buffer = 0;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(count * (narrow ? sizeof(uint16_t) : sizeof(uint32_t))), nullptr,
                         GL_MAP_WRITE_BIT);
    void* const into = glMapNamedBuffer(buffer, GL_WRITE_ONLY);
    if (into != nullptr) {
        if (narrow)
            copyRanges<uint16_t>(indices, run.ranges, into);
        else
            copyRanges<uint32_t>(indices, run.ranges, into);
        glUnmapNamedBuffer(buffer);
        glVertexArrayElementBuffer(vertexArray, buffer);
        glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), run.indexType, nullptr);
        glVertexArrayElementBuffer(vertexArray, run.indexBuffer);
    } else {
        // Where memory runs out, as many ranges as there are.
        glMultiDrawElements(GL_TRIANGLES, run.counts.data(), run.indexType, run.addresses.data(),
                            static_cast<GLsizei>(run.counts.size()));
    }
    glDeleteBuffers(1, &buffer);
}

}  // namespace cullscope
