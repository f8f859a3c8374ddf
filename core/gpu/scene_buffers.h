#pragma once

#include <memory>
#include <vector>

#include "core/frame/draw_list.h"
#include "core/scene/scene.h"

namespace cullscope {

/// How vertices reach OpenGL.
enum class Upload {
    Vbo,         ///< buffer objects, uploaded once
    VertexArray  ///< client memory, sent with every draw (the papers' "vertex array"); needs a compatibility profile
};

/// The indices of a mesh's triangles, as OpenGL takes them: in a buffer 16 bits each where the mesh has no more than 65,536
/// vertices; in client memory as the mesh has them.
struct GpuIndices {
    unsigned buffer = 0;           ///< 0 with Upload::VertexArray
    const char* client = nullptr;  ///< where they lie in memory, with Upload::VertexArray
    unsigned bytes = 4;            ///< each: 2 or 4
};

/// A scene's meshes as OpenGL takes them. Buffer objects are shared within a share group.
/// A mesh that is drawn whole is drawn in vertex-cache order (meshes of up to kOptionalAnalysisLimit triangles): the picture is
/// the same, and each vertex is worked out once where the file's order may have it worked out six times.
class SceneBuffers {
public:
    struct MeshBuffers {
        unsigned vertices = 0;     ///< positions, then normals; 0 with Upload::VertexArray
        size_t normalsOffset = 0;  ///< bytes
        GpuIndices whole;          ///< all triangles, in whichever order OpenGL draws them fastest
    };

    /// Uploads every mesh once. Throws Error(OpenGl) where memory runs out or client arrays are asked of a core profile.
    SceneBuffers(ScenePointer scene, Upload upload);
    /// A scene of the very same meshes, in the same order (as withoutInstances makes it), on the buffers of another: nothing is
    /// uploaded. The last one to go deletes the buffers, so all of them go with a context of the share group current.
    SceneBuffers(ScenePointer scene, const SceneBuffers& sameMeshes);
    SceneBuffers(const SceneBuffers&) = delete;
    SceneBuffers& operator=(const SceneBuffers&) = delete;

    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    [[nodiscard]] const ScenePointer& scenePointer() const { return m_scene; }
    [[nodiscard]] Upload upload() const { return m_upload; }
    [[nodiscard]] const MeshBuffers& mesh(size_t index) const { return m_uploaded->meshes[index]; }

    /// A mesh's triangles in its own order. Uploaded when first asked for. Throws Error(OpenGl) where memory runs out.
    [[nodiscard]] GpuIndices ownOrder(uint32_t mesh) const;
    /// A mesh's triangles in a strategy's order; in its own where the order has none for it. Uploaded when first asked for, and
    /// kept as long as somebody else holds the order. Throws Error(OpenGl) where memory runs out.
    [[nodiscard]] GpuIndices ordered(const TriangleOrderPointer& order, uint32_t mesh) const;
    /// The mesh's numbers of the triangles in a strategy's order, as a buffer; 0 where the order has none for it. The same.
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
        std::vector<GpuIndices> own;                      ///< by mesh; as yet without what nobody has asked for
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
