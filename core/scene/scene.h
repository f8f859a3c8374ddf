#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/mesh/load.h"
#include "core/mesh/triangle_mesh.h"

namespace cullscope {

/// One object of a scene: a mesh put somewhere by an affine transform.
struct Instance {
    uint32_t mesh = 0;        ///< index into Scene::meshes()
    Mat4 worldFromMesh{1.0};  ///< applied to the mesh's double coordinates (origin + position)
    std::string name;
};

/// Meshes and their instances, in double. Immutable after it is made.
/// Triangles are numbered through: instance i owns the numbers firstTriangle(i) … firstTriangle(i) + its mesh's count − 1.
class Scene {
public:
    /// `sameSurface`: a scene of the very same triangles, divided otherwise. Its bounds are taken over, so that cameras which are
    /// placed by them stand alike.
    Scene(std::string name, std::vector<MeshPointer> meshes, std::vector<Instance> instances, const Scene* sameSurface = nullptr);

    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] const std::vector<MeshPointer>& meshes() const { return m_meshes; }
    [[nodiscard]] const std::vector<Instance>& instances() const { return m_instances; }
    [[nodiscard]] const TriangleMesh& meshOf(size_t instance) const { return *m_meshes[m_instances[instance].mesh]; }

    [[nodiscard]] uint64_t triangleCount() const { return m_firstTriangle.back(); }
    [[nodiscard]] uint64_t firstTriangle(size_t instance) const { return m_firstTriangle[instance]; }
    /// The instance that owns a triangle number.
    [[nodiscard]] size_t instanceOf(uint64_t triangle) const;

    /// How far the floats of a picture may misplace an instance's vertices beyond what conservativeMargin (geometry/frustum.h)
    /// holds, which goes by the distance from the eye: a mesh that lies away from the zero of its float coordinates is rounded by
    /// its distance from there. Scene units; 0 for a mesh around its zero.
    [[nodiscard]] double pictureRounding(const Instance& instance) const;

    /// World bounds of one instance, which hold every vertex, also where a picture's floats put it (pictureRounding), and of
    /// everything.
    [[nodiscard]] const Box3& instanceBox(size_t instance) const { return m_instanceBoxes[instance]; }
    [[nodiscard]] const Sphere& instanceSphere(size_t instance) const { return m_instanceSpheres[instance]; }
    [[nodiscard]] const Box3& bounds() const { return m_bounds; }
    /// A sphere around the scene: the camera paths' R.
    [[nodiscard]] const Sphere& boundingSphere() const { return m_sphere; }

    /// By mesh: whether it has triangles and an instance.
    [[nodiscard]] std::vector<bool> shownMeshes() const;

    /// Hash of everything that is drawn (positions, indices, transforms): lower-case hexadecimal SHA-256. Computed when asked
    /// for.
    [[nodiscard]] std::string sha256() const;
    [[nodiscard]] size_t bytes() const;

    /// Whether back faces can never be seen from outside any mesh: what `facing = auto` asks. False, and not computed, for a
    /// scene whose meshes hold more than kOptionalAnalysisLimit triangles. Meshes without an instance do not count.
    [[nodiscard]] bool frontFacesSuffice() const;

private:
    std::string m_name;
    std::vector<MeshPointer> m_meshes;
    std::vector<Instance> m_instances;
    std::vector<uint64_t> m_firstTriangle;  ///< one more than instances: prefix sums
    std::vector<Box3> m_instanceBoxes;
    std::vector<Sphere> m_instanceSpheres;
    Box3 m_bounds;
    Sphere m_sphere;
};

using ScenePointer = std::shared_ptr<const Scene>;

}  // namespace cullscope
