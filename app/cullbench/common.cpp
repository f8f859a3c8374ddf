#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <cmath>
#include <set>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/scene/camera.h"
#include "core/scene/hidden.h"
#include "core/scene/viewport_text.h"
#include "core/visibility/strategy_request.h"

namespace cullscope::cullbench {
namespace {

constexpr int kBarWidth = 30;

/// As it stands, with carriage returns. What the terminal does not take is lost.
void putOnTerminal(const std::string& text) {
    std::fputs(text.c_str(), stderr);
    std::fflush(stderr);
}

void drawBar(double share, std::string_view stage) {
    const int filled = static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * kBarWidth));
    putOnTerminal(fmt::format("\r[{:#<{}}{:.<{}}] {:3.0f} % {:<24.24}", "", filled, "", kBarWidth - filled, share * 100, stage));
}

bool parse(std::string_view text, double& number) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(number);
}

/// A check that `holds(number)` says; `words` say what is asked for.
template <typename Holds>
CLI::Validator numberCheck(const std::string& words, Holds holds) {
    return {[words, holds](const std::string& text) {
                double number = 0.0;
                return parse(text, number) && holds(number) ? std::string() : fmt::format("{} is not {}", text, words);
            },
            "NUMBER"};
}

bool declares(const StrategyRequest& request, const std::string& key) {
    return std::any_of(request.parameters.declarations().begin(), request.parameters.declarations().end(),
                       [&](const ParameterDeclaration& declaration) { return declaration.key == key; });
}

/// Which request got which key.
using GivenParameters = std::set<std::pair<const StrategyRequest*, std::string>>;

/// Applies `A.key=value` to every strategy A, and `key=value` to every strategy that has the key.
void apply(const std::string& text, std::vector<StrategyRequest>& requests, GivenParameters& given) {
    const auto [name, value] = parameterAndValue(text);
    const size_t dot = name.find('.');
    const std::string id = dot == std::string::npos ? "" : name.substr(0, dot);
    const std::string key = dot == std::string::npos ? name : name.substr(dot + 1);
    bool used = false;
    for (StrategyRequest& request : requests) {
        if (id.empty() ? !declares(request, key) : request.id != id) continue;
        request.parameters.setFromText(key, value);
        if (!given.emplace(&request, key).second) throwUsage(CULLSCOPE_TR("%1: %2 is given twice."), {"-p " + text, key});
        used = true;
    }
    if (used) return;
    if (!id.empty()) throwUsage(CULLSCOPE_TR("-p %1: the strategy \"%2\" is not among those of -s."), {text, id});
    // With one strategy, its own error lists its parameters.
    if (requests.size() == 1) requests.front().parameters.setFromText(key, value);
    throwUsage(CULLSCOPE_TR("-p %1: none of the strategies has a parameter \"%2\"."), {text, key});
}

}  // namespace

Progress terminalProgress(const Context& context) {
    Progress progress{nullptr, context.stop};
    if (isatty(STDERR_FILENO) != 0) progress.report = drawBar;
    return progress;
}

void clearProgress() {
    if (isatty(STDERR_FILENO) != 0) putOnTerminal(fmt::format("\r{:{}}\r", "", kBarWidth + 36));
}

void addSceneOptions(CLI::App& command, SceneChoice& choice) {
    command.add_option("SCENE", choice.specification, "mesh file or generator")->required();
    command.add_option("--hide", choice.hide, "objects to leave out: numbers from 0 and ranges, as in 3,7-9");
}

OpenedScene openSceneForCommand(const SceneChoice& choice, const Context& context) {
    OpenedScene opened = openScene(choice.specification, context.sceneOptions, terminalProgress(context));
    clearProgress();
    if (opened.report)
        for (const Message& sentence : opened.report->sentences())
            say(stderr, "cullbench: {}: {}\n", choice.specification, sentence.english());
    opened.scene = withoutInstances(opened.scene, hiddenFromText(choice.hide, opened.scene->instances().size()));
    return opened;
}

CLI::Validator positiveNumber() {
    return numberCheck("a number above 0", [](double number) { return number > 0.0; });
}

CLI::Validator numberBetween(double least, double most) {
    return numberCheck(fmt::format("a number from {} to {}", least, most),
                       [=](double number) { return number >= least && number <= most; });
}

CLI::Validator countFromZero() {
    return numberCheck("a whole number from 0", [](double number) { return number >= 0.0 && number == std::floor(number); });
}

Viewport sizeFromText(const std::string& text, const std::string& option) {
    if (const std::optional<Viewport> size = viewportFromText(text)) return *size;
    throwUsage(CULLSCOPE_TR("%1 %2 is not WIDTHxHEIGHT with 1 to 16384 pixels, as in 640x480."), {option, text});
}

Vec3 vectorFromText(const std::string& option, const std::string& text) {
    Vec3 vector(0.0);
    size_t from = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const size_t comma = axis < 2 ? text.find(',', from) : text.size();
        if (comma == std::string::npos || !parse(std::string_view(text).substr(from, comma - from), vector[axis]))
            throwUsage(CULLSCOPE_TR("%1 %2 is not three numbers x,y,z."), {option, text});
        from = comma + 1;
    }
    return vector;
}

std::vector<StrategyRequest> strategiesOf(const std::vector<std::string>& texts, const std::vector<std::string>& parameters) {
    std::vector<StrategyRequest> requests = strategiesFromText(texts);
    GivenParameters given;
    for (const std::string& parameter : parameters) apply(parameter, requests, given);
    return requests;
}

