#pragma once

#include <memory>
#include <vector>

#include "core/frame/draw_list.h"
#include "core/scene/scene.h"

namespace cullscope {

/// How vertices are passed to OpenGL.
enum class Upload {
    Vbo,         ///< buffer objects, uploaded once
    VertexArray  ///< client memory, sent with every draw (the papers' "vertex array"); needs a compatibility profile
};

/// The indices of a mesh's triangles in OpenGL's format: in a buffer with 16 bits each where the mesh has at most 65,536
/// vertices; in client memory in the mesh's own format.
struct GpuIndices {
    unsigned buffer = 0;           ///< 0 with Upload::VertexArray
    const char* client = nullptr;  ///< address in client memory, with Upload::VertexArray
    unsigned bytes = 4;            ///< of one index: 2 or 4
};

/// A scene's meshes in OpenGL's format. Buffer objects are shared within a share group. A mesh that is drawn whole is drawn in
/// vertex-cache order (meshes of up to kOptionalAnalysisLimit triangles): the picture is the same, and each vertex is shaded
/// about once, where the file's order may shade it six times.
class SceneBuffers {
public:
    struct MeshBuffers {
        unsigned vertices = 0;     ///< positions, then normals; 0 with Upload::VertexArray
        size_t normalsOffset = 0;  ///< bytes
        GpuIndices whole;          ///< all triangles, in the order that is fastest to draw
    };

    /// Uploads every mesh once. Throws Error(OpenGl) where memory runs out, or where client arrays are requested in a core
    /// profile.
    SceneBuffers(ScenePointer scene, Upload upload);
    /// The buffers for another scene with the same meshes in the same order (as withoutInstances makes it): shared with
    /// `sameMeshes`, nothing is uploaded. The last owner deletes the buffers, so every owner must be destroyed with a context of
    /// the share group current.
    SceneBuffers(ScenePointer scene, const SceneBuffers& sameMeshes);
    SceneBuffers(const SceneBuffers&) = delete;
    SceneBuffers& operator=(const SceneBuffers&) = delete;

    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    [[nodiscard]] const ScenePointer& scenePointer() const { return m_scene; }
    [[nodiscard]] Upload upload() const { return m_upload; }
    [[nodiscard]] const MeshBuffers& mesh(size_t index) const { return m_uploaded->meshes[index]; }

    /// A mesh's triangles in its own order. Uploaded at the first call. Throws Error(OpenGl) where memory runs out.
    [[nodiscard]] GpuIndices ownOrder(uint32_t mesh) const;
    /// A mesh's triangles in a strategy's order; in its own order where `order` has none for it. Uploaded at the first call, and
    /// kept as long as the order has another owner. Throws Error(OpenGl) where memory runs out.
    [[nodiscard]] GpuIndices ordered(const TriangleOrderPointer& order, uint32_t mesh) const;
    /// The triangles' numbers in the mesh, in a strategy's order, as a buffer; 0 where `order` has none for it. Uploaded and kept
    /// as above.
    [[nodiscard]] unsigned orderNumbers(const TriangleOrderPointer& order, uint32_t mesh) const;

private:
    struct OrderBuffers {
        GpuIndices indices;
        unsigned numbers = 0;
    };
    struct UploadedOrder {
        std::weak_ptr<const TriangleOrder> order;
        std::vector<OrderBuffers> meshes;
    };
    struct Uploaded {
        std::vector<MeshBuffers> meshes;
        std::vector<std::vector<uint32_t>> clientOrders;  ///< by mesh, with Upload::VertexArray: what `whole` points to
        std::vector<GpuIndices> own;                      ///< by mesh; buffer 0 until ownOrder is first called for it
        std::vector<UploadedOrder> orders;

        ~Uploaded();
        OrderBuffers& ofOrder(const TriangleOrderPointer& order, uint32_t mesh);
    };

    void useClientArrays();
    static void deleteBuffers(const UploadedOrder& order);

    ScenePointer m_scene;
    Upload m_upload;
    std::shared_ptr<Uploaded> m_uploaded;
};

}  // namespace cullscope
