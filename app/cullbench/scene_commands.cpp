#include <fmt/format.h>

#include <optional>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/base/json.h"
#include "core/base/terminal_text.h"
#include "core/experiments/result_file.h"
#include "core/geometry/frustum_planes.h"
#include "core/mesh/save.h"
#include "core/scene/camera_path.h"

namespace cullscope::cullbench {
namespace {

struct ExportOptions {
    SceneChoice scene;
    std::string output;
};

void runExport(const ExportOptions& options, const Context& context) {
    requireMeshFormat(options.output);
    checkOutputPlaces({options.output});
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    std::vector<PlacedMesh> placed;
    for (size_t i = 0; i < opened.scene->instances().size(); ++i) {
        const Instance& instance = opened.scene->instances()[i];
        placed.push_back({instance.name, &opened.scene->meshOf(i), instance.worldFromMesh});
    }
    saveMeshFile(options.output, placed, terminalProgress(context));
    clearProgress();
    say(options.output == "-" ? stderr : stdout, "{}: {} triangles in {} objects\n", options.output,
        opened.scene->triangleCount(), placed.size());
}

struct InspectOptions {
    SceneChoice scene;
    std::string strategy, json;
    std::vector<std::string> parameters;
};

/// The difference between the planes taken from the overview camera's matrix and those that culling uses.
struct PlaneFigures {
    PlaneDifference byRows, byCorners;
};

/// None for a strategy that tests no planes.
std::optional<PlaneFigures> planeFigures(const StrategyInfo& info, const Scene& scene) {
    if (info.first(Show::Kind::Planes) == nullptr) return std::nullopt;
    const View view(overviewCamera(scene, 1.0), {640, 480});
    const FrustumPlanes& used = view.frustum().planes;
    const auto rows = planesFromRows(view.clipFromEyeRelative(), ClipDepth::ReversedZeroToOne);
    const auto corners = planesFromCorners(view.clipFromEyeRelative(), ClipDepth::ReversedZeroToOne);
    if (!rows || !corners) return std::nullopt;
    return PlaneFigures{largestDifference(*rows, used), largestDifference(*corners, used)};
}

uint64_t allOf(const std::map<std::string, uint64_t>& counts) {
    uint64_t sum = 0;
    for (const auto& [kind, count] : counts) sum += count;
    return sum;
}

void runInspect(const InspectOptions& options, const Context& context) {
    const StrategyRequest request = strategiesOf({options.strategy}, options.parameters).front();
    checkOutputPlaces({options.json});
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    StructureStore structures;
    const BuiltStrategyPointer strategy =
        buildStrategy(request.id, request.parameters, opened.scene, structures, terminalProgress(context));
    clearProgress();
    const StructureReport& structure = strategy->report();
    const Scene& scene = *opened.scene;
    const std::optional<PlaneFigures> planes = planeFigures(strategy->info(), scene);
    const char* facing = facingId(strategy->facing());
    if (!options.json.empty()) {
        Json json{{"scene",
                   {{"name", scene.name()},
                    {"triangles", scene.triangleCount()},
                    {"instances", scene.instances().size()},
                    {"meshes", scene.meshes().size()},
                    {"bytes", scene.bytes()}}},
                  {"strategy", request.id},
                  {"promise", promiseId(strategy->promise())},
                  {"facing", facing},
                  {"build_ms", structure.buildMilliseconds},
                  {"structure_bytes", structure.bytes}};
        for (const StructureReport::Figure& figure : structure.figures) json["figures"][figure.name] = figure.value;
        for (const auto& [kind, count] : scene.partCounts()) json["scene"]["primitives"][kind] = count;
        if (const uint64_t all = allOf(scene.partCounts()); all > 0) json["scene"]["primitives_together"] = all;
        if (!structure.layout.empty()) json["layout"] = structure.layout;
        if (planes)
            for (const auto& [way, difference] : {std::pair("rows", planes->byRows), std::pair("corners", planes->byCorners)})
                json["planes"][way] = {{"degrees", difference.angle.degrees()}, {"offset", difference.offset}};
        for (const MeshStates& states : strategy->meshStates())
            for (const auto& [state, meshes] : states.meshes) json[states.key].push_back({{"state", state}, {"meshes", meshes}});
        writeText(options.json, plainJson(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n");
    }
    if (options.json == "-") return;
    say("{}: {} triangles in {} objects, {} bytes\n", scene.name(), scene.triangleCount(), scene.instances().size(),
        scene.bytes());
    if (scene.meshes().size() < scene.instances().size()) say("  meshes that they share: {}\n", scene.meshes().size());
    const std::map<std::string, uint64_t> kinds = scene.partCounts();
    for (const auto& [kind, count] : kinds) say("  {} of kind {}\n", count, kind);
    if (!kinds.empty()) say("  {} primitives together\n", allOf(kinds));
    say("{} ({}, {})\n  build {:.3f} ms\n  structures {} bytes\n", request.id, promiseId(strategy->promise()), facing,
        structure.buildMilliseconds, structure.bytes);
    for (const StructureReport::Figure& figure : structure.figures) say("  {} {}\n", figure.name, figure.value);
    if (planes)
        for (const auto& [way, difference] : {std::pair("rows", planes->byRows), std::pair("corners", planes->byCorners)})
            say("  planes from the matrix's {} differ by at most {:.2g} degrees, {:.2g} in offset\n", way,
                difference.angle.degrees(), difference.offset);
    if (!structure.layout.empty()) say("  layout {}\n", structure.layout);
    for (const MeshStates& states : strategy->meshStates())
        for (const auto& [state, meshes] : states.meshes)
            say("  {} of {}: {}\n", states.name, meshes == 1 ? "1 mesh" : fmt::format("{} meshes", meshes), state);
}

struct PathOptions {
    SceneChoice scene;
    std::string name, output, size = "640x480";
    double fovx = 0.0;
    ProjectionOptions projection;
};

void runPath(const PathOptions& options, const Context& context) {
    checkOutputPlaces({options.output});
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    CameraPath path = cameraPath(options.name, *opened.scene, {nullptr, context.stop});
    if (options.fovx > 0.0) path.fovy = verticalField(Angle::fromDegrees(options.fovx), sizeFromText(options.size));
    options.projection.applyTo(path);
    writeCameraPath(options.output, path);
    if (options.output != "-") say("{}: {} poses\n", options.output, path.poses.size());
}

}  // namespace

void addExportCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("export", "Writes any scene as a mesh file, one named object a component");
    auto options = std::make_shared<ExportOptions>();
    addSceneOptions(*command, options->scene);
    command
        ->add_option("-o,--output", options->output,
                     "FILE.obj, .ply or .stl; - is standard output (OBJ). Only OBJ keeps the objects apart")
        ->required();
    command->callback([options, &context] { runExport(*options, context); });
}

void addInspectCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("inspect", "What a strategy builds for a scene: bytes, build time, nodes");
    auto options = std::make_shared<InspectOptions>();
    addSceneOptions(*command, options->scene);
    command->add_option("-s,--strategy", options->strategy, "strategy")->required();
    command->add_option("-p,--parameter", options->parameters, "parameter of the strategy: key=value")->allow_extra_args(false);
    command->add_option("--json", options->json, "result file; - is standard output");
    command->callback([options, &context] { runInspect(*options, context); });
}

void addPathCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("path", "Writes a built-in camera path as a file, for other programs");
    auto options = std::make_shared<PathOptions>();
    command->add_option("NAME", options->name, builtInPathNames())->required();
    addSceneOptions(*command, options->scene);
    auto* fovx = addFieldOption(*command, options->fovx);
    addProjectionOptions(*command, options->projection);
    command->add_option("--size", options->size, "WIDTHxHEIGHT of the pictures that --fovx is for")
        ->capture_default_str()
        ->needs(fovx);
    command->add_option("-o,--output", options->output, "file; - is standard output")->required();
    command->callback([options, &context] { runPath(*options, context); });
}

}  // namespace cullscope::cullbench
