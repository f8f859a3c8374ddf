#include <map>
#include <optional>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/reports.h"
#include "core/experiments/suite/suite.h"
#include "core/gpu/context.h"
#include "core/visibility/facing.h"

namespace cullscope::cullbench {
namespace {

constexpr Viewport kUsualSize{640, 480};

struct JudgeOptions {
    SceneChoice scene;
    std::string path, drawn, json, size, facing = "two-sided", store;
};

void judge(const JudgeOptions& options, Context& context) {
    const std::optional<Viewport> asked = options.size.empty() ? std::nullopt : std::optional(sizeFromText(options.size));
    checkOutputPlaces({options.json}, options.store);
    const ReportKeeper keeper(options.store, context);
    suite::JudgeRequest request;
    request.scene = openSceneForCommand(options.scene, context).scene;
    request.drawn = readDrawnSets(options.drawn, *request.scene);
    if (options.path.empty() && request.drawn.path.poses.empty())
        throwUsage(CULLSCOPE_TR("%1 has no cameras: name the camera path with --path."), {options.drawn});
    request.path = options.path.empty() ? request.drawn.path : cameraPath(options.path, *request.scene, {nullptr, context.stop});
    // Who hands out the cameras says how large the pictures are: in smaller ones less is seen.
    const std::optional<Viewport> stated = options.path.empty() ? request.drawn.size : pictureSizeIn(options.path);
    request.size = asked ? *asked : stated.value_or(kUsualSize);
    const std::map<std::string, Facing> rules{
        {"two-sided", Facing::TwoSided}, {"front", Facing::Front}, {"auto", facingByObject(*request.scene)}};
    request.facing = rules.at(options.facing);
    const HeadlessContext gl;
    Renderer renderer;
    const suite::Judgement judgement = suite::judgeDrawn(request, renderer, terminalProgress(context));
    clearProgress();
    // Cameras of the judged file itself that see nothing show nothing of it.
    const bool seen = judgement.kind() != suite::CullingKind::Unseen || !options.path.empty();
    context.exitStatus = judgement.right() && seen ? 0 : 1;
    if (!options.json.empty()) writeText(options.json, suite::judgementJson(judgement, request, gl.info()));
    printText(options.json == "-" ? stderr : stdout, suite::judgementText(judgement, request));
    keeper.keep(reportOf(judgement, request, gl.info()));
}

void write(const std::string& folder, Context& context) {
    const HeadlessContext gl;
    Renderer renderer;
    const std::vector<suite::WrittenScene> written =
        suite::writeSuite(folder, suite::suiteScenes(), renderer, terminalProgress(context));
    clearProgress();
    for (const suite::WrittenScene& scene : written)
        say("{:<24} {:>7} triangles in {:>5} objects, {:>3} poses: {} visible triangles are required\n", scene.name,
            scene.triangles, scene.objects, scene.poses, scene.visibleTriangles);
}

}  // namespace

void addJudgeCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("judge", "Judges what another program says that it draws");
    auto options = std::make_shared<JudgeOptions>();
    addSceneOptions(*command, options->scene);
    command->add_option("--drawn", options->drawn, "what is drawn at each pose (docs/files.md)")->required();
    command->add_option("--path", options->path, "camera path: file or built-in name (default: the cameras beside the sets)");
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels (default: that beside the cameras, else 640x480)");
    command->add_option("--facing", options->facing, "which faces the program draws: two-sided, front, auto")
        ->check(CLI::IsMember({"two-sided", "front", "auto"}))
        ->capture_default_str();
    command->add_option("--json", options->json, "result file; - is standard output");
    addReportStoreOption(*command, options->store);
    command->callback([options, &context] { judge(*options, context); });
}

void addSuiteCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("suite", "Writes scenes, cameras and what must be drawn as plain files");
    auto folder = std::make_shared<std::string>();
    command->add_option("DIR", *folder, "folder, which is made where it is missing")->required();
    command->callback([folder, &context] { write(*folder, context); });
}

}  // namespace cullscope::cullbench
