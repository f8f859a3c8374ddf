#include "core/scene/scene_generators.h"

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/mesh/parametric.h"
#include "core/mesh/resample.h"
#include "core/scene/courts_scene.h"
#include "core/scene/generator_memory.h"
#include "core/scene/layers_scene.h"
#include "core/scene/plant/plant_scene.h"
#include "core/scene/polygon_scene.h"
#include "core/scene/split_scene.h"
#include "embedded/lecture.h"

namespace cullscope {
namespace {

constexpr double kMostTriangles = 2e9;

OpenedScene sceneOfOne(MeshPointer mesh, const GeneratorRequest& request, SceneRemarks remarks = {}) {
    std::vector<Instance> instances{{0, Mat4(1.0), mesh->name()}};
    return {std::make_shared<Scene>(request.specification, std::vector<MeshPointer>{std::move(mesh)}, std::move(instances),
                                    nullptr, std::move(remarks)),
            request.specification, std::nullopt};
}

std::filesystem::path bunnyOrThrow(const SceneSourceOptions& options) {
    if (const auto found = findBunny(options)) return *found;
    throwInput(
        CULLSCOPE_TR("No bunny is installed here. Install the package glmark2-data, or name a folder that holds bunny.obj with "
                     "--models DIR or CULLSCOPE_MODELS."));
}

OpenedScene openBunny(GeneratorRequest& request) {
    OpenedScene opened = sceneOfFile(bunnyOrThrow(request.options), request.options, request.progress);
    opened.specification = request.specification;
    return opened;
}

OpenedScene openLecture(GeneratorRequest& request) {
    const std::string_view text = request.info.id == "quiz" ? embedded::quiz_polygons : embedded::example_polygons;
    return {readPolygonText(text, request.info.id, request.progress).scene, request.specification, std::nullopt};
}

/// All objects of a scene as one mesh, for generators that take "a mesh".
MeshPointer merged(const Scene& scene, const GeneratorRequest& request) {
    if (scene.instances().size() == 1) return scene.meshes()[scene.instances()[0].mesh];
    if (double(scene.triangleCount()) > kMostTriangles)
        throwUsage(CULLSCOPE_TR("\"%1\" has %2 triangles, too many to be one mesh."),
                   {scene.name(), std::to_string(scene.triangleCount())});
    size_t vertices = 0;
    for (const Instance& instance : scene.instances()) vertices += scene.meshes()[instance.mesh]->vertexCount();
    requireGeneratorMemory(request.info.id,
                           double(vertices) * 2 * sizeof(Vec3f) + double(scene.triangleCount()) * 3 * sizeof(uint32_t),
                           request.options.load);
    TriangleMesh::Data data;
    data.name = scene.name();
    data.origin = scene.bounds().centre();
    data.positions.reserve(vertices);
    data.normals.reserve(vertices);
    data.indices.reserve(scene.triangleCount() * 3);
    for (const Instance& instance : scene.instances()) {
        request.progress.check();
        const TriangleMesh& mesh = *scene.meshes()[instance.mesh];
        const auto first = static_cast<uint32_t>(data.positions.size());
        for (size_t v = 0; v < mesh.vertexCount(); ++v)
            data.positions.emplace_back(Vec3(instance.worldFromMesh * Vec4(mesh.position(v), 1.0)) - data.origin);
        data.normals.insert(data.normals.end(), mesh.normals().begin(), mesh.normals().end());
        for (const uint32_t index : mesh.indices()) data.indices.push_back(first + index);
    }
    return std::make_shared<TriangleMesh>(std::move(data));
}

OpenedScene openResampledMesh(GeneratorRequest& request) {
    if (request.arguments.unnamed().empty()) throwUsage(CULLSCOPE_TR("mesh: names no file. Write mesh:FILE,triangles=N."));
    OpenedScene opened = openScene(request.arguments.unnamed(), request.options, request.progress.part(0.0, 0.3));
    const size_t triangles = request.arguments.count("triangles", double(opened.scene->triangleCount()), kMostTriangles);
    if (triangles == opened.scene->triangleCount()) {
        opened.specification = request.specification;
        return opened;
    }
    SceneRemarks remarks;
    remarks.up = opened.scene->remarks().up;
    remarks.guessedUp = opened.scene->remarks().guessedUp;
    OpenedScene result = sceneOfOne(resampled(*merged(*opened.scene, request), triangles, request.progress.part(0.3, 1.0)),
                                    request, std::move(remarks));
    result.report = std::move(opened.report);
    if (result.report && result.scene->triangleCount() != triangles)
        result.report->remarks.push_back(
            {CULLSCOPE_TR("%1 triangles were made where %2 were asked for: a closed mesh has an even number."),
             {std::to_string(result.scene->triangleCount()), std::to_string(triangles)}});
    return result;
}

OpenedScene openField(GeneratorRequest& request) {
    const std::string inner = request.arguments.text("mesh", "bunny");
    const size_t n = request.arguments.count("n", 20, 2000);
    const double spacing = request.arguments.number("spacing", 2.5, 0.0, 1e9);
    requireGeneratorMemory(request.info.id, double(n) * double(n) * kBytesOfInstance, request.options.load);
    OpenedScene one = openScene(inner, request.options, request.progress);
    MeshPointer mesh = merged(*one.scene, request);

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

Courts courtsOf(GeneratorArguments& arguments) {
    Courts courts;
    courts.n = arguments.count("n", double(courts.n), kMostCourts);
    courts.walls = arguments.number("walls", courts.walls, 0.0, 1e3);
    return courts;
}

OpenedScene openCourts(GeneratorRequest& request) {
    const Courts courts = courtsOf(request.arguments);
    OpenedScene opened = openScene(request.arguments.text("mesh", "plant"), request.options, request.progress.part(0.0, 0.8));
    requireGeneratorMemory(request.info.id,
                           double(objectsOfACourt(*opened.scene, courts)) * double(courts.n * courts.n) * kBytesOfInstance,
                           request.options.load);
    opened.scene = courtsScene(request.specification, *opened.scene, courts, request.progress.part(0.8, 1.0));
    opened.specification = request.specification;
    return opened;
}

SplitRule splitRule(GeneratorArguments& arguments) {
    SplitRule rule;
    const std::string by = arguments.text("by", "components");
    if (by == "clusters")
        rule.by = SplitRule::By::Clusters;
    else if (by != "components")
        throwUsage(CULLSCOPE_TR("split: by=%1 is unknown. Write by=components or by=clusters."), {by});
    if (arguments.has("triangles") && rule.by == SplitRule::By::Components)
        throwUsage(CULLSCOPE_TR("split: triangles is the size of clusters. Write by=clusters with it, or leave it out."));
    rule.triangles = arguments.count("triangles", double(rule.triangles), kMostTriangles);
    return rule;
}

OpenedScene openSplit(GeneratorRequest& request) {
    const SplitRule rule = splitRule(request.arguments);
    OpenedScene opened = openScene(request.arguments.text("mesh", "bunny"), request.options, request.progress.part(0.0, 0.5));
    opened.scene = splitScene(*opened.scene, request.specification, rule, request.progress.part(0.5, 1.0));
    opened.specification = request.specification;
    return opened;
}

OpenedScene openLayers(GeneratorRequest& request) {
    constexpr double kMostLayers = 100'000, kMostOfALayer = 1e8;
    Layers layers;
    layers.count = request.arguments.count("count", double(layers.count), kMostLayers);
    layers.triangles = request.arguments.count("triangles", double(layers.triangles), kMostOfALayer);
    layers.waves = request.arguments.number("waves", layers.waves, 0.0, 1.0);
    requireGeneratorMemory(request.info.id,
                           double(layers.triangles) * kBytesOfMadeTriangle + double(layers.count) * kBytesOfInstance,
                           request.options.load);
    return {layersScene(request.specification, layers, request.progress), request.specification, std::nullopt};
}

OpenedScene openPlant(GeneratorRequest& request) {
    PlantOptions plant;
    plant.pipelines = request.arguments.count("pipelines", double(plant.pipelines), kMostPipelines);
    plant.seed = uint64_t(request.arguments.wholeNumber("seed", double(plant.seed), 0, 9e15));
    plant.chordError = 0.001 * request.arguments.number("chord", 0.0, 1000.0 * kLeastChordError, 1000.0 * kMostChordError);
    requireGeneratorMemory(request.info.id, double(plant.pipelines) * kBytesOfPipeline, request.options.load);
    return {plantScene(request.specification, plant, request.progress), request.specification, std::nullopt};
}

MeshPointer parametricMesh(GeneratorRequest& request) {
    const std::string& id = request.info.id;
    const Progress& progress = request.progress;
    const size_t triangles = request.arguments.count("triangles", id == "teapot" ? 64e3 : 1e5, kMostTriangles);
    requireGeneratorMemory(id, double(triangles) * kBytesOfMadeTriangle, request.options.load);
    if (id == "star")
        return starMesh(static_cast<uint64_t>(request.arguments.wholeNumber("seed", 7, 0, 9e15)), triangles, progress);
    if (id == "teapot") return teapotMesh(triangles, progress);
    if (id == "sphere") return sphereMesh(triangles, progress);
    if (id == "torus") return torusMesh(triangles, progress);
    if (id == "bowl") return bowlMesh(triangles, progress);
    return knotMesh(triangles, progress);
}

OpenedScene openParametric(GeneratorRequest& request) { return sceneOfOne(parametricMesh(request), request); }

const GeneratorParameter kTriangles{"triangles", "1e5",
                                    CULLSCOPE_TR("how many triangles, to the nearest that the shape's grid allows")};

const GeneratorParameter kMesh{"mesh", "bunny", CULLSCOPE_TR("mesh file, or a generator with its own parameters")};

// What generators will make, by their arguments: each has the one that reads the same numbers as the function that opens.

SceneEstimate estimateMesh(const std::string& specification, const SceneSourceOptions& options) {
    return estimateScene(specification, options).value_or(SceneEstimate{});
}

SceneEstimate estimateOfFile(GeneratorRequest& /*request*/) { return {}; }

SceneEstimate estimateParametric(GeneratorRequest& request) {
    const double triangles =
        double(request.arguments.count("triangles", request.info.id == "teapot" ? 64e3 : 1e5, kMostTriangles));
    return {triangles, 1.0, triangles * kBytesOfMadeTriangle};
}

SceneEstimate estimateField(GeneratorRequest& request) {
    SceneEstimate one = estimateMesh(request.arguments.text("mesh", "bunny"), request.options);
    const double n = double(request.arguments.count("n", 20, 2000));
    if (one.triangles) *one.triangles *= n * n;
    return {one.triangles, n * n, one.bytes + n * n * kBytesOfInstance};
}

SceneEstimate estimateCourts(GeneratorRequest& request) {
    SceneEstimate one = estimateMesh(request.arguments.text("mesh", "plant"), request.options);
    const Courts courts = courtsOf(request.arguments);
    const double count = double(courts.n) * double(courts.n);
    if (courts.walls > 0.0) {
        one.objects += double(kWallsOfACourt);
        if (one.triangles) *one.triangles += double(kWallsOfACourt * kTrianglesOfAWall);
    }
    if (one.triangles) *one.triangles *= count;
    return {one.triangles, one.objects * count, one.bytes + one.objects * count * kBytesOfInstance};
}

SceneEstimate estimateLayers(GeneratorRequest& request) {
    const Layers usual;
    const double count = double(request.arguments.count("count", double(usual.count), 100'000));
    const double triangles = double(request.arguments.count("triangles", double(usual.triangles), 1e8));
    return {count * triangles, count, triangles * kBytesOfMadeTriangle + count * kBytesOfInstance};
}

SceneEstimate estimatePlant(GeneratorRequest& request) {
    const double pipelines = double(request.arguments.count("pipelines", double(PlantOptions().pipelines), kMostPipelines));
    // A finer chord than the usual one makes more triangles: how many only the tessellation tells.
    std::optional<double> triangles;
    if (!request.arguments.has("chord")) triangles = pipelines * kTrianglesOfPipeline;
    return {triangles, pipelines * kObjectsOfPipeline, pipelines * kBytesOfPipeline};
}

SceneEstimate estimateResampled(GeneratorRequest& request) {
    SceneEstimate read = estimateMesh(request.arguments.unnamed(), request.options);
    if (request.arguments.has("triangles")) read.triangles = double(request.arguments.count("triangles", 1.0, kMostTriangles));
    return {read.triangles, 1.0, std::max(read.bytes, read.triangles.value_or(0.0) * kBytesOfMadeTriangle)};
}

SceneEstimate estimateSplit(GeneratorRequest& request) {
    const SceneEstimate whole = estimateMesh(request.arguments.text("mesh", "bunny"), request.options);
    const SplitRule rule = splitRule(request.arguments);
    const bool clusters = rule.by == SplitRule::By::Clusters && whole.triangles;
    return {whole.triangles, clusters ? std::ceil(*whole.triangles / double(rule.triangles)) : whole.objects, 2.0 * whole.bytes};
}

}  // namespace

const std::vector<Generator>& sceneGeneratorTable() {
    static const std::vector<Generator> kGenerators{
        {{"bunny", CULLSCOPE_TR("the Stanford bunny, from an installed model file"), {}}, openBunny, estimateOfFile},
        {{"teapot",
          CULLSCOPE_TR("Newell's teapot, tessellated from its 32 Bézier patches"),
          {{"triangles", "64000", CULLSCOPE_TR("how many triangles, to the nearest that the shape's grid allows")}}},
         openParametric,
         estimateParametric},
        {{"sphere", CULLSCOPE_TR("a unit sphere, from an icosahedron"), {kTriangles}}, openParametric, estimateParametric},
        {{"torus", CULLSCOPE_TR("a torus of radii 1 and 0.25: closed, not star-shaped"), {kTriangles}},
         openParametric,
         estimateParametric},
        {{"bowl", CULLSCOPE_TR("half a hollow sphere, open towards z: closed, hides its inside from its outside"), {kTriangles}},
         openParametric,
         estimateParametric},
        {{"knot", CULLSCOPE_TR("a tube around a torus knot: hides much of itself"), {kTriangles}},
         openParametric,
         estimateParametric},
        {{"star",
          CULLSCOPE_TR("a star-shaped body with random bumps"),
          {{"seed", "7", CULLSCOPE_TR("number that the random shape starts from")}, kTriangles}},
         openParametric,
         estimateParametric},
        {{"field",
          CULLSCOPE_TR("a grid of n by n copies of a mesh, each of radius 1"),
          {kMesh,
           {"n", "20", CULLSCOPE_TR("copies along each side")},
           {"spacing", "2.5", CULLSCOPE_TR("distance between neighbours")}}},
         openField,
         estimateField},
        {{"courts",
          CULLSCOPE_TR("n by n copies of a scene, each behind walls of its own: who stands in one sees no other"),
          {{"mesh", "plant", CULLSCOPE_TR("mesh file, or a generator with its own parameters")},
           {"n", "4", CULLSCOPE_TR("courts along each side")},
           {"walls", "1.1", CULLSCOPE_TR("height of the walls, as a share of the scene's; 0: there are none")}}},
         openCourts,
         estimateCourts},
        {{"layers",
          CULLSCOPE_TR("sheets one behind the other, each an object: seen from the front, the first one hides the others"),
          {{"count", "32", CULLSCOPE_TR("how many layers")},
           {"triangles", "1e4", CULLSCOPE_TR("how many triangles each layer has, to the nearest that its grid allows")},
           {"waves", "0", CULLSCOPE_TR("height of the layers' waves; 0: they are flat")}}},
         openLayers,
         estimateLayers},
        {{"plant",
          CULLSCOPE_TR("a process plant of primitives: pipe racks with pipelines, equipment, steel and platforms"),
          {{"pipelines", "100", CULLSCOPE_TR("how many pipelines")},
           {"seed", "1", CULLSCOPE_TR("number that the plant starts from")},
           {"chord", "",
            CULLSCOPE_TR(
                "millimetres that triangles lie away from round surfaces at most; without it, 8 to 32 chords by size")}}},
         openPlant,
         estimatePlant},
        {{"mesh",
          CULLSCOPE_TR("a mesh file simplified or subdivided: mesh:FILE,triangles=N"),
          {{"triangles", "", CULLSCOPE_TR("how many triangles to make of it")}}},
         openResampledMesh,
         estimateResampled},
        {{"split",
          CULLSCOPE_TR("a mesh with every object split, so that there are objects to leave out; draws the same picture"),
          {kMesh,
           {"by", "components",
            CULLSCOPE_TR("components: what hangs together becomes an object; clusters: compact pieces of like size do")},
           {"triangles", "5000", CULLSCOPE_TR("how many triangles a cluster has at most (with by=clusters)")}}},
         openSplit,
         estimateSplit},
        {{"quiz", CULLSCOPE_TR("the lecture's quiz: polygons A, B and C, and the planes P1 to P3 that divide them"), {}},
         openLecture,
         estimateOfFile},
        {{"example", CULLSCOPE_TR("the lecture's worked example: polygons A to D, divided by the planes P1 and P2"), {}},
         openLecture,
         estimateOfFile}};
    return kGenerators;
}

}  // namespace cullscope
