#pragma once

#include <memory>
#include <vector>

#include "core/scene/draw_list.h"
#include "core/scene/scene.h"

namespace cullscope {

/// How vertices reach OpenGL.
enum class Upload {
    Vbo,         ///< buffer objects, uploaded once
    VertexArray  ///< client memory, sent with every draw (the papers' "vertex array"); needs a compatibility profile
};

/// A scene's meshes as OpenGL takes them. Buffer objects are shared within a share group.
class SceneBuffers {
public:
    struct MeshBuffers {
        unsigned vertices = 0;  ///< positions, then normals; 0 with Upload::VertexArray
        unsigned indices = 0;
        size_t normalsOffset = 0;  ///< bytes
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

    /// A mesh's triangles in a strategy's order.
    struct OrderBuffers {
        unsigned indices = 0;    ///< 0 with Upload::VertexArray, and for a mesh in its own order
        unsigned triangles = 0;  ///< the mesh's numbers; 0 until somebody asks for them
    };
    /// Uploaded when it is first asked for, and kept as long as somebody else holds the order. Throws Error(OpenGl) where memory
    /// runs out.
    [[nodiscard]] OrderBuffers order(const TriangleOrderPointer& order, uint32_t mesh) const;
    /// The same with `triangles`.
    [[nodiscard]] OrderBuffers numberedOrder(const TriangleOrderPointer& order, uint32_t mesh) const;

private:
    struct UploadedOrder {
        std::weak_ptr<const TriangleOrder> order;
        std::vector<OrderBuffers> meshes;
    };
    struct Uploaded {
        std::vector<MeshBuffers> meshes;
        std::vector<UploadedOrder> orders;

        ~Uploaded();
        OrderBuffers& ofOrder(const TriangleOrderPointer& order, uint32_t mesh);
    };

    ScenePointer m_scene;
    Upload m_upload;
    std::shared_ptr<Uploaded> m_uploaded;
};

}  // namespace cullscope
