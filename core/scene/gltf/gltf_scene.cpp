#include "core/scene/gltf/gltf_scene.h"

#include <algorithm>
#include <new>
#include <unordered_map>

#include "core/base/error.h"
#include "core/mesh/file_format.h"
#include "core/mesh/mesh_assembler.h"
#include "core/scene/gltf/model_file.h"
#include "core/scene/gltf/nodes.h"
#include "core/scene/gltf/primitives.h"
#include "core/scene/gltf/tiny_gltf.h"

namespace cullscope {
namespace gltf {
namespace {

class SceneBuilder {
public:
    SceneBuilder(const tinygltf::Model& model, MeshAssembler& assembler, std::string fileName, const RequireMemory& requireMemory,
                 const Progress& progress)
        : m_model(model),
          m_assembler(assembler),
          m_fileName(std::move(fileName)),
          m_requireMemory(requireMemory),
          m_progress(progress),
          m_accessors(model, m_fileName, requireMemory, progress),
          m_numbers(model.meshes.size(), kNotMade) {}

    void build() {
        placeMeshes(m_model, m_accessors, m_fileName, [&](const PlacedMesh& placed) { add(placed); });
    }

    FileScene finish(std::string name) {
        std::vector<MeshPointer> meshes;
        for (LoadedObject& object : m_assembler.finish()) meshes.push_back(std::move(object.mesh));
        m_assembler.report.nonFiniteVertices += m_leftOut.nonFiniteVertices;
        dropWhatLiesBeyond(meshes);
        remarkWhatIsNotShown();
        SceneRemarks remarks;
        remarks.up = UpAxis::Y;
        return {std::make_shared<const Scene>(std::move(name), std::move(meshes), std::move(m_instances), nullptr,
                                              std::move(remarks)),
                std::move(m_assembler.report)};
    }

private:
    static constexpr uint32_t kNotMade = 0xffffffffU, kWithoutTriangles = 0xfffffffeU;

    void add(const PlacedMesh& placed) {
        m_progress.check();
        uint32_t& number = m_numbers[size_t(placed.mesh)];
        if (number == kNotMade) number = made(placed.mesh);
        const tinygltf::Node& node = m_model.nodes[size_t(placed.node)];
        m_skinned += node.skin >= 0 ? 1 : 0;
        if (number == kWithoutTriangles) return;
        // An instance has bounds in the scene, too.
        constexpr uint64_t kBytesOfInstance = 4 * sizeof(Instance);
        if (m_instances.size() % 256 == 0) m_requireMemory((m_instances.size() + 256) * kBytesOfInstance);
        m_instances.push_back({number, placed.worldFromMesh, nameOf(node, placed)});
    }

    uint32_t made(int mesh) {
        const tinygltf::Mesh& read = m_model.meshes[size_t(mesh)];
        RawMesh raw = trianglesOf(read, m_accessors, m_fileName, m_requireMemory, m_progress, m_leftOut);
        raw.name = read.name.empty() ? "mesh " + std::to_string(mesh) : read.name;
        m_assembler.report.facesRead += raw.triangles.size() / 3;
        for (const tinygltf::Primitive& primitive : read.primitives) m_morphed += primitive.targets.empty() ? 0 : 1;
        const double share = 1.0 / double(m_model.meshes.size());
        return m_assembler.add(std::move(raw), share * m_made, share * (m_made + 1)) ? m_made++ : kWithoutTriangles;
    }

    [[nodiscard]] std::string nameOf(const tinygltf::Node& node, const PlacedMesh& placed) {
        std::string name = node.name;
        if (name.empty()) name = m_model.meshes[size_t(placed.mesh)].name;
        if (name.empty()) name = "node " + std::to_string(placed.node);
        if (const uint32_t number = ++m_names[name]; number > 1) name += " (" + std::to_string(number) + ")";
        return name;
    }

