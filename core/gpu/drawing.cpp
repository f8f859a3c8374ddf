#include "core/gpu/drawing.h"

#include <algorithm>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>

namespace cullscope {
namespace {

void setCulling(bool on) {
    if (on)
        glEnable(GL_CULL_FACE);
    else
        glDisable(GL_CULL_FACE);
}

}  // namespace

DrawingState::DrawingState(const View& view, const Framebuffer& target, Facing facing, DepthRule depth) {
    const PictureTile& tile = target.tile();
    assert(tile.x >= 0 && tile.x + tile.size.width <= view.viewport().width);
    assert(tile.y >= 0 && tile.y + tile.size.height <= view.viewport().height);
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_previousDraw);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_previousRead);
    glBindFramebuffer(GL_FRAMEBUFFER, target.id());
    // The viewport of the whole picture, of which a tile shows a part.
    glViewport(-tile.x, -tile.y, view.viewport().width, view.viewport().height);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(depth == DepthRule::Nearest ? GL_GREATER : GL_ALWAYS);
    glDepthMask(GL_TRUE);
    glClearDepth(0.0);
    setCulling(facing == Facing::Front && !view.section());
    if (view.section()) glEnable(GL_CLIP_DISTANCE0);
    glCullFace(GL_BACK);
}

DrawingState::~DrawingState() {
    glBindVertexArray(0);
    glUseProgram(0);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    // Drawing that a stop request ended may have left these.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glLineWidth(1.0f);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_CLIP_DISTANCE0);
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

void clearTo(const DrawStyle& style) {
    glClearColor(style.background.x, style.background.y, style.background.z, style.backgroundAlpha);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void FacingState::setFor(const Scene& scene, uint32_t instance) {
    // The drawing state has set every other rule.
    if (m_rule != Facing::ByObject) return;
    const Facing facing = facingOf(scene, instance, m_rule);
    if (facing != m_current) setCulling(facing == Facing::Front);
    m_current = facing;
}

VertexInput::VertexInput(const SceneBuffers& buffers, unsigned vertexArray, TriangleOrderPointer order, Facing facing)
    : m_buffers(buffers), m_vertexArray(vertexArray), m_order(std::move(order)), m_facing(facing) {
    glBindVertexArray(client() ? 0 : vertexArray);
    if (!client()) return;
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
    glEnableVertexAttribArray(kPosition);
    glEnableVertexAttribArray(kNormal);
}

VertexInput::~VertexInput() {
    if (!client()) return;
    glDisableVertexAttribArray(kPosition);
    glDisableVertexAttribArray(kNormal);
}

void VertexInput::bindMesh(uint32_t mesh, Indices indices) {
    if (m_bound != mesh) bindVertices(mesh);
    if (m_bound != mesh || m_boundIndices != indices) bindIndices(mesh, indices);
    m_bound = mesh;
    m_boundIndices = indices;
}

void VertexInput::bindVertices(uint32_t meshIndex) {
    if (client()) {
        const TriangleMesh& mesh = *m_buffers.scene().meshes()[meshIndex];
        glVertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), mesh.positions().data());
        glVertexAttribPointer(kNormal, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), mesh.normals().data());
        return;
    }
    const SceneBuffers::MeshBuffers& gpu = m_buffers.mesh(meshIndex);
    glVertexArrayVertexBuffer(m_vertexArray, kPosition, gpu.vertices, 0, sizeof(Vec3f));
    glVertexArrayVertexBuffer(m_vertexArray, kNormal, gpu.vertices, static_cast<GLintptr>(gpu.normalsOffset), sizeof(Vec3f));
}

void VertexInput::bindIndices(uint32_t mesh, Indices indices) {
    m_indices = indices == Indices::Whole ? m_buffers.mesh(mesh).whole
                : m_order                 ? m_buffers.ordered(m_order, mesh)
                                          : m_buffers.ownOrder(mesh);
    if (!client()) glVertexArrayElementBuffer(m_vertexArray, m_indices.buffer);
}

