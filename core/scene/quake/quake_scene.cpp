#include "core/scene/quake/quake_scene.h"

#include <cmath>
#include <unordered_map>

#include "core/base/error.h"
#include "core/mesh/file_format.h"
#include "core/mesh/mesh_assembler.h"
#include "core/mesh/numbers_in_text.h"
#include "core/scene/camera_path.h"
#include "core/scene/quake/bezier_patch.h"
#include "core/scene/quake/level.h"

namespace cullscope {
namespace quake {
namespace {

/// Of a player's eye above its origin, which the game's renderer takes (DEFAULT_VIEWHEIGHT of bg_public.h).
constexpr double kEyeHeight = 26.0;

class SceneBuilder {
public:
    SceneBuilder(const Level& level, MeshAssembler& assembler) : m_level(level), m_assembler(assembler) {}

    /// Every surface of every model that stands somewhere becomes a mesh; so do the instances, in the order of the models.
    void addModels() {
        std::vector<const Entity*> owners;
        for (size_t model = 0; model < m_level.models.size(); ++model) {
            owners.clear();
            for (const Entity& entity : m_level.entities)
                if (model > 0 && entity.model() == uint32_t(model)) owners.push_back(&entity);
            const Model& surfaces = m_level.models[model];
            if (model > 0 && owners.empty()) {
                m_withoutEntity += surfaces.surfaceCount;
                continue;
            }
            for (uint32_t i = 0; i < surfaces.surfaceCount; ++i) {
                const std::optional<uint32_t> mesh = addSurface(surfaces.firstSurface + i);
                if (!mesh) continue;
                if (model == 0) {
                    m_objectOf.emplace(surfaces.firstSurface + i, uint32_t(m_instances.size()));
                    m_instances.push_back({*mesh, Mat4(1.0), nameOf(surfaces.firstSurface + i)});
                }
                for (const Entity* entity : owners) place(*mesh, *entity, surfaces.firstSurface + i);
            }
        }
    }

    ScenePointer finish(std::string name) {
        std::vector<MeshPointer> meshes;
        for (LoadedObject& object : m_assembler.finish()) meshes.push_back(std::move(object.mesh));
        remark(CULLSCOPE_TR("Surfaces left out that the game does not draw, or draws as sky: %1."), m_notDrawn);
        remark(CULLSCOPE_TR("Billboards left out, which have no place of their own: %1."), m_billboards);
        remark(CULLSCOPE_TR("Surfaces left out of models that no entity places: %1."), m_withoutEntity);
        SceneRemarks remarks;
        remarks.up = UpAxis::Z;
        remarks.visibility = visibility();
        if (std::optional<Camera> camera = playersCamera()) {
            const Scene bounds("", meshes, m_instances);
            fitDepthRange(*camera, bounds);
            remarks.camera = camera;
        }
        return std::make_shared<const Scene>(std::move(name), std::move(meshes), std::move(m_instances), nullptr,
                                             std::move(remarks));
    }

private:
    void remark(std::string_view sentence, size_t count) {
        if (count > 0) m_assembler.report.remarks.push_back({std::string(sentence), {std::to_string(count)}});
    }

    [[nodiscard]] std::string nameOf(uint32_t surface) const {
        return m_level.shaders[m_level.surfaces[surface].shader].name + " #" + std::to_string(surface);
    }

    /// The number of its mesh; none where it is left out or has no usable triangle.
    std::optional<uint32_t> addSurface(uint32_t number) {
        const Surface& surface = m_level.surfaces[number];
        if (!m_level.shaders[surface.shader].isDrawn()) {
            ++m_notDrawn;
            return std::nullopt;
        }
        if (surface.kind == Surface::Kind::Billboard) {
            ++m_billboards;
            return std::nullopt;
        }
        RawMesh mesh = surface.kind == Surface::Kind::Patch ? patch(surface) : triangles(surface);
        mesh.name = nameOf(number);
        // The level's own origin for all: so surfaces that share corners share them in pictures too, without cracks between them.
        mesh.origin = Vec3(0.0);
        const double share = 1.0 / double(m_level.surfaces.size());
        if (!m_assembler.add(std::move(mesh), share * number, share * (number + 1))) return std::nullopt;
        return m_meshes++;
    }

    RawMesh triangles(const Surface& surface) {
        RawMesh mesh;
        const auto vertices = std::span(m_level.vertices).subspan(surface.firstVertex, surface.vertexCount);
        m_assembler.requireMemory(vertices.size() * 2 * sizeof(Vertex) + surface.cornerCount * 2 * sizeof(uint32_t));
        for (const Vertex& vertex : vertices) {
            mesh.narrow.push_back(vertex.position);
            mesh.normals.push_back(vertex.normal);
        }
        const auto corners = std::span(m_level.corners).subspan(surface.firstCorner, surface.cornerCount);
        addTriangles(mesh, corners, [&](uint32_t corner) { return corner < vertices.size() ? corner : kNoVertex; });
        return mesh;
    }

