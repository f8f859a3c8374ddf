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

GatheredIndices::~GatheredIndices() { glDeleteBuffers(1, &m_buffer); }

bool GatheredIndices::fill(size_t bytes, const std::function<void(void* memory)>& write) {
    if (bytes > m_bytes) {
        glDeleteBuffers(1, &m_buffer);
        m_bytes = bytes + bytes / 2;
        glCreateBuffers(1, &m_buffer);
        glNamedBufferStorage(m_buffer, static_cast<GLsizeiptr>(m_bytes), nullptr, GL_MAP_WRITE_BIT);
    }
    void* const memory =
        glMapNamedBufferRange(m_buffer, 0, static_cast<GLsizeiptr>(bytes), GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
    if (memory == nullptr) {
        m_bytes = 0;
        return false;
    }
    write(memory);
    glUnmapNamedBuffer(m_buffer);
    return true;
}

bool drawGathered(const SceneBuffers& buffers, const DrawList& list, const SubmittedRun& run, const TriangleInput& by) {
    const uint32_t mesh = buffers.scene().instances()[run.ranges.front().instance].mesh;
    const std::span<const uint32_t> ordered = list.orderOf(mesh).indices;
    const std::span<const uint32_t> indices = ordered.empty() ? buffers.scene().meshes()[mesh]->indices() : ordered;
    const uint64_t count = indicesOf(run);
    const bool narrow = run.indexType == GL_UNSIGNED_SHORT;
    const bool filled = by.gathered->fill(count * (narrow ? sizeof(uint16_t) : sizeof(uint32_t)), [&](void* memory) {
        if (narrow)
            copyRanges<uint16_t>(indices, run.ranges, memory);
        else
            copyRanges<uint32_t>(indices, run.ranges, memory);
    });
    if (!filled) return false;
    glVertexArrayElementBuffer(by.vertexArray, by.gathered->buffer());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), run.indexType, nullptr);
    glVertexArrayElementBuffer(by.vertexArray, run.indexBuffer);
    return true;
}

}  // namespace cullscope
