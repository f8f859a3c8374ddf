#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/cullbench/commands.h"
#include "app/cullbench/language.h"
#include "app/cullbench/output.h"
#include "app/cullbench/tables.h"
#include "core/base/error.h"
#include "core/experiments/experiment_list.h"
#include "core/experiments/han_hong_figures.h"
#include "core/experiments/han_hong_rows.h"
#include "core/experiments/reproduction_report.h"
#include "core/gpu/context.h"
#include "core/image/drawing_svg.h"

namespace cullscope::cullbench {
namespace {

struct CommandOptions {
    std::string experiment;
    std::string scene;  ///< in place of the experiment's own; empty: its own
    TableFiles files;
    int repeat = 0;
    std::string store, report;
};

/// The experiments that take a scene of the user's, as a list in words.
std::string thoseWithAScene() {
    std::string known;
    for (const Experiment& experiment : knownExperiments())
        if (experiment.ofScene) known += (known.empty() ? "" : ", ") + experiment.id;
    return known;
}

/// An experiment with a scene of the user's.
Experiment ofScene(const std::string& id, const std::string& scene) {
    if (id != kAllExperiments && findExperiment(id).ofScene) return findExperiment(id).ofScene(scene);
    throwUsage(CULLSCOPE_TR("%1 has scenes of its own and takes no other one. Taking one: %2."), {id, thoseWithAScene()});
}

std::vector<const Experiment*> chosen(const std::string& id) {
    std::vector<const Experiment*> experiments;
    if (id != kAllExperiments) return {&findExperiment(id)};
    for (const Experiment& experiment : knownExperiments()) experiments.push_back(&experiment);
    return experiments;
}

/// Each table is printed as soon as it is finished, because all of them take minutes. Where the reader has ended, the experiments
/// go on for the files alone; without files, ReaderGone ends them.
class TablePrinter {
public:
    TablePrinter(const TableFiles& files, bool report)
        : m_out(tableOutput(files)),
          m_forFiles(report || !files.json.empty() || !files.csv.empty() || !files.svg.empty() || !files.png.empty()) {}

    void print(const ResultTable& table) {
        if (m_readerGone) return;
        try {
            printText(m_out, (m_first ? "" : "\n") + tableText(table));
            if (m_out == stdout) flushOutput();
        } catch (const ReaderGone&) {
            if (!m_forFiles) throw;
            m_readerGone = true;
        }
        m_first = false;
    }

private:
    FILE* m_out;
    bool m_forFiles;
    bool m_first = true, m_readerGone = false;
};

/// The report of --output, written anew after every table and figure: what is done is kept whatever ends the program.
class ReportWriter {
public:
    ReportWriter(const CommandOptions& options, const Context& context) : m_options(options), m_context(context) {
        const std::string now = store::timeText();  // 2026-11-25T16:50:46.123Z
        m_report.started = now.substr(0, 10) + " " + now.substr(11, 5) + " UTC";
        m_report.command = context.command;
        m_report.complete = false;
    }

    void add(const ResultTable& table) {
        std::vector<std::string> words{"reproduce", table.experiment};
        if (!m_options.scene.empty()) words.push_back(m_options.scene);
        if (m_options.repeat > 0) words.insert(words.end(), {"--repeat", std::to_string(m_options.repeat)});
        m_report.tables.push_back({table, command(words)});
        write();
    }
    void addFailure(const Message& why) {
        m_report.missing.push_back(why);
        write();
    }
    /// The figures of Han & Hong, of the paper's own mesh.
    void addFigures() {
        if (m_options.report.empty() || m_context.stop.stop_requested()) return;
        try {
            const OpenedScene opened = openScene(han_hong::kBunny, m_context.sceneOptions, {nullptr, m_context.stop});
            std::optional<HeadlessContext> gl;
            if (!hasCurrentContext()) gl.emplace();
            for (int number = 1; number <= han_hong::kFigures; ++number) addFigure(number, opened.scene);
        } catch (const Error& error) {
            addFailure(error.message());
        }
    }
    void complete() {
        m_report.complete = true;
        write();
    }

private:
    void addFigure(int number, const ScenePointer& scene) {
        PageLook look;
        look.style = svgStyle();
        look.say = [catalogue = Catalogue("en")](const Words& words) { return catalogue.say(words); };
        const han_hong::Figure figure = han_hong::figure(han_hong::figureRequest(number, scene), look, {nullptr, m_context.stop});
        m_report.figures.push_back({han_hong::figureTitle(number), figure.data.source, pageSvg(figure.page),
                                    command({"figure", std::to_string(number), "-o", fmt::format("figure-{}.svg", number)})});
        write();
    }
    /// That finds the models which this one finds.
    [[nodiscard]] std::string command(const std::vector<std::string>& words) const {
        std::vector<std::string> all;
        for (const std::filesystem::path& folder : m_context.sceneOptions.modelFolders)
            all.insert(all.end(), {"--models", folder.string()});
        all.insert(all.end(), words.begin(), words.end());
        return commandLine(all);
    }
    /// Before the first table there is nothing that could stand in the place of an older report.
    void write() const {
        if (!m_options.report.empty() && hasRows()) writeText(m_options.report, reproductionHtml(m_report));
    }

