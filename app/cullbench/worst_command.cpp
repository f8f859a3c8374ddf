#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/reports.h"
#include "core/gpu/context.h"
#include "core/image/page.h"
#include "core/image/picture_file.h"
#include "core/scene/tour.h"

namespace cullscope::cullbench {
namespace {

struct WorstOptions {
    SceneChoice scene;
    std::vector<std::string> strategies, parameters;
    std::string of = "missed", from, size = "320x240", json, svg, png, store;
    size_t views = 200;
    double distance = 3.0;
    int repeat = 3;
};

void checkPlaces(const WorstOptions& options) {
    const std::vector<std::string> files{options.json, options.svg, options.png};
    if (std::ranges::count(files, "-") > 1)
        throwUsage(CULLSCOPE_TR("Only one of --json, --svg and --png can go to standard output: name a file for the others."));
    checkOutputPlaces(files, options.store);
    if (!options.png.empty()) requirePictureFormat(options.png);
}

void findWorst(const WorstOptions& options, Context& context) {
    const std::vector<StrategyRequest> strategies = strategiesOf(options.strategies, options.parameters);
    if (strategies.size() != 1) throwUsage(CULLSCOPE_TR("The worst view is that of one strategy: -s names one."));
    worst::WorstRequest request;
    request.strategy = strategies.front();
    request.of = options.of == "ratio" ? worst::Of::Ratio : worst::Of::Missed;
    request.size = sizeFromText(options.size);
    request.views = options.views;
    request.distance = options.distance;
    request.repetitions = options.repeat;
    checkPlaces(options);
    const ReportKeeper keeper(options.store, context);
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    const HeadlessContext gl;
    requireAvailable(request.strategy, gl.info());
    request.scene = opened.scene;
    request.inside = options.from.empty() ? isStoodIn(*opened.scene) : options.from == "inside";
    const worst::WorstResult result = worst::worstView(request, terminalProgress(context));
    clearProgress();
    if (result.views.empty()) throwNothingMeasured();
    if (!options.json.empty()) writeText(options.json, worstJson(result));
    if (!options.svg.empty()) writeText(options.svg, linePlotsSvg({worstMap(result)}));
    if (!options.png.empty()) {
        const Letters letters(kPlotLetters);
        writePicture(options.png, pagePicture(linePlotsPage({worstMap(result)}, pageStyle(letters)), letters));
    }
    const bool data = options.json == "-" || options.svg == "-" || options.png == "-";
    printText(data ? stderr : stdout, worstText(result));
    if (result.interrupted) context.exitStatus = static_cast<int>(ErrorKind::Interrupted);
    keeper.keep(reportOf(result));
}

}  // namespace

void addWorstCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("worst", "The view in which a strategy loses most or gains least, found by search");
    auto options = std::make_shared<WorstOptions>();
    addSceneOptions(*command, options->scene);
    addStrategyOptions(*command, options->strategies, options->parameters);
    command->get_option("--strategy")->description("the strategy: A or A:key=value,key=value");
    command->add_option("--of", options->of, "missed: the largest share of missed pixels; ratio: the smallest gain of speed")
        ->check(CLI::IsMember({"missed", "ratio"}))
        ->capture_default_str();
    command->add_option("--from", options->from, "outside or inside (default: inside where one stands in the scene)")
        ->check(CLI::IsMember({"outside", "inside"}));
    command->add_option("--views", options->views, "how many views are tried at most")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command->add_option("--distance", options->distance, "from outside: of the eye, in radii of the scene's sphere")
        ->check(positiveNumber())
        ->capture_default_str();
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--repeat", options->repeat, "with --of ratio: repetitions of each frame")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command->add_option("--json", options->json, "the views, the worst ones as a camera path; - is standard output");
    command->add_option("--svg", options->svg, "the map; - is standard output");
    command->add_option("--png", options->png, "the map as a picture");
    addReportStoreOption(*command, options->store);
    command->callback([options, &context] { findWorst(*options, context); });
}

}  // namespace cullscope::cullbench
