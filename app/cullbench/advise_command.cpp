#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/reports.h"
#include "core/gpu/context.h"

namespace cullscope::cullbench {
namespace {

struct AdviseOptions {
    SceneChoice scene;
    RunOptions run;
    double maxMissed = 0.0, buildLimit = 0.0;
    std::string json, svg, store;
};

void adviseOn(const AdviseOptions& options, Context& context) {
    advice::AdviseRequest request;
    request.size = options.run.viewport();
    request.upload = options.run.uploadBy();
    request.maxMissed = options.maxMissed;
    request.buildSeconds = options.buildLimit;
    if (options.json == "-" && options.svg == "-")
        throwUsage(CULLSCOPE_TR("--json and --svg cannot both go to standard output: name a file for one of them."));
    checkOutputPlaces({options.json, options.svg}, options.store);
    const ReportKeeper keeper(options.store, context);
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    const HeadlessContext gl;
    request.scene = opened.scene;
    request.path = options.run.viewsOf(*opened.scene, {nullptr, context.stop});
    const advice::Advice advice = advice::advise(request, terminalProgress(context));
    clearProgress();
    if (advice.interrupted && !advice.best) throwNothingMeasured();
    if (!options.json.empty()) writeText(options.json, adviceJson(advice));
    if (!options.svg.empty()) {
        std::vector<TradePoint> points;
        for (const advice::AdvisedStrategy* strategy : pictured(advice)) points.push_back(tradePoint(*strategy));
        writeText(options.svg, linePlotsSvg({TradePlot(points, tradeFigure("ratio_to_all"), tradeFigure(kUsualUp)).plot({})}));
    }
    printText(options.json == "-" || options.svg == "-" ? stderr : stdout, adviceText(advice));
    if (advice.interrupted) context.exitStatus = static_cast<int>(ErrorKind::Interrupted);
    keeper.keep(reportOf(advice));
}

}  // namespace

void addAdviseCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("advise", "Which strategy suits a scene, what it would lose, and what it costs");
    auto options = std::make_shared<AdviseOptions>();
    addSceneOptions(*command, options->scene);
    addViewOptions(*command, options->run);
    command->add_option("--upload", options->run.upload, "vbo or vertex-array")
        ->check(CLI::IsMember({"vbo", "vertex-array"}))
        ->capture_default_str();
    command
        ->add_option("--max-missed", options->maxMissed,
                     "share of the covered pixels that may be lost, as in 1e-4 (default 0: only what promises to lose nothing)")
        ->check(numberBetween(0.0, 1.0));
    command
        ->add_option(
            "--build-limit", options->buildLimit,
            "seconds after which building a structure ends (default: 100 frames of the fastest so far, at least half a second)")
        ->check(positiveNumber());
    command->add_option("--json", options->json, "result file; - is standard output");
    command->add_option("--svg", options->svg, "the plot of speed against losses; - is standard output");
    addReportStoreOption(*command, options->store);
    command->callback([options, &context] { adviseOn(*options, context); });
}

}  // namespace cullscope::cullbench
