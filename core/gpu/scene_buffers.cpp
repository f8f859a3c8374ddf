#include "core/gpu/scene_buffers.h"

#include <epoxy/gl.h>

#include <cassert>

#include "core/base/error.h"
#include "core/gpu/context.h"
#include "core/mesh/vertex_cache.h"

namespace cullscope {
namespace {

constexpr size_t kMostVerticesOf16Bits = size_t{1} << 16;

void forgetErrors() {
    while (glGetError() != GL_NO_ERROR) {
    }
}

unsigned newBuffer(const void* data, size_t bytes) {
    unsigned buffer = 0;
    glCreateBuffers(1, &buffer);
    glNamedBufferStorage(buffer, static_cast<GLsizeiptr>(bytes), data, 0);
    return buffer;
}

/// A buffer for a strategy's order of triangles. Throws Error(OpenGl) where memory runs out.
unsigned newOrderBuffer(const void* data, size_t bytes) {
    forgetErrors();
    const unsigned buffer = newBuffer(data, bytes);
    if (glGetError() != GL_OUT_OF_MEMORY) return buffer;
    glDeleteBuffers(1, &buffer);
    throwOpenGl(CULLSCOPE_TR("The graphics memory does not hold this strategy's order of the triangles (%1 bytes): use client "
                             "vertex arrays or a smaller scene."),
                {std::to_string(bytes)});
}

GpuIndices newIndices(std::span<const uint32_t> indices, size_t vertices, unsigned (*make)(const void* data, size_t bytes)) {
    if (vertices > kMostVerticesOf16Bits) return {make(indices.data(), indices.size_bytes()), nullptr, 4};
    const std::vector<uint16_t> narrow(indices.begin(), indices.end());
    return {make(narrow.data(), narrow.size() * sizeof(uint16_t)), nullptr, 2};
}

GpuIndices inMemory(std::span<const uint32_t> indices) { return {0, reinterpret_cast<const char*>(indices.data()), 4}; }

/// A mesh's triangles in the order that is fastest to draw as a whole.
std::vector<uint32_t> fastOrder(const TriangleMesh& mesh) {
    if (mesh.triangleCount() <= kOptionalAnalysisLimit) return inVertexCacheOrder(mesh.indices(), mesh.vertexCount());
    return {mesh.indices().begin(), mesh.indices().end()};
}

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
    buffers.whole = newIndices(fastOrder(mesh), mesh.vertexCount(), newBuffer);
    return buffers;
}

}  // namespace

SceneBuffers::SceneBuffers(ScenePointer scene, Upload upload)
    : m_scene(std::move(scene)), m_upload(upload), m_uploaded(std::make_shared<Uploaded>()) {
    std::vector<MeshBuffers>& meshes = m_uploaded->meshes;
    meshes.resize(m_scene->meshes().size());
    m_uploaded->own.resize(meshes.size());
    if (upload == Upload::VertexArray) {
        useClientArrays();
        return;
    }
    forgetErrors();
    for (size_t i = 0; i < meshes.size(); ++i)
        if (m_scene->meshes()[i]->triangleCount() > 0) meshes[i] = uploaded(*m_scene->meshes()[i]);
    if (glGetError() == GL_OUT_OF_MEMORY)
        throwOpenGl(
            CULLSCOPE_TR("The graphics memory does not hold this scene (%1 bytes): use client vertex arrays or a smaller scene."),
            {std::to_string(m_scene->bytes())});
}

void SceneBuffers::useClientArrays() {
    if (!requireOpenGl45().compatibilityProfile)
        throwOpenGl(
            CULLSCOPE_TR("Client vertex arrays need OpenGL's compatibility profile, which this driver does not give: use "
                         "buffer objects (vbo)."));
    for (size_t i = 0; i < m_uploaded->meshes.size(); ++i) {
        m_uploaded->clientOrders.push_back(fastOrder(*m_scene->meshes()[i]));
        m_uploaded->meshes[i].whole = inMemory(m_uploaded->clientOrders[i]);
        m_uploaded->own[i] = inMemory(m_scene->meshes()[i]->indices());
    }
}

SceneBuffers::SceneBuffers(ScenePointer scene, const SceneBuffers& sameMeshes)
    : m_scene(std::move(scene)), m_upload(sameMeshes.m_upload), m_uploaded(sameMeshes.m_uploaded) {
    assert(m_scene->meshes() == sameMeshes.m_scene->meshes());
}

void SceneBuffers::deleteBuffers(const UploadedOrder& order) {
    for (const OrderBuffers& mesh : order.meshes) {
        glDeleteBuffers(1, &mesh.indices.buffer);
        glDeleteBuffers(1, &mesh.numbers);
    }
}

SceneBuffers::OrderBuffers& SceneBuffers::Uploaded::ofOrder(const TriangleOrderPointer& order, uint32_t mesh) {
    for (UploadedOrder& known : orders)
        if (known.order.lock() == order) return known.meshes[mesh];
    std::erase_if(orders, [](const UploadedOrder& old) {
        if (old.order.expired()) deleteBuffers(old);
        return old.order.expired();
    });
    orders.push_back({order, std::vector<OrderBuffers>(order->meshes.size())});
    return orders.back().meshes[mesh];
}

GpuIndices SceneBuffers::ownOrder(uint32_t mesh) const {
    GpuIndices& own = m_uploaded->own[mesh];
    const TriangleMesh& source = *m_scene->meshes()[mesh];
    if (own.buffer == 0 && m_upload == Upload::Vbo && source.triangleCount() > 0)
        own = newIndices(source.indices(), source.vertexCount(), newOrderBuffer);
    return own;
}

GpuIndices SceneBuffers::ordered(const TriangleOrderPointer& order, uint32_t mesh) const {
    const std::span<const uint32_t> indices = order->meshes[mesh].indices;
    if (indices.empty()) return ownOrder(mesh);
    if (m_upload == Upload::VertexArray) return inMemory(indices);
    GpuIndices& ordered = m_uploaded->ofOrder(order, mesh).indices;
    if (ordered.buffer == 0) ordered = newIndices(indices, m_scene->meshes()[mesh]->vertexCount(), newOrderBuffer);
    return ordered;
}

unsigned SceneBuffers::orderNumbers(const TriangleOrderPointer& order, uint32_t mesh) const {
    const std::span<const uint32_t> numbers = order->meshes[mesh].triangles;
    if (numbers.empty()) return 0;
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    if (static_cast<GLint64>(numbers.size_bytes()) > most)
        throwOpenGl(CULLSCOPE_TR("The numbers of the triangles in this strategy's order need %1 bytes in one buffer and this "
                                 "OpenGL gives %2: choose a strategy that keeps the mesh's order, or a part of the scene."),
                    {std::to_string(numbers.size_bytes()), std::to_string(most)});
    unsigned& buffer = m_uploaded->ofOrder(order, mesh).numbers;
    if (buffer == 0) buffer = newOrderBuffer(numbers.data(), numbers.size_bytes());
    return buffer;
}

SceneBuffers::Uploaded::~Uploaded() {
    for (const MeshBuffers& mesh : meshes) {
        glDeleteBuffers(1, &mesh.vertices);
        glDeleteBuffers(1, &mesh.whole.buffer);
    }
    for (const GpuIndices& indices : own) glDeleteBuffers(1, &indices.buffer);
    for (const UploadedOrder& order : orders) deleteBuffers(order);
}

}  // namespace cullscope
