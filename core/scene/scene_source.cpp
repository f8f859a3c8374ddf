#include "core/scene/scene_source.h"

#include <charconv>
#include <cstdlib>
#include <map>

#include "core/base/error.h"
#include "core/mesh/parametric.h"
#include "core/mesh/resample.h"

#ifndef CULLSCOPE_INSTALLED_DATA
#define CULLSCOPE_INSTALLED_DATA "/usr/share/cullscope"
#endif

namespace cullscope {
namespace {

/// What stands behind the colon of a generator: an optional unnamed first word and key=value pairs.
class GeneratorArguments {
public:
    GeneratorArguments(std::string generator, std::string_view text) : m_generator(std::move(generator)) {
        for (const std::string& piece : pieces(text)) {
            const size_t equals = piece.find('=');
            // A file's name may hold an equals sign; what stands before one of a parameter is a plain word.
            if (equals == std::string::npos || wordLength(piece) != equals)
                m_unnamed = piece;
            else if (equals + 1 == piece.size())
                throwUsage(CULLSCOPE_TR("%1: %2 has no value."), {m_generator, piece});
            else
                m_values[piece.substr(0, equals)] = piece.substr(equals + 1);
        }
    }

    [[nodiscard]] const std::string& unnamed() const { return m_unnamed; }

    std::string text(const std::string& key, const std::string& fallback) {
        const auto found = m_values.find(key);
        if (found == m_values.end()) return fallback;
        std::string value = found->second;
        m_values.erase(found);
        return value;
    }

    double number(const std::string& key, double fallback, double least, double most) {
        const std::string value = text(key, "");
        if (value.empty()) return fallback;
        double parsed = 0.0;
        const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), parsed);
        if (error != std::errc() || end != value.data() + value.size() || !(parsed >= least && parsed <= most))
            throwUsage(CULLSCOPE_TR("%1: %2=%3 is not a number between %4 and %5."),
                       {m_generator, key, value, shortest(least), shortest(most)});
        return parsed;
    }

    double wholeNumber(const std::string& key, double fallback, double least, double most) {
        const double value = number(key, fallback, least, most);
        if (value != std::floor(value))
            throwUsage(CULLSCOPE_TR("%1: %2 is a whole number, not %3."), {m_generator, key, shortest(value)});
        return value;
    }

    size_t count(const std::string& key, double fallback, double most) {
        return static_cast<size_t>(wholeNumber(key, fallback, 1, most));
    }

    /// Refuses what nobody asked for: call after everything known was taken.
    void finish(const GeneratorInfo& info) const {
        if (!m_values.empty()) {
            std::string known;
            for (const GeneratorParameter& parameter : info.parameters) known += (known.empty() ? "" : ", ") + parameter.key;
            throwUsage(CULLSCOPE_TR("%1 has no parameter \"%2\". It has: %3."),
                       {m_generator, m_values.begin()->first, known.empty() ? "-" : known});
        }
        const bool takesFile = info.id == "mesh";
        if (!takesFile && !m_unnamed.empty())
            throwUsage(CULLSCOPE_TR("%1: \"%2\" is not of the form key=value."), {m_generator, m_unnamed});
    }

private:
    static std::string shortest(double value) {
        std::array<char, 32> buffer{};
        const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
        return {buffer.data(), result.ptr};
    }

    /// How many characters of a parameter's name the text begins with.
    static size_t wordLength(std::string_view text) {
        const auto end = std::find_if(text.begin(), text.end(), [](char c) {
            return !std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_';
        });
        return static_cast<size_t>(end - text.begin());
    }

    /// Splits at commas, but only where "name=" follows, so that a file's name may hold commas.
    static std::vector<std::string> pieces(std::string_view text) {
        std::vector<std::string> pieces;
        size_t start = 0;
        for (size_t comma = text.find(','); comma != std::string_view::npos; comma = text.find(',', comma + 1)) {
            const size_t end = comma + 1 + wordLength(text.substr(comma + 1));
            if (end == comma + 1 || end >= text.size() || text[end] != '=') continue;
            pieces.emplace_back(text.substr(start, comma - start));
            start = comma + 1;
        }
        if (start < text.size()) pieces.emplace_back(text.substr(start));
        return pieces;
    }

    std::string m_generator;
    std::string m_unnamed;
    std::map<std::string, std::string> m_values;
};

struct Request {
    GeneratorArguments& arguments;
    const GeneratorInfo& info;
    const SceneSourceOptions& options;
    const Progress& progress;
    std::string specification;
};

OpenedScene sceneOfOne(MeshPointer mesh, const Request& request) {
    std::vector<Instance> instances{{0, Mat4(1.0), mesh->name()}};
    return {std::make_shared<Scene>(request.specification, std::vector<MeshPointer>{std::move(mesh)}, std::move(instances)),
            request.specification, std::nullopt};
}

