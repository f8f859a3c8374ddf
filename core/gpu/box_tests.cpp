// Visibility tests of boxes by OpenGL: in selection mode and by occlusion queries. Neither writes a pixel.

#include <glm/gtc/type_ptr.hpp>

#include "core/base/error.h"
#include "core/gpu/box_queries.h"
#include "core/gpu/depth_pyramid.h"
#include "core/gpu/drawing.h"

namespace cullscope {
namespace {

constexpr GLsizei kCorners = 8;
constexpr GLuint kWordsOfAHit = 4;  // number of names, least and largest depth, the name

/// Faces of a box as quadrilaterals of its corners: bit 0, 1, 2 of a corner's number are its x, y, z.
constexpr std::array<uint16_t, 24> kQuads{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
/// The same as triangles.
constexpr std::array<uint16_t, 36> kTriangles{0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                              2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};

std::vector<Vec3f> cornersOf(std::span<const EyeBox> boxes) {
    std::vector<Vec3f> corners;
    corners.reserve(boxes.size() * kCorners);
    for (const EyeBox& box : boxes)
        for (int c = 0; c < kCorners; ++c)
            corners.emplace_back(box.centre +
                                 box.halfExtent * Vec3((c & 1) != 0 ? 1 : -1, (c & 2) != 0 ? 1 : -1, (c & 4) != 0 ? 1 : -1));
    return corners;
}

/// A framebuffer of the picture's size without attachments, for draws that only produce hits or query results. Sets both sides
/// drawn, filled.
class EmptyFramebuffer {
public:
    explicit EmptyFramebuffer(const Viewport& size) {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_draw);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_read);
        glCreateFramebuffers(1, &m_framebuffer);
        glNamedFramebufferParameteri(m_framebuffer, GL_FRAMEBUFFER_DEFAULT_WIDTH, size.width);
        glNamedFramebufferParameteri(m_framebuffer, GL_FRAMEBUFFER_DEFAULT_HEIGHT, size.height);
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer);
        glViewport(0, 0, size.width, size.height);
        glDisable(GL_SCISSOR_TEST);
        glDisable(GL_DEPTH_TEST);
        glDisable(GL_CULL_FACE);
        glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
    ~EmptyFramebuffer() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_draw));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(m_read));
        glDeleteFramebuffers(1, &m_framebuffer);
        glBindVertexArray(0);
        glUseProgram(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
    }
    EmptyFramebuffer(const EmptyFramebuffer&) = delete;
    EmptyFramebuffer& operator=(const EmptyFramebuffer&) = delete;

private:
    GLint m_draw = 0, m_read = 0;
    GLuint m_framebuffer = 0;
};

/// The fixed-function matrices of a view, for positions relative to the eye. Depth is reversed, as everywhere: with OpenGL's own
/// range of −1 … 1 a float matrix displaces the far plane by far / near · 2^-24 of its distance.
class FixedFunction {
public:
    FixedFunction(const View& view, const std::vector<Vec3f>& corners) {
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glMatrixMode(GL_PROJECTION);
        glPushMatrix();
        glLoadMatrixf(glm::value_ptr(Mat4f(view.clipFromEyeRelative())));
        glMatrixMode(GL_MODELVIEW);
        glPushMatrix();
        glLoadIdentity();
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        glEnableClientState(GL_VERTEX_ARRAY);
        glVertexPointer(3, GL_FLOAT, 0, corners.data());
    }
    ~FixedFunction() {
        glDisableClientState(GL_VERTEX_ARRAY);
        glPopMatrix();
        glMatrixMode(GL_PROJECTION);
        glPopMatrix();
        glMatrixMode(GL_MODELVIEW);
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }
    FixedFunction(const FixedFunction&) = delete;
    FixedFunction& operator=(const FixedFunction&) = delete;
};

/// Draws every box under its name and returns the number of hits; −1 where the hit buffer was too small.
GLint hitRecords(size_t boxes, std::vector<GLuint>& buffer) {
    glSelectBuffer(static_cast<GLsizei>(buffer.size()), buffer.data());
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(0);
    for (size_t box = 0; box < boxes; ++box) {
        glLoadName(static_cast<GLuint>(box));
        glDrawElementsBaseVertex(GL_QUADS, static_cast<GLsizei>(kQuads.size()), GL_UNSIGNED_SHORT, kQuads.data(),
                                 static_cast<GLint>(box) * kCorners);
    }
    return glRenderMode(GL_RENDER);
}

void requireSelectionMode() {
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    if ((profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) == 0)
        throwOpenGl(
            CULLSCOPE_TR("OpenGL's selection mode was removed from the core profile, and this OpenGL gives no compatibility "
                         "profile: ask by occlusion queries."));
}

