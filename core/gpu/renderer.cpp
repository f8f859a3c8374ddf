#include "core/gpu/renderer.h"

#include <epoxy/gl.h>

#include <cassert>
#include <glm/gtc/type_ptr.hpp>

#include "core/gpu/program.h"
#include "embedded/shaders.h"

namespace cullscope {
namespace {

/// Uniform locations that the shaders declare.
enum Uniform : GLint {
    kClipFromPositions = 0,
    kEyeRelativeFromPositions = 1,
    kNormalMatrix = 2,
    kSurfaceColour = 3,
    kFirstTriangle = 4
};

constexpr GLuint kPosition = 0;
constexpr GLuint kNormal = 1;

/// OpenGL's state while the renderer works: reversed-Z into a framebuffer; back to the defaults that Qt expects afterwards.
class DrawingState {
public:
    DrawingState(const Viewport& viewport, unsigned framebuffer, Facing facing) {
        glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_previousDraw);
        glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_previousRead);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        glViewport(0, 0, viewport.width, viewport.height);
        glDisable(GL_SCISSOR_TEST);
        glDisable(GL_BLEND);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_GREATER);
        glDepthMask(GL_TRUE);
        glClearDepth(0.0);
        if (facing == Facing::Front)
            glEnable(GL_CULL_FACE);
        else
            glDisable(GL_CULL_FACE);
        glCullFace(GL_BACK);
    }
    ~DrawingState() {
        glBindVertexArray(0);
        glUseProgram(0);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        glFrontFace(GL_CCW);
        glDisable(GL_CULL_FACE);
        glClearColor(0, 0, 0, 0);
        glClearDepth(1.0);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LESS);
        glDisable(GL_DEPTH_TEST);
        glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_previousDraw));
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(m_previousRead));
    }
    DrawingState(const DrawingState&) = delete;
    DrawingState& operator=(const DrawingState&) = delete;

private:
    GLint m_previousDraw = 0;
    GLint m_previousRead = 0;
};

void setInstanceUniforms(const View& view, const Instance& instance, const TriangleMesh& mesh) {
    const Mat4f clip = view.clipFromPositions(instance.worldFromMesh, mesh.origin());
    const Mat4f eyeRelative = view.eyeRelativeFromPositions(instance.worldFromMesh, mesh.origin());
    // Scaled to its largest entry so that tiny and huge instances keep their normals in float.
    glm::dmat3 normals = glm::transpose(glm::inverse(Mat3(instance.worldFromMesh)));
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(normals[c][r]));
    if (largest > 0.0 && std::isfinite(largest)) normals /= largest;
    const glm::mat3 normalMatrix(normals);
    glUniformMatrix4fv(kClipFromPositions, 1, GL_FALSE, glm::value_ptr(clip));
    glUniformMatrix4fv(kEyeRelativeFromPositions, 1, GL_FALSE, glm::value_ptr(eyeRelative));
    glUniformMatrix3fv(kNormalMatrix, 1, GL_FALSE, glm::value_ptr(normalMatrix));
    // A mirrored instance turns its triangles around.
    glFrontFace(glm::determinant(Mat3(instance.worldFromMesh)) < 0.0 ? GL_CW : GL_CCW);
}

}  // namespace

struct Renderer::Programs {
    Program lambert{embedded::scene_vert, embedded::lambert_frag};
    Program depth{embedded::scene_vert, embedded::depth_frag};
    Program item{embedded::scene_vert, embedded::item_frag};
    unsigned vertexArray = 0;

    Programs() {
        glCreateVertexArrays(1, &vertexArray);
        for (const GLuint attribute : {kPosition, kNormal}) {
            glEnableVertexArrayAttrib(vertexArray, attribute);
            glVertexArrayAttribFormat(vertexArray, attribute, 3, GL_FLOAT, GL_FALSE, 0);
            glVertexArrayAttribBinding(vertexArray, attribute, attribute);
        }
    }
    ~Programs() { glDeleteVertexArrays(1, &vertexArray); }
    Programs(const Programs&) = delete;
    Programs& operator=(const Programs&) = delete;
};

Renderer::Renderer() : m_programs(std::make_unique<Programs>()) {}
Renderer::~Renderer() = default;

namespace {

/// Binds one mesh after the other as vertex input and hands out index addresses.
class VertexInput {
public:
    VertexInput(const SceneBuffers& buffers, unsigned vertexArray) : m_buffers(buffers), m_vertexArray(vertexArray) {
        glBindVertexArray(client() ? 0 : vertexArray);
        if (!client()) return;
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        glEnableVertexAttribArray(kPosition);
        glEnableVertexAttribArray(kNormal);
    }
    ~VertexInput() {
        if (!client()) return;
        glDisableVertexAttribArray(kPosition);
        glDisableVertexAttribArray(kNormal);
    }
    VertexInput(const VertexInput&) = delete;
    VertexInput& operator=(const VertexInput&) = delete;

