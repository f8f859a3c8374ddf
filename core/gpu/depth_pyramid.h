#pragma once

#include <epoxy/gl.h>

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/frame/commands.h"
#include "core/gpu/framebuffer.h"
#include "core/gpu/program.h"

namespace cullscope {

/// OpenGL's buffers of one context for what compute shaders answer, which are used again. As with BoxQueries, they are given back
/// on any thread, and also when the context is gone: only `take` and `close` call OpenGL.
class AnswerBuffers {
public:
    struct Buffer {
        unsigned name = 0;
        size_t bytes = 0;
    };
    /// At least so many bytes. Needs the context.
    [[nodiscard]] Buffer take(size_t bytes);
    void giveBack(const Buffer& buffer);
    /// Deletes all buffers, also those that were not given back. Needs the context.
    void close();
    [[nodiscard]] bool closed() const;

private:
    mutable std::mutex m_mutex;
    std::vector<Buffer> m_all, m_unused;
    bool m_closed = false;
};

/// A question that a depth pyramid answers.
class PyramidTicket final : public BoxTicket {
public:
    /// Needs the context of `pool`.
    PyramidTicket(std::shared_ptr<AnswerBuffers> pool, size_t boxes, size_t groups);
    ~PyramidTicket() override;

    /// Whether it was asked in the context of these buffers, which still exists.
    [[nodiscard]] bool isOf(const AnswerBuffers& pool) const { return m_pool.get() == &pool && !pool.closed(); }
    /// A word for each group: whether it is visible.
    [[nodiscard]] unsigned shows() const { return m_shows.name; }
    /// A PyramidReading for each box, as the shader writes it.
    [[nodiscard]] unsigned readings() const { return m_readings.name; }
    /// The numbers of the groups that are visible; none in a context that is not that of `pool`.
    [[nodiscard]] std::optional<std::vector<uint32_t>> answer(const AnswerBuffers& pool);
    [[nodiscard]] std::vector<PyramidReading> read(const AnswerBuffers& pool) const;

private:
    std::shared_ptr<AnswerBuffers> m_pool;
    size_t m_boxes;
    AnswerBuffers::Buffer m_shows, m_readings;
    std::mutex m_mutex;
    std::optional<std::vector<uint32_t>> m_answer;  ///< once it was asked for
};

/// The depth pyramid of the picture that was reduced last. A level has half the columns and rows of the level below, rounded up,
/// so a texel stands for the same pixels at any size of a picture, and a pixel for one texel of each level.
class DepthPyramid {
public:
    DepthPyramid();
    ~DepthPyramid();
    DepthPyramid(const DepthPyramid&) = delete;
    DepthPyramid& operator=(const DepthPyramid&) = delete;

    /// Reduces the depth of a picture, three levels at a time.
    void reduce(const Framebuffer& picture);
    /// Tests boxes against it; `picture` is the one that was reduced last.
    void test(const View& view, std::span<const EyeBox> boxes, std::span<const uint32_t> ends, const Framebuffer& picture,
              const PyramidTicket& ticket);

private:
    Program m_reducePicture, m_reduceLevels, m_test;
    unsigned m_buffer = 0;  ///< the levels from 1 on, one after the other, row by row
    uint64_t m_bytes = 0;
};

}  // namespace cullscope