    RawMesh patch(const Surface& surface) {
        RawMesh mesh;
        constexpr uint64_t kBytesOfPatch = kPatchChords * kPatchChords * (sizeof(Vec3f) + 6 * sizeof(uint32_t));
        m_assembler.requireMemory(surface.vertexCount * (sizeof(Vec3f) + kBytesOfPatch));
        std::vector<Vec3f> control;
        for (const Vertex& vertex : std::span(m_level.vertices).subspan(surface.firstVertex, surface.vertexCount))
            control.push_back(vertex.position);
        PatchSurface cut = tessellatePatch(control, surface.patchWidth, surface.patchHeight);
        mesh.narrow = std::move(cut.positions);
        addTriangles(mesh, cut.triangles, [](uint32_t corner) { return corner; });
        return mesh;
    }

    /// The game takes triangles that are clockwise for front faces; here they are counter-clockwise.
    template <typename VertexOf>
    void addTriangles(RawMesh& mesh, std::span<const uint32_t> corners, VertexOf&& vertexOf) {
        mesh.triangles.reserve(corners.size());
        for (size_t i = 0; i + 2 < corners.size(); i += 3)
            for (const size_t corner : {i, i + 2, i + 1}) mesh.triangles.push_back(vertexOf(corners[corner]));
        m_assembler.report.facesRead += corners.size() / 3;
    }

    void place(uint32_t mesh, const Entity& entity, uint32_t surface) {
        Mat4 worldFromMesh(1.0);
        worldFromMesh[3] = Vec4(entity.origin(), 1.0);
        std::string name =
            nameOf(surface) + " (" + std::string(entity.value("classname")) + " " + std::string(entity.value("model")) + ")";
        m_instances.push_back({mesh, worldFromMesh, std::move(name)});
    }

    [[nodiscard]] std::optional<Camera> playersCamera() const {
        for (const char* kind : {"info_player_deathmatch", "info_player_start", "team_CTF_redspawn"})
            for (const Entity& entity : m_level.entities) {
                const Vec3 origin = entity.origin();
                if (entity.value("classname") != kind || glm::length(origin) > kLargestCoordinate) continue;
                double degrees = 0.0;
                if (!parseReal(entity.value("angle"), degrees) || !std::isfinite(degrees)) degrees = 0.0;
                const double angle = Angle::fromDegrees(degrees).radians();
                Camera camera;
                camera.eye = origin + Vec3(0.0, 0.0, kEyeHeight);
                camera.target = camera.eye + 100.0 * Vec3(std::cos(angle), std::sin(angle), 0.0);
                camera.up = {0.0, 0.0, 1.0};
                if (camera.target != camera.eye) return camera;
            }
        return std::nullopt;
    }

    /// The level's potentially visible set: a region for each leaf of its tree. What moves belongs to no leaf in the file, so it
    /// may be seen from everywhere. Null where the level was compiled without visibility.
    [[nodiscard]] RegionSetsPointer visibility() const {
        if (m_level.clusters == 0) return nullptr;
        std::vector<RegionSets::Node> nodes;
        for (const Node& node : m_level.nodes)
            nodes.push_back({m_level.planes[node.plane].normal, m_level.planes[node.plane].distance, node.children});
        RegionSets sets(std::move(nodes), m_level.leaves.size(), m_instances.size());
        std::vector<std::vector<uint32_t>> leavesOf(m_level.clusters), objectsOf(m_level.clusters);
        for (uint32_t i = 0; i < m_level.leaves.size(); ++i) {
            const Leaf& leaf = m_level.leaves[i];
            if (leaf.cluster < 0) continue;
            leavesOf[size_t(leaf.cluster)].push_back(i);
            for (const uint32_t surface : m_level.surfacesOf(leaf))
                if (const auto object = m_objectOf.find(surface); object != m_objectOf.end())
                    objectsOf[size_t(leaf.cluster)].push_back(object->second);
        }
        std::vector<uint8_t> visible;
        for (uint32_t from = 0; from < m_level.clusters; ++from) {
            visible.assign(m_instances.size(), 1);
            for (const auto& [surface, object] : m_objectOf) visible[object] = 0;
            for (uint32_t to = 0; to < m_level.clusters; ++to)
                if (m_level.mayBeSeen(int32_t(from), int32_t(to)))
                    for (const uint32_t object : objectsOf[to]) visible[object] = 1;
            for (const uint32_t leaf : leavesOf[from]) sets.setOf(leaf, visible);
        }
        return std::make_shared<const RegionSets>(std::move(sets));
    }

    const Level& m_level;
    MeshAssembler& m_assembler;
    uint32_t m_meshes = 0;
    std::unordered_map<uint32_t, uint32_t> m_objectOf;  ///< by surface of the level itself: its instance
    std::vector<Instance> m_instances;
    size_t m_notDrawn = 0, m_billboards = 0, m_withoutEntity = 0;
};

}  // namespace
}  // namespace quake

bool isQuakeFile(const std::filesystem::path& path) { return extensionOf(path) == kQuakeExtension; }

FileScene readQuakeFile(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress) {
    constexpr double kReadingShare = 0.3;
    ByteSource source(path, progress.part(0.0, kReadingShare), false, options.memoryLimitBytes);
    MeshAssembler assembler(source.name(), options, progress.part(kReadingShare, 1.0));
    const quake::Level level = quake::readLevel(source, [&](uint64_t bytes) { assembler.requireMemory(bytes); });
    quake::SceneBuilder builder(level, assembler);
    builder.addModels();
    ScenePointer scene = builder.finish(path.filename().string());
    return {std::move(scene), std::move(assembler.report)};
}

}  // namespace cullscope
