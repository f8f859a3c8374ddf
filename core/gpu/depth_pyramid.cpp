#include "core/gpu/depth_pyramid.h"

#include <algorithm>
#include <bit>
#include <glm/gtc/type_ptr.hpp>

#include "core/base/error.h"
#include "core/gpu/drawing.h"
#include "embedded/shaders.h"

namespace cullscope {
namespace {

// As depth_pyramid.comp and box_pyramid.comp declare them.
enum ReduceUniform : GLint { kBelowSize = 0, kStart = 1, kLevels = 2, kBelowStart = 3 };
enum TestUniform : GLint { kClipFromEye = 0, kSize = 4, kBoxCount = 5 };
enum Binding : GLuint { kPyramid = 0, kBoxes = 1, kShows = 2, kReadings = 3, kBindings = 4 };
constexpr unsigned kTileOfTexels = 8;  // on each side
constexpr int kLevelsAtOnce = 3;
constexpr unsigned kGroupOfBoxes = 64;

struct BoxOnGpu {
    Vec3f centre{0.0f};
    uint32_t group = 0;
    Vec3f halfExtent{0.0f};
    uint32_t unused = 0;
};
struct ReadingOnGpu {
    uint32_t levelAndTexels = 0;
    float nearest = 0.0f, farthest = 0.0f;
};

unsigned groupsFor(size_t invocations, unsigned size) { return static_cast<unsigned>((invocations + size - 1) / size); }

/// Restores what a compute shader's bindings change.
class ComputeState {
public:
    ComputeState(const Program& program, const Framebuffer& picture) {
        glUseProgram(program.id());
        glBindTextureUnit(0, picture.depthTexture());
    }
    ~ComputeState() {
        for (GLuint binding = 0; binding < kBindings; ++binding) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, 0);
        glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
        glBindTextureUnit(0, 0);
        glUseProgram(0);
    }
    ComputeState(const ComputeState&) = delete;
    ComputeState& operator=(const ComputeState&) = delete;
};

std::vector<BoxOnGpu> boxesOnGpu(std::span<const EyeBox> boxes, std::span<const uint32_t> ends) {
    std::vector<BoxOnGpu> result;
    result.reserve(boxes.size());
    uint32_t group = 0;
    for (const EyeBox& box : boxes) {
        const auto number = uint32_t(result.size());
        if (ends.empty())
            group = number;
        else if (number == ends[group])
            ++group;
        result.push_back({Vec3f(box.centre), group, Vec3f(box.halfExtent), 0});
    }
    return result;
}

}  // namespace

AnswerBuffers::Buffer AnswerBuffers::take(size_t bytes) {
    const std::lock_guard lock(m_mutex);
    const auto fits = std::ranges::find_if(m_unused, [&](const Buffer& buffer) { return buffer.bytes >= bytes; });
    if (fits != m_unused.end()) {
        const Buffer buffer = *fits;
        m_unused.erase(fits);
        return buffer;
    }
    Buffer buffer{0, std::bit_ceil(std::max<size_t>(bytes, 64))};
    glCreateBuffers(1, &buffer.name);
    glNamedBufferStorage(buffer.name, static_cast<GLsizeiptr>(buffer.bytes), nullptr, 0);
    m_all.push_back(buffer);
    return buffer;
}

void AnswerBuffers::giveBack(const Buffer& buffer) {
    const std::lock_guard lock(m_mutex);
    if (!m_closed) m_unused.push_back(buffer);
}

void AnswerBuffers::close() {
    const std::lock_guard lock(m_mutex);
    for (const Buffer& buffer : m_all) glDeleteBuffers(1, &buffer.name);
    m_all.clear();
    m_unused.clear();
    m_closed = true;
}

bool AnswerBuffers::closed() const {
    const std::lock_guard lock(m_mutex);
    return m_closed;
}

