#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "app/cullbench/tables.h"
#include "core/base/error.h"
#include "core/experiments/sweeps.h"
#include "core/experiments/trade_plot.h"
#include "core/gpu/context.h"

namespace cullscope::cullbench {
namespace {

struct SweepOptions {
    SceneChoice scene;
    RunOptions run;
    TableFiles files;
    std::vector<std::string> strategies, parameters, varied;
    std::string store;
    bool noLimit = false;
    std::string across = kUsualAcross, up = kUsualUp;
};

std::vector<std::string> valuesFromText(const std::string& text) {
    std::vector<std::string> values;
    if (text.empty()) return values;
    std::istringstream in(text + ",");
    for (std::string value; std::getline(in, value, ',');) {
        if (std::ranges::find(values, value) != values.end())
            throwUsage(CULLSCOPE_TR("%1: %2 is given twice."), {"--vary " + text, value});
        values.push_back(value);
    }
    return values;
}

/// The sweeps of `--vary [A.]key=v1,v2`: one of each strategy that it is meant for.
std::vector<ParameterSweep> sweepsOf(const std::string& text, const std::vector<StrategyRequest>& strategies) {
    const auto [name, values] = keyAndValue(text);
    const size_t dot = name.find('.');
    const std::string id = dot == std::string::npos ? "" : name.substr(0, dot);
    const std::string key = dot == std::string::npos ? name : name.substr(dot + 1);
    std::vector<ParameterSweep> sweeps;
    for (const StrategyRequest& strategy : strategies) {
        const std::vector<ParameterDeclaration>& declared = strategy.parameters.declarations();
        const bool has = std::ranges::find(declared, key, &ParameterDeclaration::key) != declared.end();
        // With one strategy, its own error lists its parameters.
        if (id.empty() ? has || strategies.size() == 1 : strategy.id == id)
            sweeps.push_back({strategyText(strategy), key, valuesFromText(values)});
    }
    if (sweeps.empty() && !id.empty())
        throwUsage(CULLSCOPE_TR("--vary %1: the strategy \"%2\" is not among those of -s."), {text, id});
    if (sweeps.empty()) throwUsage(CULLSCOPE_TR("--vary %1: none of the strategies has a parameter \"%2\"."), {text, key});
    if (sweeps.front().values.empty()) throwUsage(CULLSCOPE_TR("--vary %1: name values, as in %2=1,2,4."), {text, name});
    return sweeps;
}

/// Without `--vary`: the sweeps that the strategies declare.
std::vector<ParameterSweep> declaredSweeps(const std::vector<StrategyRequest>& strategies) {
    std::vector<ParameterSweep> sweeps;
    for (const StrategyRequest& strategy : strategies)
        for (ParameterSweep sweep : builtInSweeps())
            if (sweep.strategy == strategy.id) {
                sweep.strategy = strategyText(strategy);
                sweeps.push_back(std::move(sweep));
            }
    if (sweeps.empty())
        throwUsage(CULLSCOPE_TR("None of the strategies declares a sweep: say what to vary, as in --vary key=1,2,4."));
    return sweeps;
}

/// What no sweep varies is measured as it is.
Experiment experimentOf(const SweepOptions& options) {
    const std::vector<StrategyRequest> strategies = strategiesOf(options.strategies, options.parameters);
    std::vector<ParameterSweep> sweeps = options.varied.empty() ? declaredSweeps(strategies) : std::vector<ParameterSweep>();
    for (const std::string& text : options.varied)
        for (ParameterSweep& sweep : sweepsOf(text, strategies)) sweeps.push_back(std::move(sweep));
    std::vector<std::string> beside;
    for (const StrategyRequest& strategy : strategies)
        if (std::ranges::find(sweeps, strategyText(strategy), &ParameterSweep::strategy) == sweeps.end())
            beside.push_back(strategyText(strategy));
    return sweepExperiment(sweeps, beside);
}

/// Every file is tried.
void write(const SweepOptions& options, const std::vector<ResultTable>& tables, const TradePlot& trade) {
    std::vector<ResultTable> drawn = tables;
    LinePlot plot = trade.plot({});
    const bool usual = trade.across().key == kUsualAcross && trade.up().key == kUsualUp;
    plot.title = usual ? tables.front().title : fmt::format("{} by {}", trade.up().title, trade.across().title);
    drawn.front().plots = {std::move(plot)};
    std::optional<Error> failure;
    try {
        writeTables({{}, {}, options.files.svg, options.files.png}, drawn);
    } catch (const Error& error) {
        failure = error;
    }
    writeTables({options.files.json, options.files.csv, {}, {}}, tables);
    if (failure) throw *failure;
}

void run(const SweepOptions& options, Context& context) {
    // What can be wrong with the words is said before a long load.
    Experiment experiment = experimentOf(options);
    const TradeFigure &across = tradeFigure(options.across), &up = tradeFigure(options.up);
    Setting& setting = experiment.settings.front();
    setting.size = options.run.viewport();
    setting.windows = options.run.windows;
    setting.differentViews = options.run.windowViews == "different";
    setting.upload = options.run.uploadBy();
    setting.limitToo = !options.noLimit;
    checkTableFiles(options.files, {}, options.store);
    const std::unique_ptr<store::Recorder> recorder = recorderOf(options.store, "sweep", context);
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    const HeadlessContext gl;
    for (const StrategyRequest& strategy : requestsOf(setting)) requireAvailable(strategy, gl.info());
    setting.path = options.run.pathFor(*opened.scene);
    setting.views = [&](const Scene& scene) { return options.run.viewsOf(scene, {nullptr, context.stop}); };
    const ExperimentStage stage{[&](size_t, const Progress&) { return opened.scene; },
                                [&](const MeasureRequest& request, const Progress& progress) {
                                    return store::measureInto(recorder.get(), request, progress);
                                }};
    const std::vector<ResultTable> tables{
        runExperiment(experiment, {{}, options.run.repeat}, terminalProgress(context), {}, stage)};
    clearProgress();
    write(options, tables, TradePlot(tradePoints(tables.front()), across, up));
    context.exitStatus = tableStatus(tables);
    printText(tableOutput(options.files), tableText(tables.front()));
    requireRecorded(recorder);
}

}  // namespace

void addSweepCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("sweep", "Speed against losses over the values of parameters");
    auto options = std::make_shared<SweepOptions>();
    addSceneOptions(*command, options->scene);
    addStrategyOptions(*command, options->strategies, options->parameters);
    command->add_option("--vary", options->varied, "[A.]key=v1,v2,…; one a parameter (default: what the strategies declare)")
        ->allow_extra_args(false);
    addRunOptions(*command, options->run);
    addLimitOption(*command, options->noLimit);
    command->add_option("--json", options->files.json, "result file; - is standard output");
    command->add_option("--csv", options->files.csv, "result file with one row a value; - is standard output");
    command->add_option("--svg", options->files.svg,
                        "the plot of losses against speed, or of --y against --x; - is standard output");
    command->add_option("--png", options->files.png, "the same plot as a picture");
    command->add_option("--x", options->across, "figure across in the plot, by its name in the files")->capture_default_str();
    command->add_option("--y", options->up, "figure upwards in the plot, by its name in the files")->capture_default_str();
    addStoreOption(*command, options->store);
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
