#include "core/gpu/scene_buffers.h"

#include <epoxy/gl.h>

#include <cassert>

#include "core/base/error.h"
#include "core/gpu/context.h"

namespace cullscope {
namespace {

SceneBuffers::MeshBuffers uploaded(const TriangleMesh& mesh) {
    SceneBuffers::MeshBuffers buffers;
    const std::span positions = mesh.positions();
    const std::span normals = mesh.normals();
    buffers.normalsOffset = positions.size_bytes();
    glCreateBuffers(1, &buffers.vertices);
    glNamedBufferStorage(buffers.vertices, static_cast<GLsizeiptr>(positions.size_bytes() + normals.size_bytes()), nullptr,
                         GL_DYNAMIC_STORAGE_BIT);
    glNamedBufferSubData(buffers.vertices, 0, static_cast<GLsizeiptr>(positions.size_bytes()), positions.data());
    glNamedBufferSubData(buffers.vertices, static_cast<GLintptr>(buffers.normalsOffset),
                         static_cast<GLsizeiptr>(normals.size_bytes()), normals.data());
    glCreateBuffers(1, &buffers.indices);
    glNamedBufferStorage(buffers.indices, static_cast<GLsizeiptr>(mesh.indices().size_bytes()), mesh.indices().data(), 0);
    return buffers;
}

unsigned uploaded(std::span<const uint32_t> numbers) {
    while (glGetError() != GL_NO_ERROR) {
    }
    unsigned buffer = 0;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(numbers.size_bytes()), numbers.data(), 0);
    if (glGetError() != GL_OUT_OF_MEMORY) return buffer;
    glDeleteBuffers(1, &buffer);
    throwOpenGl(CULLSCOPE_TR("The graphics memory does not hold this strategy's order of the triangles (%1 bytes): use client "
                             "vertex arrays or a smaller scene."),
                {std::to_string(numbers.size_bytes())});
}

void deleteBuffers(const std::vector<SceneBuffers::OrderBuffers>& meshes) {
    for (const SceneBuffers::OrderBuffers& mesh : meshes) {
        glDeleteBuffers(1, &mesh.indices);
        glDeleteBuffers(1, &mesh.triangles);
    }
}

}  // namespace

SceneBuffers::SceneBuffers(ScenePointer scene, Upload upload)
    : m_scene(std::move(scene)), m_upload(upload), m_uploaded(std::make_shared<Uploaded>()) {
    std::vector<MeshBuffers>& meshes = m_uploaded->meshes;
    meshes.resize(m_scene->meshes().size());
    if (upload == Upload::VertexArray) {
        if (!requireOpenGl45().compatibilityProfile)
            throwOpenGl(
                CULLSCOPE_TR("Client vertex arrays need OpenGL's compatibility profile, which this driver does not give: use "
                             "buffer objects (vbo)."));
        return;
    }
    while (glGetError() != GL_NO_ERROR) {
    }
    for (size_t i = 0; i < meshes.size(); ++i)
        if (m_scene->meshes()[i]->triangleCount() > 0) meshes[i] = uploaded(*m_scene->meshes()[i]);
    if (glGetError() == GL_OUT_OF_MEMORY)
        throwOpenGl(
            CULLSCOPE_TR("The graphics memory does not hold this scene (%1 bytes): use client vertex arrays or a smaller scene."),
            {std::to_string(m_scene->bytes())});
}

SceneBuffers::SceneBuffers(ScenePointer scene, const SceneBuffers& sameMeshes)
    : m_scene(std::move(scene)), m_upload(sameMeshes.m_upload), m_uploaded(sameMeshes.m_uploaded) {
    assert(m_scene->meshes() == sameMeshes.m_scene->meshes());
}

SceneBuffers::OrderBuffers& SceneBuffers::Uploaded::ofOrder(const TriangleOrderPointer& order, uint32_t mesh) {
    for (UploadedOrder& known : orders)
        if (known.order.lock() == order) return known.meshes[mesh];
    std::erase_if(orders, [](const UploadedOrder& old) {
        if (old.order.expired()) deleteBuffers(old.meshes);
        return old.order.expired();
    });
    return orders.emplace_back(order, std::vector<OrderBuffers>(order->meshes.size())).meshes[mesh];
}

SceneBuffers::OrderBuffers SceneBuffers::order(const TriangleOrderPointer& order, uint32_t mesh) const {
    OrderBuffers& buffers = m_uploaded->ofOrder(order, mesh);
    const std::span<const uint32_t> indices = order->meshes[mesh].indices;
    if (buffers.indices == 0 && m_upload == Upload::Vbo && !indices.empty()) buffers.indices = uploaded(indices);
    return buffers;
}

SceneBuffers::OrderBuffers SceneBuffers::numberedOrder(const TriangleOrderPointer& order, uint32_t mesh) const {
    static_cast<void>(this->order(order, mesh));
    OrderBuffers& buffers = m_uploaded->ofOrder(order, mesh);
    const std::span<const uint32_t> triangles = order->meshes[mesh].triangles;
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    if (static_cast<GLint64>(triangles.size_bytes()) > most)
        throwOpenGl(CULLSCOPE_TR("The numbers of the triangles in this strategy's order need %1 bytes in one buffer and this "
                                 "OpenGL gives %2: choose a strategy that keeps the mesh's order, or a part of the scene."),
                    {std::to_string(triangles.size_bytes()), std::to_string(most)});
    if (buffers.triangles == 0 && !triangles.empty()) buffers.triangles = uploaded(triangles);
    return buffers;
}

SceneBuffers::Uploaded::~Uploaded() {
    for (const MeshBuffers& mesh : meshes) {
        glDeleteBuffers(1, &mesh.vertices);
        glDeleteBuffers(1, &mesh.indices);
    }
    for (const UploadedOrder& order : orders) deleteBuffers(order.meshes);
}

}  // namespace cullscope