OpenedScene sceneOfFile(const std::filesystem::path& path, const SceneSourceOptions& options, const Progress& progress) {
    LoadedFile file = loadMeshFile(path, options.load, progress);
    std::vector<MeshPointer> meshes;
    std::vector<Instance> instances;
    for (LoadedObject& object : file.objects) {
        instances.push_back({static_cast<uint32_t>(meshes.size()), Mat4(1.0), object.name});
        meshes.push_back(std::move(object.mesh));
    }
    return {std::make_shared<Scene>(path.filename().string(), std::move(meshes), std::move(instances)), path.string(),
            std::move(file.report)};
}

std::filesystem::path bunnyOrThrow(const SceneSourceOptions& options) {
    if (const auto found = findBunny(options)) return *found;
    throwInput(
        CULLSCOPE_TR("No bunny is installed here. Install the package glmark2-data, or name a folder that holds bunny.obj with "
                     "--models DIR or CULLSCOPE_MODELS."));
}

/// A file's path; the word "bunny" stands for the installed one.
std::filesystem::path meshFile(const std::string& name, const SceneSourceOptions& options) {
    if (name == "bunny" && !std::filesystem::exists(name)) return bunnyOrThrow(options);
    return name;
}

OpenedScene openBunny(Request& request) {
    OpenedScene opened = sceneOfFile(bunnyOrThrow(request.options), request.options, request.progress);
    opened.specification = request.specification;
    return opened;
}

/// All objects of a scene as one mesh, for generators that take "a mesh".
MeshPointer merged(const Scene& scene, const Progress& progress) {
    if (scene.instances().size() == 1) return scene.meshes()[scene.instances()[0].mesh];
    TriangleMesh::Data data;
    data.name = scene.name();
    data.origin = scene.bounds().centre();
    data.indices.reserve(scene.triangleCount() * 3);
    for (const Instance& instance : scene.instances()) {
        progress.check();
        const TriangleMesh& mesh = *scene.meshes()[instance.mesh];
        const auto first = static_cast<uint32_t>(data.positions.size());
        for (size_t v = 0; v < mesh.vertexCount(); ++v)
            data.positions.emplace_back(Vec3(instance.worldFromMesh * Vec4(mesh.position(v), 1.0)) - data.origin);
        data.normals.insert(data.normals.end(), mesh.normals().begin(), mesh.normals().end());
        for (const uint32_t index : mesh.indices()) data.indices.push_back(first + index);
    }
    return std::make_shared<TriangleMesh>(std::move(data));
}

OpenedScene openResampledMesh(Request& request) {
    if (request.arguments.unnamed().empty()) throwUsage(CULLSCOPE_TR("mesh: names no file. Write mesh:FILE,triangles=N."));
    OpenedScene opened =
        sceneOfFile(meshFile(request.arguments.unnamed(), request.options), request.options, request.progress.part(0.0, 0.3));
    const size_t triangles = request.arguments.count("triangles", double(opened.scene->triangleCount()), 2e9);
    if (triangles == opened.scene->triangleCount()) {
        opened.specification = request.specification;
        return opened;
    }
    OpenedScene result =
        sceneOfOne(resampled(*merged(*opened.scene, request.progress), triangles, request.progress.part(0.3, 1.0)), request);
    result.report = std::move(opened.report);
    if (result.report && result.scene->triangleCount() != triangles)
        result.report->remarks.push_back(
            {CULLSCOPE_TR("%1 triangles were made where %2 were asked for: a closed mesh has an even number."),
             {std::to_string(result.scene->triangleCount()), std::to_string(triangles)}});
    return result;
}

OpenedScene openField(Request& request) {
    const std::string file = request.arguments.text("mesh", "bunny");
    const size_t n = request.arguments.count("n", 20, 2000);
    const double spacing = request.arguments.number("spacing", 2.5, 0.0, 1e9);
    OpenedScene one = sceneOfFile(meshFile(file, request.options), request.options, request.progress);
    MeshPointer mesh = merged(*one.scene, request.progress);

    const Vec3 centre = mesh->origin() + mesh->localBounds().centre();
    double farthestSquared = 0.0;
    for (const uint32_t index : mesh->indices()) {
        const Vec3 offset = mesh->position(index) - centre;
        farthestSquared = std::max(farthestSquared, glm::dot(offset, offset));
    }
    const double scale = 1.0 / std::sqrt(farthestSquared);
    std::vector<Instance> instances;
    for (size_t i = 0; i < n; ++i) {
        request.progress.check();
        for (size_t j = 0; j < n; ++j) {
            const double half = (double(n) - 1) / 2.0;
            Mat4 place(scale);
            place[3] = Vec4(Vec3((double(i) - half) * spacing, 0.0, (double(j) - half) * spacing) - centre * scale, 1.0);
            instances.push_back({0, place, mesh->name() + " " + std::to_string(i) + "," + std::to_string(j)});
        }
    }
    return {std::make_shared<Scene>(request.specification, std::vector<MeshPointer>{mesh}, std::move(instances)),
            request.specification, std::move(one.report)};
}

