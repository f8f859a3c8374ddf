#include <fmt/format.h>

#include <optional>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/error.h"
#include "core/experiments/result_file.h"
#include "core/gpu/context.h"
#include "core/measure/field_figures.h"

namespace cullscope::cullbench {
namespace {

struct MeasureOptions {
    SceneChoice scene;
    RunOptions run;
    std::string json, csv, store;
    std::vector<std::string> strategies, parameters;
    bool noAccuracy = false, noLimit = false;
};

/// Of the scene's triangles, mean over the poses; empty for a strategy that leaves nothing out for a cause but the frustum, of
/// which the table says all.
std::string culledByCause(const RunMeasurement& run, const Scene& scene) {
    std::array<double, kCauseCount> sums{};
    for (const FrameMeasurement& frame : run.frames)
        for (size_t cause = 0; cause < kCauseCount; ++cause) sums[cause] += double(frame.culledTriangles[cause]);
    std::string text;
    bool others = false;
    for (size_t cause = 0; cause < kCauseCount; ++cause) {
        if (sums[cause] == 0.0) continue;
        others = others || static_cast<Cause>(cause) != Cause::OutsideFrustum;
        const double share = sums[cause] / (double(run.frames.size()) * double(scene.triangleCount()));
        text += fmt::format("{}{} {:.1f} %", text.empty() ? "" : ", ", causeName(static_cast<Cause>(cause)), 100.0 * share);
    }
    return others ? text : std::string();
}

/// The number of poses in which each of a strategy's tests was used for some object: "a in 16 of 16 poses, b in 3, c in none";
/// empty for a strategy with a single test.
std::string usedParts(const RunMeasurement& run) {
    std::string text;
    if (run.frames.empty()) return text;
    for (size_t part = 0; part < run.frames.front().parts.size(); ++part) {
        const auto uses = [&](const FrameMeasurement& frame) { return frame.parts[part].objects > 0; };
        const auto poses = std::count_if(run.frames.begin(), run.frames.end(), uses);
        const std::string times = poses > 0 ? std::to_string(poses) : std::string("none");
        text += fmt::format("{}{} in {}{}", text.empty() ? "" : ", ", run.frames.front().parts[part].name, times,
                            text.empty() ? fmt::format(" of {} poses", run.frames.size()) : "");
    }
    return text;
}

std::string ratioText(const RatioEstimate& estimate) {
    if (!estimate.hasInterval) return fmt::format("{:.2f}", estimate.ratio);
    return fmt::format("{:.2f} [{:.2f},{:.2f}]", estimate.ratio, estimate.ci95[0], estimate.ci95[1]);
}

/// What the intervals of frames that were drawn once do not say; empty where frames were repeated.
std::string withoutRepetitions(const MeasureResult& result) {
    const auto once = [](const RunMeasurement& run) {
        return std::ranges::all_of(run.frames, [](const FrameMeasurement& frame) { return frame.repetitions == 1; });
    };
    if (!std::ranges::all_of(result.runs, once)) return {};
    return result.runs.front().frames.size() == 1
               ? "One repetition of one view: no interval."
               : "One repetition: the intervals are of the scatter between the views; no view has one of its own.";
}

/// What is lost: without pixels that the raster's snapping explains.
uint64_t lostPixels(const Losses& losses) { return losses.beyondSnapping ? losses.missedBeyondSnapping : losses.missedPixels; }

/// The pixels that differ and are no loss; empty: there are none.
std::string withinSnapping(const RunMeasurement& run) {
    const std::optional<Losses> losses = run.losses();
    const uint64_t pixels = losses ? losses->missedPixels - lostPixels(*losses) : 0;
    if (pixels == 0) return {};
    return pixels == 1 ? "1 pixel differs within the raster's snapping, and is not lost"
                       : fmt::format("{} pixels differ within the raster's snapping, and are not lost", pixels);
}

constexpr const char* kSameSides = "x same sides [95 %]";

/// "58 % [55,61]", of the time that any culling could save; "-" where that is not known.
std::string headroomText(const std::optional<RatioEstimate>& share) {
    if (!share) return "-";
    const auto percent = [](double value) { return fmt::format("{:.0f}", 100.0 * value); };
    if (!share->hasInterval) return percent(share->ratio) + " %";
    return fmt::format("{} % [{},{}]", percent(share->ratio), percent(share->ci95[0]), percent(share->ci95[1]));
}

std::string ratioTitle(BaselineRole role) { return fmt::format("x {} [95 %]", baselineOf(role).id); }

/// "0.012 [0.010,0.020]", or "-" where there is nothing to count.
std::string fieldText(const RunMeasurement& run, size_t place) {
    const std::optional<RatioEstimate>& estimate = run.summary.field[place];
    const FieldFigure& figure = fieldFigures()[place];
    if (!estimate) return "-";
    const auto number = [&](double value) { return fmt::format("{:.{}f}", value * figure.scale, figure.decimals); };
    if (estimate->ratio == 0.0) return "0";
    if (!estimate->hasInterval) return number(estimate->ratio);
    return fmt::format("{} [{},{}]", number(estimate->ratio), number(estimate->ci95[0]), number(estimate->ci95[1]));
}

/// The errors in the field's terms: a row a figure, a column a strategy.
void printFieldFigures(const MeasureResult& result, FILE* out) {
    std::vector<const RunMeasurement*> runs;
    for (const RunMeasurement& run : result.runs)
        if (!run.summary.field.empty()) runs.push_back(&run);
    if (runs.empty()) return;
    std::string line = fmt::format("{:<40}", "errors [95 %]");
    for (const RunMeasurement* run : runs) line += fmt::format(" {:>26}", strategyLabel(run->strategy));
    say(out, "{}\n", line);
    for (size_t place = 0; place < fieldFigures().size(); ++place) {
        line = fmt::format("{:<40}", fieldFigures()[place].title);
        for (const RunMeasurement* run : runs) line += fmt::format(" {:>26}", fieldText(*run, place));
        say(out, "{}\n", line);
    }
    line = fmt::format("{:<40}", "views that lose something");
    for (const RunMeasurement* run : runs) {
        const size_t views = run->frames.size(), losing = framesWithLoss(run->frames);
        line += fmt::format(" {:>26}", losing == 0 ? noLossIn(views).english() : fmt::format("{} of {}", losing, views));
    }
    say(out, "{}\n", line);
}

void printTable(const MeasureResult& result, FILE* out) {
    const Scene& scene = *result.request.scene;
    say(out, "{}: {} triangles in {} objects, {} of {} poses of {}, {}x{}\n", scene.name(), scene.triangleCount(),
        scene.instances().size(), result.runs.front().frames.size(), result.request.path.poses.size(), result.request.path.name,
        result.request.size.width, result.request.size.height);
    say(out, "{}{}\n", result.gl.renderer, result.gl.software ? " (software OpenGL: times are not a GPU's)" : "");
    say(out, "{:<24} {:<12} {:>9} {:>9} {:>19} {:>15} {:>17} {:>17} {:>8} {:>8} {:>10} {:>9}\n", "strategy", "promise", "ms",
        "fps", kSameSides, "of the headroom", ratioTitle(BaselineRole::Triangles), ratioTitle(BaselineRole::FrontFaces), "culled",
        "cull ms", "missed px", "hole px");
    const auto row = [&](const RunMeasurement& run) {
        if (run.frames.empty()) return;
        const Summary& s = run.summary;
        const std::optional<Losses> losses = run.losses();
        say(out, "{:<24} {:<12} {:>9.3f} {:>9.2f} {:>19} {:>15} {:>17} {:>17} {:>6.1f} % {:>8.3f} {:>10} {:>9}\n",
            strategyLabel(run.strategy), promiseId(run.promise), s.frameMillisecondsMedian, s.fpsOverall,
            ratioText(s.ratioToOwnRule), headroomText(s.headroomShare), ratioText(s.ratioToTriangles),
            ratioText(s.ratioToFrontFaces), s.culledFraction * 100, s.cullShare * 1000.0 / s.fpsOverall,
            losses ? std::to_string(lostPixels(*losses)) : "-", losses ? std::to_string(losses->largestHolePixels) : "-");
    };
    std::ranges::for_each(result.runs, row);
    const bool limitToo =
        result.limit && std::ranges::find(result.runs, result.limit->strategy, &RunMeasurement::strategy) == result.runs.end();
    if (limitToo) row(*result.limit);
    printFieldFigures(result, out);
    for (const RunMeasurement& run : result.runs)
        if (const std::string snapped = withinSnapping(run); !snapped.empty())
            say(out, "{}: {}\n", strategyLabel(run.strategy), snapped);
    for (const RunMeasurement& run : result.runs)
        if (const auto reason =
                unserved(findStrategy(run.strategy.id).info, run.strategy.parameters, result.request.path.camera(0)))
            say(out, "{}\n", reason->english());
    if (const std::string note = withoutRepetitions(result); !note.empty()) say(out, "{}\n", note);
    for (const RunMeasurement& run : result.runs)
        if (const std::string used = usedParts(run); !used.empty()) say(out, "{} used {}\n", strategyLabel(run.strategy), used);
    for (const RunMeasurement& run : result.runs)
        if (const std::string culled = culledByCause(run, scene); !culled.empty())
            say(out, "{} culled by cause: {}\n", strategyLabel(run.strategy), culled);
}

/// All but the scene and what depends on it.
MeasureRequest requestOf(const MeasureOptions& options) {
    MeasureRequest request;
    request.strategies = strategiesOf(options.strategies, options.parameters);
    request.size = options.run.viewport();
    request.windows = options.run.windows;
    request.differentViews = options.run.windowViews == "different";
    request.upload = options.run.uploadBy();
    request.timing.fixedRepetitions = options.run.repeat;
    request.accuracy = !options.noAccuracy;
    request.limitToo = !options.noLimit && !options.noAccuracy;
    return request;
}

/// The files are written first, so that a reader of the table who has read enough costs no file. Every file is tried, so that one
/// that cannot be written costs neither the table nor the other file.
void report(const MeasureOptions& options, const MeasureResult& result) {
    std::optional<Error> failure;
    for (const auto& [path, text] : {std::pair(options.json, &resultJson), std::pair(options.csv, &resultCsv)}) try {
            if (!path.empty()) writeText(path, text(result));
        } catch (const Error& error) {
            failure = error;
        }
    // Where standard output carries data, the table goes to standard error.
    printTable(result, options.json == "-" || options.csv == "-" ? stderr : stdout);
    if (failure) throw *failure;
}

void checkOutputs(const MeasureOptions& options) {
    if (options.json == "-" && options.csv == "-")
        throwUsage(CULLSCOPE_TR("--json and --csv cannot both go to standard output: name a file for one of them."));
    checkOutputPlaces({options.json, options.csv}, options.store);
}

int statusOf(const MeasureResult& result) {
    int status = 0;
    for (const RunMeasurement& run : result.runs)
        if (run.promiseBroken()) {
            say(stderr, "cullbench: {} promises to be {} and lost pixels\n", run.strategy.id, promiseId(run.promise));
            status = 1;
        }
    return result.interrupted ? static_cast<int>(ErrorKind::Interrupted) : status;
}

void run(const MeasureOptions& options, Context& context) {
    // What can be wrong with the words is said before a long load.
    MeasureRequest request = requestOf(options);
    checkOutputs(options);
    const std::unique_ptr<store::Recorder> recorder = recorderOf(options.store, "measure", context);
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    const HeadlessContext gl;
    for (const StrategyRequest& strategy : request.strategies) requireAvailable(strategy, gl.info());
    request.scene = opened.scene;
    request.path = options.run.viewsOf(*opened.scene, {nullptr, context.stop});
    const MeasureResult result = store::measureInto(recorder.get(), request, terminalProgress(context));
    clearProgress();
    if (result.interrupted && result.runs.front().frames.empty()) throwNothingMeasured();
    context.exitStatus = statusOf(result);
    report(options, result);
    requireRecorded(recorder);
}

}  // namespace

void addMeasureCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("measure", "Times strategies side by side and counts what each one lost");
    auto options = std::make_shared<MeasureOptions>();
    addSceneOptions(*command, options->scene);
    addStrategyOptions(*command, options->strategies, options->parameters);
    addRunOptions(*command, options->run);
    addLimitOption(*command, options->noLimit);
    command->add_flag("--no-accuracy", options->noAccuracy, "time only, without the limit of culling");
    command->add_option("--json", options->json, "result file; - is standard output");
    command->add_option("--csv", options->csv, "result file with one row a frame; - is standard output");
    addStoreOption(*command, options->store);
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
