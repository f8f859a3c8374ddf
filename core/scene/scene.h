#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/mesh/load.h"
#include "core/mesh/triangle_mesh.h"
#include "core/scene/camera.h"
#include "core/scene/components.h"
#include "core/scene/region_sets.h"

namespace cullscope {

/// One object of a scene: a mesh placed by an affine transform.
struct Instance {
    uint32_t mesh = 0;        ///< index into Scene::meshes()
    Mat4 worldFromMesh{1.0};  ///< applied to the mesh's double coordinates (origin + position)
    std::string name;
    uint32_t group = kNoGroup;  ///< of SceneRemarks::components
};

/// A plane that a scene names, such as one that a lecture divides its space by.
struct NamedPlane {
    std::string name;
    Vec3 normal{0.0, 0.0, 1.0};  ///< not 0; of any length
    double offset = 0.0;         ///< the plane is { p : normal·p + offset = 0 }, its front where this is above 0
};

/// What a scene says besides its surfaces.
struct SceneRemarks {
    std::vector<NamedPlane> planes{};
    std::optional<Camera> camera{};     ///< from where it is to be seen
    std::vector<Camera> cameras{};      ///< all from which it is to be judged, with one lens; empty for most scenes
    std::optional<UpAxis> up{};         ///< where its format says so, or its generator
    std::optional<UpAxis> guessedUp{};  ///< of a file whose format has no word for it (guessedUpAxis)
    ComponentsPointer components{};     ///< of which primitives its meshes consist; null where none are known
    RegionSetsPointer visibility{};     ///< which objects may be seen from where, as its file says; null: it does not
};

/// What is up in a file that does not say it: z where the scene lies flat along z, at most half as long along it as along x and
/// along y, but not without extent, as a drawing is; else y.
[[nodiscard]] UpAxis guessedUpAxis(const Box3& bounds);

/// Meshes and their instances, in double. Immutable. Triangles have consecutive numbers: instance i owns the numbers
/// firstTriangle(i) … firstTriangle(i) + its mesh's count − 1.
class Scene {
public:
    /// `sameSurface`: a scene of the same triangles, divided into other objects. Its bounds are used, so that cameras placed by
    /// the bounds are the same.
    Scene(std::string name, std::vector<MeshPointer> meshes, std::vector<Instance> instances, const Scene* sameSurface = nullptr,
          SceneRemarks remarks = {});

    [[nodiscard]] const std::string& name() const { return m_name; }
    [[nodiscard]] const std::vector<MeshPointer>& meshes() const { return m_meshes; }
    [[nodiscard]] const std::vector<Instance>& instances() const { return m_instances; }
    [[nodiscard]] const TriangleMesh& meshOf(size_t instance) const { return *m_meshes[m_instances[instance].mesh]; }

    [[nodiscard]] uint64_t triangleCount() const { return m_firstTriangle.back(); }
    [[nodiscard]] uint64_t firstTriangle(size_t instance) const { return m_firstTriangle[instance]; }
    /// The instance that owns a triangle number.
    [[nodiscard]] size_t instanceOf(uint64_t triangle) const;

    /// An upper bound on the displacement of an instance's vertices by the float rounding of a picture, beyond what
    /// conservativeMargin (geometry/frustum.h) covers. That margin grows with the distance from the eye only, but a mesh far from
    /// the origin of its float coordinates is rounded in proportion to that distance. Scene units; 0 for a mesh around its
    /// origin.
    [[nodiscard]] double pictureRounding(const Instance& instance) const;

    /// World bounds. Those of one instance contain every vertex, also as displaced by a picture's float rounding
    /// (pictureRounding); those of the scene contain the vertices without that displacement.
    [[nodiscard]] const Box3& instanceBox(size_t instance) const { return m_instanceBoxes[instance]; }
    [[nodiscard]] const Sphere& instanceSphere(size_t instance) const { return m_instanceSpheres[instance]; }
    [[nodiscard]] const Box3& bounds() const { return m_bounds; }
    /// A sphere around the scene; its radius is the R of the camera paths.
    [[nodiscard]] const Sphere& boundingSphere() const { return m_sphere; }

    /// Planes that the scene names, in its order, and the camera that it gives; most scenes have none.
    [[nodiscard]] const SceneRemarks& remarks() const { return m_remarks; }
    [[nodiscard]] const std::vector<NamedPlane>& planes() const { return m_remarks.planes; }
    /// What the scene says is up, or else what is guessed; y without either.
    [[nodiscard]] UpAxis upAxis() const { return m_remarks.up.value_or(m_remarks.guessedUp.value_or(UpAxis::Y)); }

    /// The primitives of which an instance's mesh consists, in the mesh's coordinates; empty where none are known.
    [[nodiscard]] std::span<const MeshPart> partsOf(size_t instance) const;
    /// How many parts of each kind the instances have together, by kindName. Parts that belong to no mesh count once.
    [[nodiscard]] std::map<std::string, uint64_t> partCounts() const;

    /// By mesh: whether it has triangles and at least one instance.
    [[nodiscard]] std::vector<bool> shownMeshes() const;

    /// Hash of everything that is drawn (positions, indices, transforms): lower-case hexadecimal SHA-256. Computed at every call.
    [[nodiscard]] std::string sha256() const;
    [[nodiscard]] size_t bytes() const;

    /// Whether no back face of an object can be seen from outside it, but where a pocket is inside out (hasNoPockets): its mesh
    /// is closed, consistently oriented and outward. The criterion of `facing = auto`. False, and not computed, in a scene whose
    /// meshes have more than kOptionalAnalysisLimit triangles together; meshes without an instance do not count.
    [[nodiscard]] bool frontFacesSuffice(size_t instance) const {
        return m_topologyAsked && meshOf(instance).topology().frontFacesSuffice();
    }
    /// The same of all objects that have triangles.
    [[nodiscard]] bool frontFacesSuffice() const;
    /// Whether it is proven that no object has pockets that are inside out (TriangleMesh::pockets): what frontFacesSuffice does
    /// not ask. Throws Error(Interrupted) on a stop request.
    [[nodiscard]] bool hasNoPockets(const Progress& progress) const;

private:
    std::string m_name;
    std::vector<MeshPointer> m_meshes;
    std::vector<Instance> m_instances;
    std::vector<uint64_t> m_firstTriangle;  ///< one element more than instances: prefix sums
    std::vector<Box3> m_instanceBoxes;
    std::vector<Sphere> m_instanceSpheres;
    Box3 m_bounds;
    Sphere m_sphere;
    SceneRemarks m_remarks;
    bool m_topologyAsked = true;  ///< false above kOptionalAnalysisLimit
};

using ScenePointer = std::shared_ptr<const Scene>;

}  // namespace cullscope