namespace {

void setInstanceUniforms(const View& view, const Instance& instance, const TriangleMesh& mesh) {
    const Mat4f clip = view.clipFromPositions(instance.worldFromMesh, mesh.origin());
    const Mat4f sight = view.sightFromPositions(instance.worldFromMesh, mesh.origin());
    // Scaled by its largest entry, so that normals of tiny and huge instances stay within the range of float.
    glm::dmat3 normals = glm::transpose(glm::inverse(Mat3(instance.worldFromMesh)));
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(normals[c][r]));
    if (largest > 0.0 && std::isfinite(largest)) normals /= largest;
    const glm::mat3 normalMatrix(normals);
    glUniformMatrix4fv(kClipFromPositions, 1, GL_FALSE, glm::value_ptr(clip));
    glUniformMatrix4fv(kSightFromPositions, 1, GL_FALSE, glm::value_ptr(sight));
    glUniformMatrix3fv(kNormalMatrix, 1, GL_FALSE, glm::value_ptr(normalMatrix));
    if (view.section()) {
        // n·(L p + t) + d = (Lᵀ n)·p + (n·t + d), with the translation summed in double.
        const Mat3 linear(instance.worldFromMesh);
        const Vec3 normal = glm::transpose(linear) * view.section()->normal;
        const double offset = view.section()->distance(Vec3(instance.worldFromMesh[3]) + linear * mesh.origin());
        glUniform4f(kSection, float(normal.x), float(normal.y), float(normal.z), float(offset));
    }
    // A mirroring transform reverses the winding of its triangles.
    glFrontFace(glm::determinant(Mat3(instance.worldFromMesh)) < 0.0 ? GL_CW : GL_CCW);
}

}  // namespace

void VertexInput::bind(const View& view, uint32_t number, Indices indices) {
    const Instance& instance = m_buffers.scene().instances()[number];
    bindMesh(instance.mesh, indices);
    if (!view.section()) m_facing.setFor(m_buffers.scene(), number);
    setInstanceUniforms(view, instance, *m_buffers.scene().meshes()[instance.mesh]);
}

OwnInput::OwnInput(const OwnTriangles& triangles, unsigned vertexArray) : m_triangles(triangles) {
    const auto bytes = static_cast<GLsizeiptr>(triangles.positions.size() * sizeof(Vec3f));
    glCreateBuffers(1, &m_vertices);
    glNamedBufferStorage(m_vertices, std::max<GLsizeiptr>(1, 2 * bytes), nullptr, GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferSubData(m_vertices, 0, bytes, triangles.positions.data());
    glNamedBufferSubData(m_vertices, bytes, bytes, triangles.normals.data());
    glCreateBuffers(1, &m_numbers);
    glNamedBufferStorage(m_numbers,
                         std::max<GLsizeiptr>(4, static_cast<GLsizeiptr>(triangles.triangles.size() * sizeof(uint32_t))),
                         triangles.triangles.empty() ? nullptr : triangles.triangles.data(), 0);
    glBindVertexArray(vertexArray);
    glVertexArrayVertexBuffer(vertexArray, kPosition, m_vertices, 0, sizeof(Vec3f));
    glVertexArrayVertexBuffer(vertexArray, kNormal, m_vertices, bytes, sizeof(Vec3f));
}

OwnInput::~OwnInput() {
    glDeleteBuffers(1, &m_vertices);
    glDeleteBuffers(1, &m_numbers);
}

void OwnInput::draw(const Scene& scene, const View& view, const std::function<void(const OwnTriangles::Run&)>& perRun) const {
    FacingState facing(m_triangles.facing);
    for (const OwnTriangles::Run& run : m_triangles.runs) {
        if (!view.section()) facing.setFor(scene, run.instance);
        const Instance& instance = scene.instances()[run.instance];
        setInstanceUniforms(view, instance, *scene.meshes()[instance.mesh]);
        perRun(run);
        glDrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * run.first), static_cast<GLsizei>(3 * run.count));
    }
}

}  // namespace cullscope
