#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/reports.h"
#include "core/experiments/store/comparison.h"

namespace cullscope::cullbench {
namespace {

struct StoreOptions {
    std::string file;
    store::Filter filter;
    int64_t number = 0;
    std::string a, b, json, csv, svg;
    std::vector<std::string> files;
};

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

std::string stateOf(const store::Listed& listed) {
    if (listed.poses == 0) return "figures";
    if (!listed.interrupted) return "whole";
    return fmt::format("{} of {} poses{}", listed.measured, listed.poses, listed.ended ? "" : ", no end");
}

void list(const StoreOptions& options) {
    const store::ResultStore opened(options.file, store::Database::Access::Existing);
    const std::vector<store::Listed> all = opened.list(options.filter);
    say("{:>6}  {:<24} {:<14} {:<22} {:<24} {:<14} {:>9}  {}\n", "number", "started (UTC)", "experiment", "measured", "scene",
        "path", "size", "strategies");
    for (const store::Listed& each : all)
        say("{:>6}  {:<24} {:<14} {:<22} {:<24} {:<14} {:>9}  {}\n", each.number, each.started, each.origin.experiment,
            stateOf(each), each.scene, each.path, fmt::format("{}x{}", each.size.width, each.size.height),
            joined(each.strategies));
    const std::vector<store::StoredReport> reports = opened.reports(options.filter);
    if (reports.empty()) return;
    say("\n{:>6}  {:<24} {:<14} {:<24} {}\n", "report", "added (UTC)", "kind", "scene", "strategy");
    for (const store::StoredReport& each : reports)
        say("{:>6}  {:<24} {:<14} {:<24} {}\n", each.number, each.added, each.report.kind,
            each.report.scene.empty() ? "-" : each.report.scene, each.report.strategy.empty() ? "-" : each.report.strategy);
}

std::string interval(const RatioEstimate& estimate) {
    if (estimate.ratio == 0.0) return "-";
    if (!estimate.hasInterval) return fmt::format("{:.2f}", estimate.ratio);
    return fmt::format("{:.2f} [{:.2f},{:.2f}]", estimate.ratio, estimate.ci95[0], estimate.ci95[1]);
}

std::string lostText(const std::optional<Losses>& losses) {
    if (!losses) return "-";
    return std::to_string(losses->beyondSnapping ? losses->missedBeyondSnapping : losses->missedPixels);
}

void show(const StoreOptions& options) {
    const store::Stored stored = store::ResultStore(options.file, store::Database::Access::Existing).read(options.number);
    const store::Listed& listed = stored.listed;
    say("{}: {}, {}\n", listed.number, listed.started, stateOf(listed));
    if (!listed.origin.command.empty()) say("{}\n", listed.origin.command);
    if (!listed.tool.version.empty()) say("{} {} ({})\n", listed.tool.name, listed.tool.version, listed.tool.commit);
    if (!listed.cpu.empty())
        say("{}, {}{}\n", listed.cpu, listed.gl.renderer, listed.gl.software ? " (software OpenGL: times are not a GPU's)" : "");
    if (!listed.sceneSha256.empty())
        say("{}: {} triangles in {} objects, sha256 {}\n", listed.scene, listed.triangles, listed.instances, listed.sceneSha256);
    say("{:<32} {:<12} {:>6} {:>9} {:>9} {:>19} {:>17} {:>10} {:>22}\n", "strategy", "promise", "poses", "median ms", "fps",
        "x same sides [95 %]", "x all [95 %]", "missed px", "of the headroom [95 %]");
    for (const store::StoredRun& run : stored.runs) {
        if (run.old) {
            say("{:<32} {:<12} {:>6} {:>9} {:>9} {:>19} {:>17} {:>10} {:>22}\n", run.strategy, "-", "-", "-", "-",
                run.old->ratio ? interval(*run.old->ratio) : "-", "-",
                run.old->missedPpm ? fmt::format("{:.3g} ppm", *run.old->missedPpm) : "-", "-");
            continue;
        }
        if (!run.askedFor && !run.isLimit) continue;
        const Summary& summary = run.run.summary;
        say("{:<32} {:<12} {:>6} {:>9.3f} {:>9.2f} {:>19} {:>17} {:>10} {:>22}\n", run.strategy, promiseId(run.run.promise),
            run.frames.size(), summary.frameMillisecondsMedian, summary.fpsOverall, interval(summary.ratioToOwnRule),
            interval(summary.ratioToTriangles), lostText(run.run.losses()),
            summary.headroomShare ? interval(*summary.headroomShare) : "-");
    }
}

void showReport(const StoreOptions& options) {
    checkOutputPlaces({options.json});
    const store::StoredReport stored = store::ResultStore(options.file, store::Database::Access::Existing).report(options.number);
    if (!options.json.empty()) writeText(options.json, stored.report.document);
    std::FILE* const out = options.json == "-" ? stderr : stdout;
    say(out, "report {}: {}, {}\n", stored.number, stored.report.kind, stored.added);
    if (!stored.report.command.empty()) say(out, "{}\n", stored.report.command);
    printText(out, stored.report.words.empty() ? stored.report.document : stored.report.words);
}

void compareSides(const StoreOptions& options) {
    const store::ResultStore opened(options.file, store::Database::Access::Existing);
    const std::vector<store::Compared> all = store::compared(opened, options.a, options.b);
    say("{:<28} {:<28} {:>6} {:>9} {:>9} {:>20} {:>10} {:>10}  {}\n", "A", "B", "poses", "mean ms A", "mean ms B",
        "x of B to A [95 %]", "A missed", "B missed", "verdict");
    for (const store::Compared& each : all)
        say("{:<28} {:<28} {:>6} {:>9.3f} {:>9.3f} {:>20} {:>10} {:>10}  {}\n", each.a, each.b, each.poses, each.msOfA,
            each.msOfB, interval(each.ratio), lostText(each.lostByA), lostText(each.lostByB), store::verdict(each).english());
    if (std::ranges::none_of(all, &store::Compared::inTurns))
        say("A and B were measured one after the other: what else the machine did then is not in the intervals.\n");
}

void exportStored(const StoreOptions& options) {
    if (options.json.empty() && options.csv.empty() && options.svg.empty())
        throwUsage(CULLSCOPE_TR("Name a file with --json, --csv or --svg."));
    if (std::ranges::count(std::array{options.json, options.csv, options.svg}, std::string("-")) > 1)
        throwUsage(CULLSCOPE_TR("Only one of the files can go to standard output: name the others."));
    checkOutputPlaces({options.json, options.csv, options.svg});
    const store::ResultStore opened(options.file, store::Database::Access::Existing);
    std::vector<store::Stored> all;
    if (options.number > 0)
        all.push_back(opened.read(options.number));
    else
        for (const store::Listed& each : opened.list(options.filter)) all.push_back(opened.read(each.number));
    if (!options.json.empty())
        writeText(options.json,
                  options.number > 0 ? store::storedJson(all.front()) : store::storedJson(all, opened.reports(options.filter)));
    if (!options.csv.empty()) writeText(options.csv, store::storedCsv(all));
    if (!options.svg.empty()) {
        std::vector<LinePlot> plots;
        for (const store::Stored& each : all) plots.push_back(store::framePlot(each));
        writeText(options.svg, linePlotsSvg(plots));
    }
}

void sayAdded(const store::Added& added, const std::string& file) {
    say("{} {}: {}{}\n", added.kind.empty() ? "measurement" : added.kind, added.number, file,
        added.isNew ? "" : " (it was there already)");
}

/// When a file was written, as a store has times: result files do not say when they were measured.
std::string timeOf(const std::string& file) {
    const auto written = std::chrono::file_clock::to_sys(std::filesystem::last_write_time(file));
    return store::timeText(std::chrono::floor<std::chrono::milliseconds>(written));
}

/// A store is told by SQLite's first words, a certificate by its first field.
void addFile(const store::ResultStore& opened, const std::string& file, const std::string& command) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throwInput(CULLSCOPE_TR("%1 cannot be opened: check the name and that you may read it."), {file});
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (text.starts_with("SQLite format 3")) {
        for (const store::Added& added : opened.addAll(store::ResultStore(file, store::Database::Access::Existing)))
            sayAdded(added, file);
        return;
    }
    constexpr size_t kFirstField = 40;
    if (text.substr(0, kFirstField).find("\"certificate\"") != std::string::npos) {
        for (const certify::Certificate& certificate : certify::readCertificates(file))
            sayAdded(opened.add(reportOf(certificate)), file);
        return;
    }
    sayAdded(opened.addFile(text, file, {"measure", command}, timeOf(file)), file);
}

void add(const StoreOptions& options, const Context& context) {
    const store::ResultStore opened(options.file);
    for (const std::string& file : options.files) addFile(opened, file, context.command);
}

/// Of a "measurement" or a "report".
CLI::Validator numberInList(const std::string& what) {
    return {[what](std::string& text) {
                int64_t number = 0;
                const char* const end = text.data() + text.size();
                const auto [read, failure] = std::from_chars(text.data(), end, number);
                return failure == std::errc() && read == end && number >= 1
                           ? std::string()
                           : "\"" + text + "\" is no number of a " + what + ", as in 3 (cullbench store FILE list)";
            },
            ""};
}

/// 2026, 2026-11 or 2026-11-25.
CLI::Validator beginOfDate() {
    return {
        [](std::string& text) {
            constexpr std::string_view kPattern = "dddd-dd-dd";
            bool fits = text.size() == 4 || text.size() == 7 || text.size() == 10;
            for (size_t i = 0; fits && i < text.size(); ++i)
                fits = kPattern[i] == '-' ? text[i] == '-' : text[i] >= '0' && text[i] <= '9';
            if (fits) {
                // The earliest day that the text may mean.
                const std::string day = text + std::string("-01-01").substr(text.size() == 4 ? 0 : text.size() == 7 ? 3 : 6);
                const auto part = [&](size_t from, size_t count) { return std::stoi(day.substr(from, count)); };
                using namespace std::chrono;
                fits = year_month_day(year(part(0, 4)), month(unsigned(part(5, 2))), std::chrono::day(unsigned(part(8, 2)))).ok();
            }
            return fits ? std::string() : "\"" + text + "\" is no date as 2026, 2026-11 or 2026-11-25";
        },
        ""};
}

void addFilterOptions(CLI::App& command, store::Filter& filter) {
    command.add_option("--scene", filter.scene, "only scenes with this in their name");
    command.add_option("-s,--strategy", filter.strategy, "only measurements of a strategy with this in its text");
    command.add_option("--since", filter.since, "from this date on: 2026, 2026-11 or 2026-11-25")->check(beginOfDate());
    command.add_option("--until", filter.until, "up to this date, which is included")->check(beginOfDate());
}

}  // namespace

void addStoreCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("store", "What measurements a result store has, compared and exported");
    auto options = std::make_shared<StoreOptions>();
    command->add_option("FILE", options->file, "result store, as --store made it")->required();
    command->require_subcommand(0, 1);
    command->allow_extras();
    command->fallthrough(false);
    command->callback([command] {
        if (!command->get_subcommands().empty()) return;
        const std::vector<std::string> words = command->remaining();
        if (words.empty()) throwUsage(CULLSCOPE_TR("Say what to do with the store: list, show, report, compare, export or add."));
        throwUsage(CULLSCOPE_TR("\"%1\" is nothing that can be done with a store: list, show, report, compare, export, add."),
                   {words.front()});
    });

    CLI::App* lists = command->add_subcommand("list", "Its measurements and reports");
    addFilterOptions(*lists, options->filter);
    lists->callback([options] { list(*options); });

    CLI::App* shows = command->add_subcommand("show", "One measurement: where, how, and each strategy's figures");
    shows->add_option("NUMBER", options->number, "of the measurement")->required()->check(numberInList("measurement"));
    shows->callback([options] { show(*options); });

    CLI::App* reports = command->add_subcommand("report", "One report: certificate, advice, worst view, battery or judgement");
    reports->add_option("NUMBER", options->number, "of the report")->required()->check(numberInList("report"));
    reports->add_option("--json", options->json, "its result file; - is standard output");
    reports->callback([options] { showReport(*options); });

    CLI::App* compares = command->add_subcommand("compare", "How many times as fast B is as A, and what each one lost");
    compares->add_option("A", options->a, "measurement, as 3, or a strategy of it, as 3:frustum")->required();
    compares->add_option("B", options->b, "likewise")->required();
    compares->callback([options] { compareSides(*options); });

    CLI::App* exports =
        command->add_subcommand("export", "Measurements as JSON and CSV, as measure writes them; reports as JSON");
    exports->add_option("NUMBER", options->number, "of a measurement (default: all that the filter leaves)")
        ->check(numberInList("measurement"));
    addFilterOptions(*exports, options->filter);
    exports->add_option("--json", options->json, "result file; - is standard output");
    exports->add_option("--csv", options->csv, "result file with one row a frame; - is standard output");
    exports->add_option("--svg", options->svg, "the time of a frame by pose, a plot for each measurement");
    exports->callback([options] { exportStored(*options); });

    CLI::App* adds = command->add_subcommand("add", "Adds result files of measure, certificates and other stores");
    adds->add_option("RESULT", options->files, "JSON files and result stores")->required();
    adds->callback([options, &context] { add(*options, context); });
}

}  // namespace cullscope::cullbench
