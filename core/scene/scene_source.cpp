#include "core/scene/scene_source.h"

#include <array>
#include <cstdlib>

#include "core/base/error.h"
#include "core/scene/gallery/gallery.h"
#include "core/scene/gltf/gltf_scene.h"
#include "core/scene/ifc/ifc_scene.h"
#include "core/scene/polygon_scene.h"
#include "core/scene/quake/quake_scene.h"
#include "core/scene/rvm/rvm_scene.h"
#include "core/scene/scene_generators.h"

#ifndef CULLSCOPE_INSTALLED_DATA
#define CULLSCOPE_INSTALLED_DATA "/usr/share/cullscope"
#endif

namespace cullscope {
namespace {

/// A format whose files say more than meshes do.
struct SceneFormat {
    bool (*isOf)(const std::filesystem::path& path);
    FileScene (*read)(const std::filesystem::path& path, const LoadOptions& options, const Progress& progress);
};

constexpr std::array kSceneFormats{
    SceneFormat{isPolygonFile, readPolygonFile},
    SceneFormat{isRvmFile, [](const std::filesystem::path& path, const LoadOptions& options,
                              const Progress& progress) { return readRvmFile(path, options, progress); }},
    SceneFormat{isQuakeFile, readQuakeFile}, SceneFormat{isGltfFile, readGltfFile}, SceneFormat{isIfcFile, readIfcFile}};

}  // namespace

OpenedScene sceneOfFile(const std::filesystem::path& path, const SceneSourceOptions& options, const Progress& progress) {
    for (const SceneFormat& format : kSceneFormats) {
        if (!format.isOf(path)) continue;
        FileScene read = format.read(path, options.load, progress);
        return {std::move(read.scene), path.string(), std::move(read.report)};
    }
    LoadedFile file = loadMeshFile(path, options.load, progress);
    std::vector<MeshPointer> meshes;
    std::vector<Instance> instances;
    Box3 bounds;
    for (LoadedObject& object : file.objects) {
        instances.push_back({static_cast<uint32_t>(meshes.size()), Mat4(1.0), object.name});
        bounds.add(object.mesh->origin() + object.mesh->localBounds().min);
        bounds.add(object.mesh->origin() + object.mesh->localBounds().max);
        meshes.push_back(std::move(object.mesh));
    }
    SceneRemarks remarks;
    remarks.guessedUp = guessedUpAxis(bounds);
    return {
        std::make_shared<Scene>(path.filename().string(), std::move(meshes), std::move(instances), nullptr, std::move(remarks)),
        path.string(), std::move(file.report)};
}

namespace {

/// The generator that a specification names; null where a file has that name and the name has no parameters.
const Generator* generatorOf(std::string_view specification) {
    const size_t colon = specification.find(':');
    const std::string_view id = specification.substr(0, colon);
    std::error_code ignored;
    for (const std::vector<Generator>* table : {&sceneGeneratorTable(), &galleryGenerators()})
        for (const Generator& generator : *table)
            if (generator.info.id == id)
                return colon == std::string_view::npos && std::filesystem::is_regular_file(id, ignored) ? nullptr : &generator;
    return nullptr;
}

}  // namespace

OpenedScene openScene(std::string_view specification, const SceneSourceOptions& options, const Progress& progress) {
    const std::string text(specification);
    if (text.empty())
        throwUsage(CULLSCOPE_TR("No scene is named. Give a mesh file or a generator such as bunny or sphere:triangles=1e5."));
    const Generator* generator = generatorOf(specification);
    if (generator == nullptr) {
        std::error_code ignored;  // a name may be too long to be asked for
        const bool looksLikeFile = std::filesystem::exists(text, ignored) || text.find_first_of("./\\") != std::string::npos;
        if (looksLikeFile) return sceneOfFile(text, options, progress);
        std::string known;
        for (const Generator& each : sceneGeneratorTable()) known += (known.empty() ? "" : ", ") + each.info.id;
        throwUsage(CULLSCOPE_TR("\"%1\" is neither a file nor a generator. Generators: %2."), {text, known});
    }
    GeneratorArguments arguments(cutSpecification(text, sceneGenerators()));
    GeneratorRequest request{arguments, generator->info, options, progress, text};
    // Unknown parameters are refused before the scene is generated, so that a typing error does not cost a minute.
    GeneratorArguments check = arguments;
    for (const GeneratorParameter& parameter : generator->info.parameters) (void)check.text(parameter.key, "");
    check.finish(generator->info);
    return generator->open(request);
}

bool SceneEstimate::large() const { return triangles.value_or(0.0) > double(kOptionalAnalysisLimit) || bytes > kManyBytes; }

std::optional<SceneEstimate> estimateScene(std::string_view specification, const SceneSourceOptions& options) {
    const Generator* generator = generatorOf(specification);
    if (generator == nullptr) return std::nullopt;
    const std::string text(specification);
    GeneratorArguments arguments(cutSpecification(text, sceneGenerators()));
    const Progress progress;
    GeneratorRequest request{arguments, generator->info, options, progress, text};
    return generator->estimate(request);
}

const std::vector<GeneratorInfo>& sceneGenerators() {
    static const std::vector<GeneratorInfo> kInfos = [] {
        std::vector<GeneratorInfo> infos;
        for (const Generator& generator : sceneGeneratorTable()) infos.push_back(generator.info);
        return infos;
    }();
    return kInfos;
}

std::string withFiles(std::string_view specification, const std::function<std::string(const std::string&)>& change) {
    if (generatorOf(specification) == nullptr) return change(std::string(specification));
    Specification cut = cutSpecification(specification, sceneGenerators());
    for (Specification::Piece& piece : cut.pieces)
        if (cut.namesMesh(piece) && !piece.value.empty()) piece.value = withFiles(piece.value, change);
    return cut.text();
}

std::string defaultSceneSpecification(const SceneSourceOptions& options) { return findBunny(options) ? "bunny" : "teapot"; }

std::optional<std::filesystem::path> findBunny(const SceneSourceOptions& options) {
    std::vector<std::filesystem::path> folders = options.modelFolders;
    if (const char* environment = std::getenv("CULLSCOPE_MODELS")) folders.emplace_back(environment);
    folders.emplace_back(CULLSCOPE_INSTALLED_DATA "/models");
    folders.emplace_back("/usr/share/glmark2/models");
    for (const std::filesystem::path& folder : folders) {
        std::error_code ignored;
        if (std::filesystem::is_regular_file(folder / "bunny.obj", ignored)) return folder / "bunny.obj";
    }
    return std::nullopt;
}

}  // namespace cullscope
