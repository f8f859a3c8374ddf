#pragma once

#include <memory>
#include <vector>

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

private:
    struct Uploaded {
        std::vector<MeshBuffers> meshes;

        ~Uploaded();
    };

    ScenePointer m_scene;
    Upload m_upload;
    std::shared_ptr<Uploaded> m_uploaded;
};

}  // namespace cullscope