PyramidTicket::PyramidTicket(std::shared_ptr<AnswerBuffers> pool, size_t boxes, size_t groups)
    : BoxTicket(groups),
      m_pool(std::move(pool)),
      m_boxes(boxes),
      m_shows(m_pool->take(groups * sizeof(uint32_t))),
      m_readings(m_pool->take(boxes * sizeof(ReadingOnGpu))) {
    glClearNamedBufferData(m_shows.name, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

PyramidTicket::~PyramidTicket() {
    m_pool->giveBack(m_shows);
    m_pool->giveBack(m_readings);
}

std::optional<std::vector<uint32_t>> PyramidTicket::answer(const AnswerBuffers& pool) {
    if (!isOf(pool)) return std::nullopt;
    const std::lock_guard lock(m_mutex);
    if (!m_answer) {
        std::vector<uint32_t> shows(answers());
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetNamedBufferSubData(m_shows.name, 0, static_cast<GLsizeiptr>(shows.size() * sizeof(uint32_t)), shows.data());
        m_answer.emplace();
        for (uint32_t group = 0; group < shows.size(); ++group)
            if (shows[group] != 0) m_answer->push_back(group);
    }
    return m_answer;
}

std::vector<PyramidReading> PyramidTicket::read(const AnswerBuffers& pool) const {
    if (!isOf(pool)) return {};
    std::vector<ReadingOnGpu> read(m_boxes);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(m_readings.name, 0, static_cast<GLsizeiptr>(read.size() * sizeof(ReadingOnGpu)), read.data());
    std::vector<PyramidReading> readings;
    readings.reserve(read.size());
    for (const ReadingOnGpu& one : read)
        readings.push_back({one.levelAndTexels >> 16, one.levelAndTexels & 0xffff, one.nearest, one.farthest});
    return readings;
}

DepthPyramid::DepthPyramid()
    : m_reducePicture(Program::compute(embedded::depth_pyramid_comp, "#define BELOW_IS_THE_PICTURE\n")),
      m_reduceLevels(Program::compute(embedded::depth_pyramid_comp)),
      m_test(Program::compute(embedded::box_pyramid_comp)) {}

DepthPyramid::~DepthPyramid() {
    if (m_buffer != 0) glDeleteBuffers(1, &m_buffer);
}

void DepthPyramid::reduce(const Framebuffer& picture) {
    if (const uint64_t bytes = std::max<uint64_t>(pyramidBytes(picture.size()), sizeof(float)); bytes > m_bytes) {
        if (m_buffer != 0) glDeleteBuffers(1, &m_buffer);
        glCreateBuffers(1, &m_buffer);
        glNamedBufferStorage(m_buffer, static_cast<GLsizeiptr>(bytes), nullptr, 0);
        m_bytes = bytes;
    }
    const ComputeState state(m_reducePicture, picture);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kPyramid, m_buffer);
    Viewport below = picture.size();
    int belowStart = -1, start = 0;
    const auto halved = [](const Viewport& size) { return Viewport{(size.width + 1) / 2, (size.height + 1) / 2}; };
    while (below.width > 1 || below.height > 1) {
        glUniform2i(kBelowSize, below.width, below.height);
        glUniform1i(kStart, start);
        if (belowStart >= 0) glUniform1i(kBelowStart, belowStart);
        int levels = 0;
        for (; levels < kLevelsAtOnce && (below.width > 1 || below.height > 1); ++levels) {
            below = halved(below);
            belowStart = start;
            start += below.width * below.height;
        }
        glUniform1i(kLevels, levels);
        Viewport last = below;
        for (int missing = levels; missing < kLevelsAtOnce; ++missing) last = halved(last);
        glDispatchCompute(groupsFor(size_t(last.width), kTileOfTexels), groupsFor(size_t(last.height), kTileOfTexels), 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
        glUseProgram(m_reduceLevels.id());
    }
}

void DepthPyramid::test(const View& view, std::span<const EyeBox> boxes, std::span<const uint32_t> ends,
                        const Framebuffer& picture, const PyramidTicket& ticket) {
    const std::vector<BoxOnGpu> given = boxesOnGpu(boxes, ends);
    GLuint asked = 0;
    glCreateBuffers(1, &asked);
    glNamedBufferStorage(asked, static_cast<GLsizeiptr>(given.size() * sizeof(BoxOnGpu)), given.data(), 0);
    const ComputeState state(m_test, picture);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kPyramid, m_buffer);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kBoxes, asked);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kShows, ticket.shows());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kReadings, ticket.readings());
    glUniformMatrix4fv(kClipFromEye, 1, GL_FALSE, glm::value_ptr(Mat4f(view.clipFromEyeRelative())));
    glUniform2i(kSize, picture.size().width, picture.size().height);
    glUniform1ui(kBoxCount, static_cast<GLuint>(given.size()));
    glDispatchCompute(groupsFor(given.size(), kGroupOfBoxes), 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    glDeleteBuffers(1, &asked);
}

BoxTicketPointer Renderer::askPyramid(const View& view, std::span<const EyeBox> boxes, const Framebuffer& drawn,
                                      std::span<const uint32_t> ends, uint64_t reduction) {
    auto ticket = std::make_shared<PyramidTicket>(m_programs->answers, boxes.size(), ends.empty() ? boxes.size() : ends.size());
    if (boxes.empty()) return ticket;
    if (!m_programs->pyramid) m_programs->pyramid = std::make_unique<DepthPyramid>();
    if (reduction == 0 || reduction != m_reductions) {
        m_programs->pyramid->reduce(drawn);
        ++m_reductions;
    }
    m_programs->pyramid->test(view, boxes, ends, drawn, *ticket);
    return ticket;
}

std::vector<PyramidReading> Renderer::readings(BoxTicket& ticket) const {
    const auto* asked = dynamic_cast<const PyramidTicket*>(&ticket);
    return asked == nullptr ? std::vector<PyramidReading>{} : asked->read(*m_programs->answers);
}

}  // namespace cullscope