    /// A scene has no bounds with such an object.
    void dropWhatLiesBeyond(const std::vector<MeshPointer>& meshes) {
        m_beyond = std::erase_if(m_instances, [&](const Instance& instance) {
            const TriangleMesh& mesh = *meshes[instance.mesh];
            const Box3& box = mesh.localBounds();
            for (int corner = 0; corner < 8; ++corner) {
                const Vec3 place((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                                 (corner & 4) != 0 ? box.max.z : box.min.z);
                if (!usableCoordinates(Vec3(instance.worldFromMesh * Vec4(mesh.origin() + place, 1.0)))) return true;
            }
            return false;
        });
        if (m_instances.empty())
            throwInput(CULLSCOPE_TR("%1 places no surface that can be shown in its scene. Export the scene with its meshes."),
                       {m_fileName});
    }

    void remark(std::string_view sentence, size_t count) {
        if (count > 0) m_assembler.report.remarks.push_back({std::string(sentence), {std::to_string(count)}});
    }

    void remarkWhatIsNotShown() {
        remark(CULLSCOPE_TR("Points and lines left out, which have no surface: %1 primitives."), m_leftOut.pointsAndLines);
        remark(CULLSCOPE_TR("Primitives left out that have no positions: %1."), m_leftOut.withoutPositions);
        remark(CULLSCOPE_TR("Objects left out that lie beyond 1e30: %1."), m_beyond);
        remark(CULLSCOPE_TR("Skins are not applied; objects that stand as they were modelled: %1."), m_skinned);
        remark(CULLSCOPE_TR("Morph targets are not applied; primitives that have some: %1."), m_morphed);
        remark(CULLSCOPE_TR("Animations are not played: %1."), m_model.animations.size());
        remark(CULLSCOPE_TR("Scenes of the file that are not shown, because one at a time is: %1."),
               std::max<size_t>(m_model.scenes.size(), 1) - 1);
    }

    const tinygltf::Model& m_model;
    MeshAssembler& m_assembler;
    std::string m_fileName;
    const RequireMemory& m_requireMemory;
    const Progress& m_progress;
    Accessors m_accessors;
    std::vector<uint32_t> m_numbers;  ///< by mesh of the file: of the scene's mesh, kNotMade or kWithoutTriangles
    uint32_t m_made = 0;
    std::vector<Instance> m_instances;
    std::unordered_map<std::string, uint32_t> m_names;
    LeftOut m_leftOut;
    size_t m_skinned = 0, m_morphed = 0, m_beyond = 0;
};

}  // namespace
}  // namespace gltf

bool isGltfFile(const std::filesystem::path& path) {
    return std::ranges::find(kGltfExtensions, extensionOf(path)) != kGltfExtensions.end();
}

FileScene readGltf(std::string content, const std::filesystem::path& path, const LoadOptions& options, const Progress& progress) {
    constexpr double kReadingShare = 0.3;
    const Progress assembling = progress.part(kReadingShare, 1.0);
    MeshAssembler assembler(path.string(), options, assembling);
    try {
        uint64_t buffers = 0;
        const gltf::RequireMemory requireMemory = [&](uint64_t bytes) { assembler.requireMemory(buffers + bytes); };
        const gltf::ModelFile file =
            gltf::readModel(std::move(content), path, requireMemory, options.memoryLimitBytes, progress.part(0.0, kReadingShare));
        buffers = file.bytes;
        gltf::SceneBuilder builder(*file.model, assembler, path.string(), requireMemory, assembling);
        builder.build();
        return builder.finish(path.filename().string());
    } catch (const std::bad_alloc&) {
        throwInput(CULLSCOPE_TR("%1 needs more memory than this machine gives. Simplify the mesh or split the file."),
                   {path.string()});
    }
}

FileScene readGltfFile(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress) {
    constexpr double kReadingShare = 0.3;
    return readGltf(contentOf(path, options, progress.part(0.0, kReadingShare)), path, options,
                    progress.part(kReadingShare, 1.0));
}

}  // namespace cullscope
