#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/pairwise.h"
#include "core/gpu/context.h"

namespace cullscope::cullbench {
namespace {

struct RaceOptions {
    SceneChoice scene;
    RunOptions run;
    std::vector<std::string> strategies, parameters;
    std::string json, csv, store;
    bool noAccuracy = false;
};

void race(const RaceOptions& options, Context& context) {
    MeasureRequest request;
    request.strategies = strategiesOf(options.strategies, options.parameters);
    if (request.strategies.size() < 2 || request.strategies.size() > kMostRaced)
        throwUsage(CULLSCOPE_TR("A race takes 2 to %1 strategies; -s names %2."),
                   {std::to_string(kMostRaced), std::to_string(request.strategies.size())});
    request.size = options.run.viewport();
    request.windows = options.run.windows;
    request.differentViews = options.run.windowViews == "different";
    request.upload = options.run.uploadBy();
    request.timing.fixedRepetitions = options.run.repeat;
    request.accuracy = !options.noAccuracy;
    request.limitToo = true;
    if (options.json == "-" && options.csv == "-")
        throwUsage(CULLSCOPE_TR("--json and --csv cannot both go to standard output: name a file for one of them."));
    checkOutputPlaces({options.json, options.csv}, options.store);
    const std::unique_ptr<store::Recorder> recorder = recorderOf(options.store, "race", context);
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    const HeadlessContext gl;
    for (const StrategyRequest& strategy : request.strategies) requireAvailable(strategy, gl.info());
    request.scene = opened.scene;
    request.path = options.run.viewsOf(*opened.scene, {nullptr, context.stop});
    const MeasureResult result = store::measureInto(recorder.get(), request, terminalProgress(context));
    clearProgress();
    if (result.interrupted && result.runs.front().frames.empty()) throwNothingMeasured();
    if (!options.json.empty()) writeText(options.json, pairsJson(result));
    if (!options.csv.empty()) writeText(options.csv, pairsCsv(result));
    printText(options.json == "-" || options.csv == "-" ? stderr : stdout, pairsText(result));
    if (result.interrupted) context.exitStatus = static_cast<int>(ErrorKind::Interrupted);
    requireRecorded(recorder);
}

}  // namespace

void addRaceCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("race", "Up to eight strategies, each against each, with intervals");
    auto options = std::make_shared<RaceOptions>();
    addSceneOptions(*command, options->scene);
    addStrategyOptions(*command, options->strategies, options->parameters);
    addRunOptions(*command, options->run);
    command->add_flag("--no-accuracy", options->noAccuracy, "time only");
    command->add_option("--json", options->json, "result file: that of measure, and the pairs; - is standard output");
    command->add_option("--csv", options->csv, "result file with one row a pair; - is standard output");
    addStoreOption(*command, options->store);
    command->callback([options, &context] { race(*options, context); });
}

}  // namespace cullscope::cullbench
