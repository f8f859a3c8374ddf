#pragma once

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
    ~SceneBuffers();
    SceneBuffers(const SceneBuffers&) = delete;
    SceneBuffers& operator=(const SceneBuffers&) = delete;

    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    [[nodiscard]] const ScenePointer& scenePointer() const { return m_scene; }
    [[nodiscard]] Upload upload() const { return m_upload; }
    [[nodiscard]] const MeshBuffers& mesh(size_t index) const { return m_meshes[index]; }

private:
    ScenePointer m_scene;
    Upload m_upload;
    std::vector<MeshBuffers> m_meshes;
};

}  // namespace cullscope
