// Draws of which a compute shader chooses: it writes the number of instances (0 or 1) into commands that are drawn indirectly.

#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/gpu/depth_pyramid.h"
#include "core/gpu/submission.h"

namespace cullscope {
namespace {

/// As glMultiDrawElementsIndirect reads it.
struct IndirectDraw {
    GLuint indexCount = 0;
    GLuint instances = 0;
    GLuint firstIndex = 0;
    GLuint baseVertex = 0;
    GLuint baseInstance = 0;
};

constexpr GLuint kCommandsBinding = 0;
constexpr GLuint kDataBinding = 1;
constexpr unsigned kGroupSize = 64;

std::string shaderOf(const std::string& declarations) {
    return "#version 450\n"
           "layout(local_size_x = 64) in;\n"
           "struct Draw { uint indexCount, instances, firstIndex, baseVertex, baseInstance; };\n"
           "layout(std430, binding = 0) buffer Draws { Draw draws[]; };\n" +
           declarations +
           "void main() {\n"
           "    uint candidate = gl_GlobalInvocationID.x;\n"
           "    if (candidate < draws.length()) draws[candidate].instances = chosen(candidate) ? 1u : 0u;\n"
           "}\n";
}

std::string shaderAround(const std::string& body) {
    return shaderOf("layout(std430, binding = 1) readonly buffer Data { float data[]; };\nbool chosen(uint candidate) {\n" +
                    body + "\n}\n");
}

/// Chooses by the answers to a question.
std::string shaderOfAnswers() {
    return shaderOf(
        "layout(std430, binding = 1) readonly buffer Shows { uint shows[]; };\n"
        "bool chosen(uint candidate) { return shows[candidate] != 0u; }\n");
}

unsigned storage(const void* data, size_t bytes) {
    unsigned buffer = 0;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(std::max<size_t>(bytes, 4)), bytes > 0 ? data : nullptr, 0);
    return buffer;
}

}  // namespace

Renderer::Choice::~Choice() {
    if (m_commands != 0) glDeleteBuffers(1, &m_commands);
}

Renderer::Choice::Choice(Choice&& other) noexcept
    : m_buffers(other.m_buffers), m_candidates(std::move(other.m_candidates)), m_commands(std::exchange(other.m_commands, 0)) {}

DrawList Renderer::Choice::chosen() const {
    std::vector<IndirectDraw> draws(m_candidates.ranges.size());
    DrawList list = m_candidates;
    list.ranges.clear();
    if (draws.empty()) return list;
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(m_commands, 0, static_cast<GLsizeiptr>(draws.size() * sizeof(IndirectDraw)), draws.data());
    for (size_t i = 0; i < draws.size(); ++i)
        if (draws[i].instances != 0) list.ranges.push_back(m_candidates.ranges[i]);
    return list;
}

namespace {

/// The commands that draw the candidates, of which a program with `data` has chosen.
unsigned commandsOf(const DrawList& candidates, const Program& program, unsigned data) {
    std::vector<IndirectDraw> draws;
    draws.reserve(candidates.ranges.size());
    for (const DrawRange& range : candidates.ranges) draws.push_back({range.indexCount, 0, range.firstIndex, 0, 0});
    const unsigned commands = storage(draws.data(), draws.size() * sizeof(IndirectDraw));
    if (draws.empty()) return commands;
    glUseProgram(program.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kCommandsBinding, commands);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kDataBinding, data);
    glDispatchCompute(static_cast<GLuint>((draws.size() + kGroupSize - 1) / kGroupSize), 1, 1);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
    for (const GLuint binding : {kCommandsBinding, kDataBinding}) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, 0);
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, 0);
    glUseProgram(0);
    return commands;
}

const Program& choosing(std::map<std::string, Program>& programs, std::string source) {
    auto program = programs.find(source);
    if (program == programs.end()) {
        Program made = Program::compute(source);
        program = programs.emplace(std::move(source), std::move(made)).first;
    }
    return program->second;
}

}  // namespace

Renderer::Choice Renderer::choose(const SceneBuffers& buffers, const GpuChoice& choice) {
    const Program& program = choosing(m_programs->choices, shaderAround(choice.body));
    const unsigned data = storage(choice.data.data(), choice.data.size() * sizeof(float));
    const unsigned commands = commandsOf(choice.candidates, program, data);
    glDeleteBuffers(1, &data);
    return {buffers, choice.candidates, commands};
}

std::optional<Renderer::Choice> Renderer::choose(const SceneBuffers& buffers, BoxTicket& ticket, const DrawList& candidates) {
    const auto* asked = dynamic_cast<const PyramidTicket*>(&ticket);
    if (asked == nullptr || !asked->isOf(*m_programs->answers)) return std::nullopt;
    const Program& program = choosing(m_programs->choices, shaderOfAnswers());
    return Choice(buffers, candidates, commandsOf(candidates, program, asked->shows()));
}

void Renderer::execute(const View& view, const Choice& choice, Framebuffer& target, const DrawStyle& style, bool cleared) {
    const DrawList& list = choice.m_candidates;
    if (cleared) target.dropDepth();
    const DrawingState state(view, target, list.facing, list.depth);
    if (cleared) clearTo(style);
    glUseProgram(m_programs->of(view).lambert.id());
    setSurfaceColours(style);
    VertexInput input(*choice.m_buffers, m_programs->vertexArray, list.order, list.facing);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, choice.m_commands);
    for (size_t begin = 0, end = 0; begin < list.ranges.size(); begin = end) {
        while (end < list.ranges.size() && list.ranges[end].instance == list.ranges[begin].instance) ++end;
        input.bind(view, list.ranges[begin].instance, VertexInput::Indices::InOrder);
        glMultiDrawElementsIndirect(GL_TRIANGLES, input.indexType(), reinterpret_cast<const void*>(begin * sizeof(IndirectDraw)),
                                    static_cast<GLsizei>(end - begin), 0);
    }
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

}  // namespace cullscope
