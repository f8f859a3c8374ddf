#include "core/gpu/renderer.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "core/base/freed_memory.h"
#include "core/gpu/box_queries.h"
#include "core/gpu/context.h"
#include "core/gpu/depth_pyramid.h"
#include "core/gpu/submission.h"
#include "embedded/shaders.h"

namespace cullscope {
namespace {

void addAttribute(unsigned array, GLuint attribute, size_t offset, GLuint binding) {
    glEnableVertexArrayAttrib(array, attribute);
    glVertexArrayAttribFormat(array, attribute, 3, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
    glVertexArrayAttribBinding(array, attribute, binding);
}

/// Begins shaded triangles within a drawing state, which resets the mode of polygons.
void beginShaded(const Program& lambert, const DrawStyle& style) {
    glUseProgram(lambert.id());
    setSurfaceColours(style);
    if (style.wireframe) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
}

/// Whether a replay makes the style's picture: the pixels of a finished picture have no edges.
bool replaysInStyle(const View& view, const FrameLog& log, const DrawStyle& style) {
    const auto isFinished = [](const Command& command) { return std::holds_alternative<FinishedPicturePointer>(command); };
    return replaysFrom(view, log) && !(style.wireframe && std::ranges::any_of(log.commands, isFinished));
}

}  // namespace

ScenePrograms::ScenePrograms(std::string_view vertexShader)
    : lambert(vertexShader, embedded::lambert_frag),
      depth(vertexShader, embedded::depth_frag),
      item(vertexShader, embedded::item_frag),
      itemOrdered(vertexShader, embedded::item_ordered_frag),
      state(vertexShader, embedded::state_frag) {}

ScenePrograms& Renderer::Programs::of(const View& view) {
    if (!view.section()) return scene;
    if (!sectionScene) sectionScene = std::make_unique<ScenePrograms>(embedded::scene_cut_vert);
    return *sectionScene;
}

void setSurfaceColours(const DrawStyle& style) {
    glUniform3fv(kSurfaceColour, 1, glm::value_ptr(style.surface));
    glUniform3fv(kBackColour, 1, glm::value_ptr(style.back.value_or(style.surface)));
}

Renderer::Programs::Programs()
    : scene(embedded::scene_vert),
      line(embedded::line_vert, embedded::line_frag),
      sphericalModel(embedded::spherical_model_vert, embedded::spherical_model_geom, embedded::spherical_model_frag),
      software(requireOpenGl45().software),
      boxQueries(std::make_shared<BoxQueries>()),
      answers(std::make_shared<AnswerBuffers>()),
      indirect(!software) {
    if (software) keepFreedMemory();
    glCreateVertexArrays(1, &vertexArray);
    for (const GLuint attribute : {kPosition, kNormal}) addAttribute(vertexArray, attribute, 0, attribute);
    glCreateVertexArrays(1, &lineArray);
    addAttribute(lineArray, 0, offsetof(LineOnGpu, from), 0);
    addAttribute(lineArray, 1, offsetof(LineOnGpu, to), 0);
    addAttribute(lineArray, 2, offsetof(LineOnGpu, colour), 0);
    glVertexArrayBindingDivisor(lineArray, 0, 1);
}

Renderer::Programs::~Programs() {
    glDeleteVertexArrays(1, &vertexArray);
    glDeleteVertexArrays(1, &lineArray);
    boxQueries->close();
    answers->close();
}

Renderer::Stoppable::Stoppable(Renderer& renderer, std::stop_token stop)
    : m_renderer(renderer), m_before(std::exchange(renderer.m_programs->stop, std::move(stop))) {}
Renderer::Stoppable::~Stoppable() { m_renderer.m_programs->stop = std::move(m_before); }

Renderer::Renderer(std::optional<bool> indirect) : m_programs(std::make_unique<Programs>()) {
    m_programs->indirect = indirect.value_or(m_programs->indirect);
}
Renderer::~Renderer() = default;

bool Renderer::drawsIndirectly() const { return m_programs->indirect; }

void Renderer::draw(const SceneBuffers& buffers, const View& view, const DrawList& list, Framebuffer& target,
                    const DrawStyle& style) {
    target.dropDepth();
    const DrawingState state(view, target, list.facing, list.depth);
    clearTo(style);
    beginShaded(m_programs->of(view).lambert, style);
    submitAll(buffers, view, list, m_programs->input());
}

void Renderer::clear(const View& view, Framebuffer& target, const DrawStyle& style) {
    target.dropDepth();
    const DrawingState state(view, target, Facing::TwoSided);
    clearTo(style);
}

void Renderer::execute(const SceneBuffers& buffers, const View& view, const Command& command, Framebuffer& target,
                       const DrawStyle& style, bool cleared) {
    if (const auto* picture = std::get_if<FinishedPicturePointer>(&command))
        return writePicture(buffers.scene(), view, *picture, style, target);
    if (cleared) target.dropDepth();
    const auto begin = [&] { beginShaded(m_programs->of(view).lambert, style); };
    if (const auto* list = std::get_if<DrawList>(&command)) {
        const DrawingState state(view, target, list->facing, list->depth);
        if (cleared) clearTo(style);
        begin();
        submitAll(buffers, view, *list, m_programs->input());
    }
    if (const auto* own = std::get_if<OwnTrianglesPointer>(&command)) {
        const DrawingState state(view, target, (*own)->facing, (*own)->depth);
        if (cleared) clearTo(style);
        begin();
        OwnInput(**own, m_programs->vertexArray).draw(buffers.scene(), view, [](const OwnTriangles::Run&) {});
    }
}

void Renderer::draw(const SceneBuffers& buffers, const View& view, const FrameLog& log, Framebuffer& target,
                    const DrawStyle& style) {
    if (!replaysInStyle(view, log, style)) return draw(buffers, view, drawnTriangles(buffers.scene(), log), target, style);
    bool cleared = false;
    for (const Command& command : log.commands) {
        if (std::holds_alternative<AskedBoxes>(command)) continue;
        execute(buffers, view, command, target, style, !cleared);
        cleared = true;
    }
    if (!cleared) clear(view, target, style);
}

void Renderer::drawOver(const SceneBuffers& buffers, const View& view, const DrawList& list, Framebuffer& target,
                        const DrawStyle& style) {
    const DrawingState state(view, target, list.facing, list.depth);
    glClear(GL_DEPTH_BUFFER_BIT);
    beginShaded(m_programs->of(view).lambert, style);
    submitAll(buffers, view, list, m_programs->input());
}

bool replaysFrom(const View& view, const FrameLog& log) {
    if (view.camera() == log.camera && view.viewport() == log.size && !view.section()) return true;
    return std::ranges::none_of(log.commands,
                                [](const Command& command) { return std::holds_alternative<FinishedPicturePointer>(command); });
}

DrawList everything(const Scene& scene, Facing facing) {
    DrawList list{facing, {}};
    list.ranges.reserve(scene.instances().size());
    for (uint32_t i = 0; i < scene.instances().size(); ++i)
        if (const size_t indices = scene.meshOf(i).indices().size(); indices > 0)
            list.ranges.push_back({i, 0, static_cast<uint32_t>(indices)});
    return list;
}

void waitForGpu() {
    const GLsync fence = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    while (glClientWaitSync(fence, GL_SYNC_FLUSH_COMMANDS_BIT, 1'000'000'000) == GL_TIMEOUT_EXPIRED) {
    }
    glDeleteSync(fence);
}

}  // namespace cullscope