constexpr double kMostTriangles = 2e9;

MeshPointer parametricMesh(Request& request) {
    const std::string& id = request.info.id;
    const Progress& progress = request.progress;
    const size_t triangles = request.arguments.count("triangles", id == "teapot" ? 64e3 : 1e5, kMostTriangles);
    if (id == "star")
        return starMesh(static_cast<uint64_t>(request.arguments.wholeNumber("seed", 7, 0, 9e15)), triangles, progress);
    if (id == "teapot") return teapotMesh(triangles, progress);
    if (id == "sphere") return sphereMesh(triangles, progress);
    if (id == "torus") return torusMesh(triangles, progress);
    return knotMesh(triangles, progress);
}

OpenedScene openParametric(Request& request) { return sceneOfOne(parametricMesh(request), request); }

const GeneratorParameter kTriangles{"triangles", "1e5",
                                    CULLSCOPE_TR("how many triangles, to the nearest that the shape's grid allows")};

struct Generator {
    GeneratorInfo info;
    OpenedScene (*open)(Request& request);
};

const std::vector<Generator>& generators() {
    static const std::vector<Generator> kGenerators{
        {{"bunny", CULLSCOPE_TR("the Stanford bunny, from an installed model file"), {}}, openBunny},
        {{"teapot",
          CULLSCOPE_TR("Newell's teapot, tessellated from its 32 Bézier patches"),
          {{"triangles", "64000", CULLSCOPE_TR("how many triangles, to the nearest that the shape's grid allows")}}},
         openParametric},
        {{"sphere", CULLSCOPE_TR("a unit sphere, from an icosahedron"), {kTriangles}}, openParametric},
        {{"torus", CULLSCOPE_TR("a torus of radii 1 and 0.25: closed, not star-shaped"), {kTriangles}}, openParametric},
        {{"knot", CULLSCOPE_TR("a tube around a torus knot: hides much of itself"), {kTriangles}}, openParametric},
        {{"star",
          CULLSCOPE_TR("a star-shaped body with random bumps"),
          {{"seed", "7", CULLSCOPE_TR("number that the random shape starts from")}, kTriangles}},
         openParametric},
        {{"field",
          CULLSCOPE_TR("a grid of n by n copies of a mesh, each of radius 1"),
          {{"mesh", "bunny", CULLSCOPE_TR("mesh file, or bunny")},
           {"n", "20", CULLSCOPE_TR("copies along each side")},
           {"spacing", "2.5", CULLSCOPE_TR("distance between neighbours")}}},
         openField},
        {{"mesh",
          CULLSCOPE_TR("a mesh file simplified or subdivided: mesh:FILE,triangles=N"),
          {{"triangles", "", CULLSCOPE_TR("how many triangles to make of it")}}},
         openResampledMesh}};
    return kGenerators;
}

/// The generator that a specification names, if it is not a file's name.
const Generator* generatorOf(std::string_view specification) {
    const std::string_view id = specification.substr(0, specification.find(':'));
    for (const Generator& generator : generators())
        if (generator.info.id == id) return &generator;
    return nullptr;
}

}  // namespace

OpenedScene openScene(std::string_view specification, const SceneSourceOptions& options, const Progress& progress) {
    const std::string text(specification);
    if (text.empty())
        throwUsage(CULLSCOPE_TR("No scene is named. Give a mesh file or a generator such as bunny or sphere:triangles=1e5."));
    const Generator* generator = generatorOf(specification);
    if (generator == nullptr || (text.find(':') == std::string::npos && std::filesystem::is_regular_file(text))) {
        const bool looksLikeFile = std::filesystem::exists(text) || text.find_first_of("./\\") != std::string::npos;
        if (looksLikeFile) return sceneOfFile(text, options, progress);
        std::string known;
        for (const Generator& each : generators()) known += (known.empty() ? "" : ", ") + each.info.id;
        throwUsage(CULLSCOPE_TR("\"%1\" is neither a file nor a generator. Generators: %2."), {text, known});
    }
    const size_t colon = text.find(':');
    GeneratorArguments arguments(generator->info.id,
                                 colon == std::string::npos ? std::string_view() : specification.substr(colon + 1));
    Request request{arguments, generator->info, options, progress, text};
    // A parameter nobody knows is refused before the work, so that a typing error does not cost a minute.
    GeneratorArguments check = arguments;
    for (const GeneratorParameter& parameter : generator->info.parameters) (void)check.text(parameter.key, "");
    check.finish(generator->info);
    return generator->open(request);
}

const std::vector<GeneratorInfo>& sceneGenerators() {
    static const std::vector<GeneratorInfo> kInfos = [] {
        std::vector<GeneratorInfo> infos;
        for (const Generator& generator : generators()) infos.push_back(generator.info);
        return infos;
    }();
    return kInfos;
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