CameraPath RunOptions::viewsOf(const Scene& scene, const Progress& progress) const {
    CameraPath views = cameraPath(pathFor(scene), scene, progress);
    if (fovx > 0.0) views.fovy = verticalField(Angle::fromDegrees(fovx), viewport());
    projection.applyTo(views);
    return views;
}

Camera ProjectionOptions::of(const Camera& camera) const {
    Camera result = camera;
    if (!projection.empty())
        result = projectionFromId(projection) == ProjectionKind::Parallel ? inParallel(camera) : inPerspective(camera);
    if (height > 0.0 && result.projection != ProjectionKind::Parallel)
        throwUsage(CULLSCOPE_TR("The height is that of a parallel view: say --projection parallel, too."));
    if (height > 0.0) result.height = height;
    return result;
}

void ProjectionOptions::applyTo(CameraPath& path) const {
    if (!given() || path.poses.empty()) return;
    const Camera first = of(path.camera(0));
    // In perspective each pose has an eye of its own.
    if (path.projection == ProjectionKind::Parallel && first.projection == ProjectionKind::Perspective)
        for (size_t pose = 0; pose < path.poses.size(); ++pose) path.poses[pose].eye = inPerspective(path.camera(pose)).eye;
    path.projection = first.projection;
    path.height = first.height;
}

void addProjectionOptions(CLI::App& command, ProjectionOptions& options, const std::string& prefix) {
    command
        .add_option(prefix + "projection", options.projection,
                    "perspective or parallel: lines of sight that run along the view direction")
        ->check(CLI::IsMember({projectionId(ProjectionKind::Perspective), projectionId(ProjectionKind::Parallel)}));
    command
        .add_option(prefix + "height", options.height,
                    "height of a parallel view in scene units (default: what the camera shows at its target)")
        ->check(positiveNumber());
}

CLI::Option* addFieldOption(CLI::App& command, double& fovx) {
    return command.add_option("--fovx", fovx, "horizontal field of view in degrees (default: as the path or --fovy says)")
        ->check(numberBetween(0.001, 179.0));
}

void addLimitOption(CLI::App& command, bool& noLimit) {
    command.add_flag("--no-limit", noLimit, "without the limit of culling, and so without shares of the headroom");
}

void addStoreOption(CLI::App& command, std::string& store) {
    command.add_option("--store", store, "result store (SQLite) that every pose goes into once it is measured");
}

std::unique_ptr<store::Recorder> recorderOf(const std::string& store, const std::string& experiment, const Context& context) {
    if (store.empty()) return nullptr;
    return std::make_unique<store::Recorder>(store, store::Origin{experiment, context.command});
}

void requireRecorded(const std::unique_ptr<store::Recorder>& recorder) {
    if (recorder && recorder->failure()) throw *recorder->failure();
}

void addReportStoreOption(CLI::App& command, std::string& store) {
    command.add_option("--store", store, "result store (SQLite) that the report goes into");
}

ReportKeeper::ReportKeeper(const std::string& store, const Context& context) : m_context(context) {
    if (!store.empty()) m_store.emplace(store);
}

void ReportKeeper::keep(store::Report report) const {
    if (!m_store || m_context.exitStatus == static_cast<int>(ErrorKind::Interrupted)) return;
    report.command = m_context.command;
    (void)m_store->add(report);
}

void addViewOptions(CLI::App& command, RunOptions& options) {
    command.add_option(
        "--path", options.path,
        "camera path: file or built-in name (default: tour:16 where one stands in the scene, else fibonacci:16 for one "
        "object, walk:16 for many)");
    addFieldOption(command, options.fovx);
    addProjectionOptions(command, options.projection);
    command.add_option("--size", options.size, "WIDTHxHEIGHT in pixels")->capture_default_str();
}

void addRunOptions(CLI::App& command, RunOptions& options) {
    addViewOptions(command, options);
    command.add_option("--windows", options.windows, "pictures a frame: 1, 4 or 8")
        ->check(CLI::IsMember({1, 4, 8}))
        ->capture_default_str();
    command.add_option("--window-views", options.windowViews, "of several windows: one view, or different ones of the path")
        ->check(CLI::IsMember({"one", "different"}))
        ->capture_default_str();
    command.add_option("--upload", options.upload, "vbo or vertex-array")
        ->check(CLI::IsMember({"vbo", "vertex-array"}))
        ->capture_default_str();
    command.add_option("--repeat", options.repeat, "repetitions of each frame (default: until the median is steady)")
        ->check(CLI::Range(1, 100000));
}

void addStrategyOptions(CLI::App& command, std::vector<std::string>& strategies, std::vector<std::string>& parameters) {
    command.add_option("-s,--strategy", strategies, "strategies: A,B or A:key=value,key=value,B")
        ->required()
        ->allow_extra_args(false);
    command.add_option("-p,--parameter", parameters, "parameter: A.key=value, or key=value for every strategy that has it")
        ->allow_extra_args(false);
}

void requireAvailable(const StrategyRequest& request, const GlInfo& gl) {
    if (const std::optional<Message> why = unavailable(findStrategy(request.id).info, gl)) throw Error(ErrorKind::OpenGl, *why);
}

void throwNothingMeasured() {
    throw Error(ErrorKind::Interrupted,
                {CULLSCOPE_TR("Stopped before anything was measured: files with older results stay as they were."), {}});
}

void writeText(const std::string& path, const std::string& text) {
    writeFileAtomically(path, [&](std::ostream& out) { out << text; });
}

}  // namespace cullscope::cullbench