    [[nodiscard]] bool hasRows() const {
        return std::ranges::any_of(m_report.tables, [](const ReportedTable& each) { return !each.table.rows.empty(); });
    }

    const CommandOptions& m_options;
    const Context& m_context;
    ReproductionReport m_report;
};

/// Adds a table for each experiment; finished tables stay where a later experiment fails.
void reproduceAll(const std::vector<const Experiment*>& experiments, const ExperimentOptions& options, const Progress& progress,
                  TablePrinter& printer, store::Recorder* recorder, ReportWriter& report, std::vector<ResultTable>& tables) {
    std::optional<HeadlessContext> gl;
    MeasuredScene shared;
    ExperimentStage stage;
    stage.measure = [&](const MeasureRequest& request, const Progress& measuring) {
        return store::measureInto(recorder, request, measuring, &shared);
    };
    const double count = double(experiments.size());
    for (size_t i = 0; i < experiments.size() && (tables.empty() || !tables.back().interrupted); ++i) {
        if (experiments[i]->needsOpenGl() && !gl) gl.emplace();
        if (recorder != nullptr) recorder->setExperiment(experiments[i]->id);
        tables.push_back(
            runExperiment(*experiments[i], options, progress.part(double(i) / count, double(i + 1) / count), {}, stage));
        clearProgress();
        report.add(tables.back());
        printer.print(tables.back());
    }
    if (experiments.size() > 1) report.addFigures();
    if (!tables.back().interrupted) report.complete();
}

/// Throws Error(Usage) for a plot file where none of the experiments has a plot.
void checkPlots(const char* option, const std::vector<const Experiment*>& experiments) {
    const auto has = [](const Experiment& experiment) { return !experiment.plots.empty(); };
    if (std::any_of(experiments.begin(), experiments.end(), [&](const Experiment* each) { return has(*each); })) return;
    std::string known;
    for (const Experiment& experiment : knownExperiments())
        if (has(experiment)) known += (known.empty() ? "" : ", ") + experiment.id;
    throwUsage(CULLSCOPE_TR("%1: %2 has a table and no plot. With a plot: %3."), {option, experiments.front()->id, known});
}

void run(const CommandOptions& options, Context& context) {
    std::optional<Experiment> own;
    if (!options.scene.empty()) own = ofScene(options.experiment, options.scene);
    const std::vector<const Experiment*> experiments = own ? std::vector<const Experiment*>{&*own} : chosen(options.experiment);
    for (const auto& [option, file] : {std::pair("--svg", options.files.svg), std::pair("--png", options.files.png)})
        if (!file.empty()) checkPlots(option, experiments);
    if (!options.files.csv.empty() && experiments.size() > 1)
        throwUsage(CULLSCOPE_TR("--csv has the rows of one experiment: name it in place of %1."), {options.experiment});
    checkTableFiles(options.files, {options.report}, options.store);
    if (options.report == "-") throwUsage(CULLSCOPE_TR("The report is written anew after every table: name a file with -o."));
    const std::unique_ptr<store::Recorder> recorder = recorderOf(options.store, options.experiment, context);
    std::vector<ResultTable> tables;
    std::optional<Error> failure;
    ReportWriter report(options, context);
    TablePrinter printer(options.files, !options.report.empty());
    try {
        reproduceAll(experiments, {context.sceneOptions, options.repeat}, terminalProgress(context), printer, recorder.get(),
                     report, tables);
    } catch (const Error& error) {
        failure = error;
        report.addFailure(error.message());
    }
    if (!tables.empty()) writeTables(options.files, tables);
    if (failure) throw *failure;
    context.exitStatus = tableStatus(tables);
    requireRecorded(recorder);
    if (recorder && !recorder->newest())
        say(stderr, "cullbench: {} times no frames: nothing of it is in {}\n", options.experiment, options.store);
}

}  // namespace

void addReproduceCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("reproduce", "A paper's table beside the same measured here");
    auto options = std::make_shared<CommandOptions>();
    command->add_option("EXPERIMENT", options->experiment, "one of `cullbench list experiments`, or all")->required();
    command->add_option("--scene,SCENE", options->scene,
                        "a scene of yours in place of the experiment's own, where that takes one: " + thoseWithAScene());
    command->add_option("--repeat", options->repeat, "repetitions of each frame (default: until the median is steady)")
        ->check(CLI::Range(1, 100000));
    command->add_option("--json", options->files.json, "result file; - is standard output");
    command->add_option("--csv", options->files.csv, "result file with the rows of one experiment; - is standard output");
    command->add_option("--svg", options->files.svg, "the plots of experiments that have one; - is standard output");
    command->add_option("--png", options->files.png, "the same as one picture: .png, .jpg or .tif; - is standard output (PNG)");
    command->add_option("-o,--output", options->report,
                        "report: tables, plots and figures beside the sources' own as one HTML page, with the commands");
    addStoreOption(*command, options->store);
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
