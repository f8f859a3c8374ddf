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

SceneBuffers::Uploaded::~Uploaded() {
    for (const MeshBuffers& mesh : meshes) {
        glDeleteBuffers(1, &mesh.vertices);
        glDeleteBuffers(1, &mesh.indices);
    }
}

}  // namespace cullscope