    void bind(uint32_t meshIndex) {
        if (m_bound == meshIndex) return;
        m_bound = meshIndex;
        const TriangleMesh& mesh = *m_buffers.scene().meshes()[meshIndex];
        if (client()) {
            glVertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), mesh.positions().data());
            glVertexAttribPointer(kNormal, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), mesh.normals().data());
            m_indices = reinterpret_cast<const char*>(mesh.indices().data());
            return;
        }
        const SceneBuffers::MeshBuffers& gpu = m_buffers.mesh(meshIndex);
        glVertexArrayVertexBuffer(m_vertexArray, kPosition, gpu.vertices, 0, sizeof(Vec3f));
        glVertexArrayVertexBuffer(m_vertexArray, kNormal, gpu.vertices, static_cast<GLintptr>(gpu.normalsOffset), sizeof(Vec3f));
        glVertexArrayElementBuffer(m_vertexArray, gpu.indices);
        m_indices = nullptr;
    }
    [[nodiscard]] const void* indexAddress(uint32_t firstIndex) const {
        return m_indices + size_t{firstIndex} * sizeof(uint32_t);
    }

private:
    [[nodiscard]] bool client() const { return m_buffers.upload() == Upload::VertexArray; }

    const SceneBuffers& m_buffers;
    unsigned m_vertexArray;
    uint32_t m_bound = UINT32_MAX;
    const char* m_indices = nullptr;
};

/// Walks a list: `perInstance(instance)` once for each run of ranges of one instance, then one multi-draw for the run.
template <typename PerInstance>
void submit(const SceneBuffers& buffers, const View& view, const DrawList& list, unsigned vertexArray,
            const PerInstance& perInstance) {
    const Scene& scene = buffers.scene();
    VertexInput input(buffers, vertexArray);
    std::vector<GLsizei> counts;
    std::vector<const void*> addresses;
    for (size_t begin = 0, end = 0; begin < list.ranges.size(); begin = end) {
        const uint32_t number = list.ranges[begin].instance;
        const Instance& instance = scene.instances()[number];
        input.bind(instance.mesh);
        setInstanceUniforms(view, instance, *scene.meshes()[instance.mesh]);
        counts.clear();
        addresses.clear();
        for (; end < list.ranges.size() && list.ranges[end].instance == number; ++end) {
            counts.push_back(static_cast<GLsizei>(list.ranges[end].indexCount));
            addresses.push_back(input.indexAddress(list.ranges[end].firstIndex));
        }
        perInstance(std::span(list.ranges).subspan(begin, end - begin), counts, addresses);
    }
}

void multiDraw(const std::vector<GLsizei>& counts, const std::vector<const void*>& addresses) {
    if (counts.size() == 1)
        glDrawElements(GL_TRIANGLES, counts[0], GL_UNSIGNED_INT, addresses[0]);
    else
        glMultiDrawElements(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, addresses.data(), static_cast<GLsizei>(counts.size()));
}

}  // namespace

void Renderer::draw(const SceneBuffers& buffers, const View& view, const DrawList& list, Framebuffer& target,
                    const DrawStyle& style) {
    assert(view.viewport() == target.size());
    const DrawingState state(target.size(), target.id(), list.facing);
    glClearColor(style.background.x, style.background.y, style.background.z, style.backgroundAlpha);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(m_programs->lambert.id());
    glUniform3fv(kSurfaceColour, 1, glm::value_ptr(style.surface));
    submit(buffers, view, list, m_programs->vertexArray,
           [](std::span<const DrawRange>, const auto& counts, const auto& addresses) { multiDraw(counts, addresses); });
}

Renderer::ItemBuffer Renderer::drawItemBuffer(const SceneBuffers& buffers, const View& view, const DrawList& list) {
    const Viewport size = view.viewport();
    Framebuffer target(size);
    unsigned items = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &items);
    glTextureStorage2D(items, 1, GL_R32UI, size.width, size.height);
    constexpr GLuint kNothing = UINT32_MAX;
    glClearTexImage(items, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, &kNothing);
    {
        const DrawingState state(size, target.id(), list.facing);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glUseProgram(m_programs->depth.id());
        submit(buffers, view, list, m_programs->vertexArray,
               [](std::span<const DrawRange>, const auto& counts, const auto& addresses) { multiDraw(counts, addresses); });

        glDepthFunc(GL_EQUAL);
        glDepthMask(GL_FALSE);
        glUseProgram(m_programs->item.id());
        glBindImageTexture(0, items, 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
        submit(buffers, view, list, m_programs->vertexArray,
               [&](std::span<const DrawRange> ranges, const auto& counts, const auto& addresses) {
                   // gl_PrimitiveID counts from 0 in every draw: each range says where it starts.
                   for (size_t i = 0; i < ranges.size(); ++i) {
                       const uint64_t first = buffers.scene().firstTriangle(ranges[i].instance) + ranges[i].firstIndex / 3;
                       glUniform1ui(kFirstTriangle, static_cast<GLuint>(first));
                       glDrawElements(GL_TRIANGLES, counts[i], GL_UNSIGNED_INT, addresses[i]);
                   }
               });
        glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
        glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_READ_ONLY, GL_R32UI);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    ItemBuffer result{target.readDepth(),
                      std::vector<uint32_t>(static_cast<size_t>(size.width) * static_cast<size_t>(size.height))};
    glGetTextureImage(items, 0, GL_RED_INTEGER, GL_UNSIGNED_INT, static_cast<GLsizei>(result.triangle.size() * sizeof(uint32_t)),
                      result.triangle.data());
    glDeleteTextures(1, &items);
    // The image holds triangle numbers with "nothing" as the largest; the result counts from 1 with 0 as nothing: one addition
    // wraps.
    for (uint32_t& triangle : result.triangle) ++triangle;
    return result;
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
