#include <fmt/format.h>

#include <optional>

#include "app/cullbench/commands.h"
#include "core/base/error.h"
#include "core/experiments/paper_tables.h"
#include "core/gpu/context.h"
#include "core/image/line_plot.h"

namespace cullscope::cullbench {
namespace {

struct CommandOptions {
    std::string experiment, json, svg;
    int repeat = 0;
};

std::vector<const PaperExperiment*> chosen(const std::string& id) {
    std::vector<const PaperExperiment*> experiments;
    if (id != kAllExperiments) return {&findPaperExperiment(id)};
    for (const PaperExperiment& experiment : paperExperiments()) experiments.push_back(&experiment);
    return experiments;
}

/// Adds a table for each experiment; finished tables stay where a later experiment fails.
void reproduceAll(const std::vector<const PaperExperiment*>& experiments, const ReproduceOptions& options,
                  const Progress& progress, FILE* out, std::vector<PaperTable>& tables) {
    std::optional<HeadlessContext> gl;
    const double count = double(experiments.size());
    for (size_t i = 0; i < experiments.size() && (tables.empty() || !tables.back().interrupted); ++i) {
        if (experiments[i]->timed() && !gl) gl.emplace();
        tables.push_back(reproduce(*experiments[i], options, progress.part(double(i) / count, double(i + 1) / count)));
        clearProgress();
        // Each table is printed as soon as it is finished, because all of them take minutes.
        fmt::print(out, "{}{}", i > 0 ? "\n" : "", paperTableText(tables.back()));
        std::fflush(out);
    }
}

int statusOf(const std::vector<PaperTable>& tables) {
    int status = 0;
    for (const PaperTable& table : tables)
        for (const std::string& strategy : table.brokenPromises) {
            fmt::print(stderr, "cullbench: {}: {} promises to lose no pixel and lost some\n", table.experiment, strategy);
            status = 1;
        }
    return tables.back().interrupted ? static_cast<int>(ErrorKind::Interrupted) : status;
}

/// Throws Error(Usage) for a plot file where none of the experiments has a plot.
void checkPlots(const std::vector<const PaperExperiment*>& experiments) {
    const auto has = [](const PaperExperiment& experiment) { return !experiment.plots.empty(); };
    if (std::any_of(experiments.begin(), experiments.end(), [&](const PaperExperiment* each) { return has(*each); })) return;
    std::string known;
    for (const PaperExperiment& experiment : paperExperiments())
        if (has(experiment)) known += (known.empty() ? "" : ", ") + experiment.id;
    throwUsage(CULLSCOPE_TR("--svg: %1 has a table and no plot. With a plot: %2."), {experiments.front()->id, known});
}

void checkOutputs(const CommandOptions& options, const std::vector<const PaperExperiment*>& experiments) {
    if (!options.svg.empty()) checkPlots(experiments);
    if (options.json == "-" && options.svg == "-")
        throwUsage(CULLSCOPE_TR("--json and --svg cannot both go to standard output: name a file for one of them."));
    checkOutputPlaces({options.json, options.svg});
}

std::vector<LinePlot> plotsOf(const std::vector<PaperTable>& tables) {
    std::vector<LinePlot> plots;
    for (const PaperTable& table : tables) plots.insert(plots.end(), table.plots.begin(), table.plots.end());
    return plots;
}

/// Every file is tried, so that one that cannot be written does not cost the other.
void write(const CommandOptions& options, const std::vector<PaperTable>& tables) {
    std::optional<Error> failure;
    const auto writeTo = [&](const std::string& path, const auto& textOf) {
        if (path.empty()) return;
        try {
            writeText(path, textOf());
        } catch (const Error& error) {
            failure = error;
        }
    };
    writeTo(options.json, [&] { return paperTablesJson(tables); });
    if (const std::vector<LinePlot> plots = plotsOf(tables); !plots.empty())
        writeTo(options.svg, [&] { return linePlotsSvg(plots); });
    if (failure) throw *failure;
}

void run(const CommandOptions& options, Context& context) {
    const std::vector<const PaperExperiment*> experiments = chosen(options.experiment);
    checkOutputs(options, experiments);
    // Where standard output carries data, the tables go to standard error.
    FILE* out = options.json == "-" || options.svg == "-" ? stderr : stdout;
    std::vector<PaperTable> tables;
    std::optional<Error> failure;
    try {
        reproduceAll(experiments, {context.sceneOptions, options.repeat}, terminalProgress(context), out, tables);
    } catch (const Error& error) {
        failure = error;
    }
    if (!tables.empty()) write(options, tables);
    if (failure) throw *failure;
    context.exitStatus = statusOf(tables);
}

}  // namespace

void addReproduceCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("reproduce", "A paper's table beside the same measured here");
    auto options = std::make_shared<CommandOptions>();
    command->add_option("EXPERIMENT", options->experiment, "one of `cullbench list experiments`, or all")->required();
    command->add_option("--repeat", options->repeat, "repetitions of each frame (default: until the median is steady)")
        ->check(CLI::Range(1, 100000));
    command->add_option("--json", options->json, "result file; - is standard output");
    command->add_option("--svg", options->svg, "the plots of experiments that have one; - is standard output");
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