/// A vertex array with positions only, and an index buffer with the triangles of one box.
class BoxArray {
public:
    explicit BoxArray(const std::vector<Vec3f>& corners) {
        glCreateBuffers(2, m_buffers.data());
        glNamedBufferStorage(m_buffers[0], static_cast<GLsizeiptr>(corners.size() * sizeof(Vec3f)), corners.data(), 0);
        glNamedBufferStorage(m_buffers[1], sizeof kTriangles, kTriangles.data(), 0);
        glCreateVertexArrays(1, &m_array);
        glEnableVertexArrayAttrib(m_array, kPosition);
        glVertexArrayAttribFormat(m_array, kPosition, 3, GL_FLOAT, GL_FALSE, 0);
        glVertexArrayVertexBuffer(m_array, kPosition, m_buffers[0], 0, sizeof(Vec3f));
        glVertexArrayElementBuffer(m_array, m_buffers[1]);
        glBindVertexArray(m_array);
    }
    ~BoxArray() {
        glBindVertexArray(0);
        glDeleteVertexArrays(1, &m_array);
        glDeleteBuffers(2, m_buffers.data());
    }
    BoxArray(const BoxArray&) = delete;
    BoxArray& operator=(const BoxArray&) = delete;

private:
    std::array<GLuint, 2> m_buffers{};
    GLuint m_array = 0;
};

}  // namespace

SelectedBoxes Renderer::selectBoxes(const View& view, std::span<const EyeBox> boxes, size_t bufferWords) {
    requireSelectionMode();
    SelectedBoxes selected{{}, std::max<size_t>(bufferWords, 1), 0};
    if (boxes.empty()) return selected;
    const std::vector<Vec3f> corners = cornersOf(boxes);
    const EmptyFramebuffer target(view.viewport());
    const FixedFunction matrices(view, corners);
    std::vector<GLuint> buffer(selected.bufferWords);
    GLint hits = hitRecords(boxes.size(), buffer);
    for (; hits < 0; hits = hitRecords(boxes.size(), buffer)) {
        ++selected.overflows;
        buffer.resize(2 * buffer.size());
    }
    selected.bufferWords = buffer.size();
    // A record: the number of names, the least and the largest depth as shares of 2^32 − 1, the name. Depth is reversed.
    const auto distance = [&](GLuint depth) { return view.distanceFromDepth(double(depth) / double(~GLuint{0})); };
    for (GLint hit = 0; hit < hits; ++hit) {
        const GLuint* record = &buffer[static_cast<size_t>(hit) * kWordsOfAHit];
        selected.hits.push_back(record[kWordsOfAHit - 1]);
        selected.distances.push_back({distance(record[2]), distance(record[1])});
    }
    return selected;
}

namespace {

/// One query for each box or group of boxes, with the program and the state that are set.
void drawQueries(std::span<const EyeBox> boxes, std::span<const uint32_t> ends, std::span<const unsigned> queries,
                 const View& view) {
    const BoxArray array(cornersOf(boxes));
    glUniformMatrix4fv(kClipFromPositions, 1, GL_FALSE, glm::value_ptr(Mat4f(view.clipFromEyeRelative())));
    size_t box = 0;
    for (size_t query = 0; query < queries.size(); ++query) {
        const size_t end = ends.empty() ? box + 1 : ends[query];
        glBeginQuery(GL_ANY_SAMPLES_PASSED_CONSERVATIVE, queries[query]);
        for (; box < end; ++box)
            glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(kTriangles.size()), GL_UNSIGNED_SHORT, nullptr,
                                     static_cast<GLint>(box) * kCorners);
        glEndQuery(GL_ANY_SAMPLES_PASSED_CONSERVATIVE);
    }
}

}  // namespace

BoxTicketPointer Renderer::askBoxes(const View& view, std::span<const EyeBox> boxes, std::span<const uint32_t> ends) {
    auto ticket = std::make_shared<AskedTicket>(m_programs->boxQueries, ends.empty() ? boxes.size() : ends.size());
    if (boxes.empty()) return ticket;
    const EmptyFramebuffer target(view.viewport());
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_CLAMP);
    glUseProgram(m_programs->scene.depth.id());
    drawQueries(boxes, ends, ticket->queries(), view);
    glDisable(GL_DEPTH_CLAMP);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    return ticket;
}

BoxTicketPointer Renderer::askBoxes(const View& view, std::span<const EyeBox> boxes, const Framebuffer& drawn,
                                    std::span<const uint32_t> ends) {
    auto ticket = std::make_shared<AskedTicket>(m_programs->boxQueries, ends.empty() ? boxes.size() : ends.size());
    if (boxes.empty()) return ticket;
    const DrawingState state(view, drawn, Facing::TwoSided);
    glEnable(GL_DEPTH_CLAMP);
    glDepthFunc(GL_GEQUAL);
    glDepthMask(GL_FALSE);
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glUseProgram(m_programs->scene.depth.id());
    drawQueries(boxes, ends, ticket->queries(), view);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    return ticket;
}

std::optional<std::vector<uint32_t>> Renderer::answer(BoxTicket& ticket) {
    if (auto* asked = dynamic_cast<AskedTicket*>(&ticket)) return asked->answer(*m_programs->boxQueries);
    if (auto* asked = dynamic_cast<PyramidTicket*>(&ticket)) return asked->answer(*m_programs->answers);
    return std::nullopt;
}

std::vector<uint32_t> Renderer::queryBoxes(const View& view, std::span<const EyeBox> boxes, std::span<const uint32_t> ends) {
    return *answer(*askBoxes(view, boxes, ends));
}

std::vector<uint32_t> Renderer::queryBoxes(const View& view, std::span<const EyeBox> boxes, const Framebuffer& drawn,
                                           std::span<const uint32_t> ends) {
    return *answer(*askBoxes(view, boxes, drawn, ends));
}

}  // namespace cullscope
