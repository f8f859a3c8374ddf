#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "app/cullbench/commands.h"
#include "app/cullbench/output.h"
#include "app/cullbench/overlays.h"
#include "core/base/error.h"
#include "core/frame/decided_ahead.h"
#include "core/frame/entry_words.h"
#include "core/frame/submitted.h"
#include "core/gpu/colour.h"
#include "core/gpu/gpu_frame.h"
#include "core/image/cell_map_picture.h"
#include "core/image/picture_file.h"
#include "core/image/picture_metadata.h"
#include "core/measure/accuracy.h"
#include "core/visibility/subject_shape.h"

namespace cullscope::cullbench {
namespace {

constexpr double kUsualField = 45.0;  // degrees

struct RenderOptions {
    SceneChoice scene;
    std::string strategy, output, path, eye, target, up;
    std::vector<std::string> parameters;
    std::string size = "640x480";
    std::string background, surface;
    std::optional<double> fovy;  ///< degrees; none: the scene's own, or the usual one
    double fovx = 0.0, nearDistance = 0.0, farDistance = 0.0;
    ProjectionOptions projection;
    int64_t pose = 0;
    std::optional<int64_t> step;
    bool steps = false;
    OverlayOptions overlays;
};

Camera cameraOf(const RenderOptions& options, const Scene& scene, const Viewport& size) {
    Camera camera = overviewCamera(scene, double(size.width) / size.height);
    if (!options.path.empty()) {
        const CameraPath path = cameraPath(options.path, scene);
        if (static_cast<size_t>(options.pose) >= path.poses.size())
            throwUsage(CULLSCOPE_TR("--pose %1: the path %2 has %3 poses, counted from 0."),
                       {std::to_string(options.pose), options.path, std::to_string(path.poses.size())});
        camera = path.camera(static_cast<size_t>(options.pose));
    }
    if (!options.eye.empty()) camera.eye = vectorFromText("--eye", options.eye);
    if (!options.target.empty()) camera.target = vectorFromText("--target", options.target);
    if (!options.up.empty()) camera.up = vectorFromText("--up", options.up);
    // A scene of the gallery is seen by the lens of its case, unless another one is asked for.
    const bool ofCase = !scene.remarks().cameras.empty() && options.eye.empty() && !options.fovy;
    if (options.path.empty() && !ofCase) camera.fovy = Angle::fromDegrees(options.fovy.value_or(kUsualField));
    if (options.fovx > 0.0) camera.fovy = verticalField(Angle::fromDegrees(options.fovx), size);
    camera = options.projection.of(camera);
    if (options.path.empty() && !ofCase) fitDepthRange(camera, scene);
    if (options.nearDistance > 0) camera.nearDistance = options.nearDistance;
    if (options.farDistance > 0) camera.farDistance = options.farDistance;
    return camera;
}

/// A colour "RRGGBB", as in web pages; the fallback for an empty text.
Vec3f colourFromText(const std::string& option, const std::string& text, const Vec3f& fallback) {
    if (text.empty()) return fallback;
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (text.size() != 6 || error != std::errc() || end != text.data() + text.size())
        throwUsage(CULLSCOPE_TR("%1 %2 is not a colour of six hexadecimal digits, as in FFFFFF."), {option, text});
    return colourFromHexadecimal(value);
}

/// The content of the picture, for its metadata.
PictureSubject subjectOf(const RenderOptions& options, const StrategyRequest& strategy, const OverlayChoice& choice,
                         const View& viewing, const DrawStyle& style, const FrameLog& log, const Submitted& submitted) {
    PictureSubject subject;
    subject.scene = options.scene.specification;
    subject.hidden = options.scene.hide;
    subject.strategy = strategy.id;
    subject.parameters = strategy.parameters;
    subject.culling = log.camera;
    subject.viewing = viewing.camera();
    subject.cullingSize = log.size;
    subject.size = viewing.viewport();
    subject.look = choice.look;
    subject.style = style;
    subject.picture = choice.picture;
    subject.pictureColouring = choice.colouring;
    subject.submittedTriangles = submitted.triangles;
    return subject;
}

/// One line with the number of triangles in each state that occurs.
std::string described(const TriangleStates& states) {
    std::string text;
    for (size_t i = 0; i < kTriangleStateCount; ++i)
        if (states.counts[i] > 0)
            text += fmt::format("{}{} {}", text.empty() ? "" : ", ", states.counts[i],
                                triangleStateName(static_cast<TriangleState>(i)));
    return text;
}

/// A picture and the figures printed about it.
struct Drawn {
    TriangleStates states;  ///< empty without `verdicts`
    std::vector<uint8_t> rgba;
    std::string line;  ///< what the strategy says of the frame (Strategy::frameLine)
};

/// Replays a frame, with its overlays.
Drawn drawPicture(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, const FrameLog& log,
                  const View& viewing, const OverlayChoice& choice, const DrawStyle& style) {
    Drawn drawn;
    requireOverlays(choice, strategy, log);
    if (choice.needsDecisions()) drawn.line = strategy.frameLine(log);
    if (!choice.picture.empty()) {
        const CellMapPointer map = strategy.directionMap(choice.picture, log);
        if (!map) throwUsage(CULLSCOPE_TR("--overlay %1: this frame decided nothing that could be shown."), {choice.picture});
        drawn.rgba = cellMapPicture(*map, choice.colouring, viewing.viewport(), style);
        return drawn;
    }
    Framebuffer target(viewing.viewport());
    const bool verdicts = choice.look.has(Show::Kind::Verdicts);
    if (verdicts) drawn.states = judgedStates(renderer, buffers, log, strategy.referenceFacing());
    drawViewPicture(renderer, buffers, strategy, log, viewing, verdicts ? &drawn.states : nullptr, choice.look, style, target);
    drawn.rgba = target.readColour();
    return drawn;
}

/// Adds depth and triangle numbers of a frame, without overlays.
void addDepth(Renderer& renderer, Picture& picture, const SceneBuffers& buffers, const View& viewing, const FrameLog& log) {
    Renderer::ItemBuffer items = renderer.drawItemBuffer(buffers, viewing, log, {0, 0, viewing.viewport()});
    picture.depth = forwardDistances(items.depth, viewing);
    picture.triangle = std::move(items.triangle);
}

/// The frame that every picture of the command replays.
FrameLog frameOf(Renderer& renderer, const SceneBuffers& buffers, const BuiltStrategy& strategy, const View& culling,
                 bool recording, const std::stop_token& stop) {
    GpuFrame frame(renderer, buffers, culling, recording);
    frame.stopBy(stop);
    strategy.draw(frame, *strategy.begin());
    return frame.take();
}

/// The entries of a frame's log: number, line of the listing, sentence. Before them, as the desktop's bar says it, what the
/// strategy does not say one by one.
void printSteps(std::FILE* words, const BuiltStrategy& strategy, const FrameLog& log) {
    const FrameEntries entries(log);
    const StructureSnapshot snapshot = strategy.snapshot(log);
    if (!log.coarser.empty()) say(words, "The method itself records this frame coarser:\n");
    for (const Message& coarser : log.coarser) say(words, "  {}\n", coarser.english());
    for (size_t i = 0; i < entries.size(); ++i) {
        const FrameEntry entry = entries.at(i);
        const bool lined = entry.decision != nullptr && entry.decision->line > 0;
        say(words, "{:>8}  {:<7}  {}\n", i + 1, lined ? fmt::format("line {}", entry.decision->line) : "",
            entryLine(strategy.scene(), entry, entryNames(snapshot, entry)));
    }
}

/// The frame's log up to the chosen step.
FrameLog upToStep(const RenderOptions& options, const FrameLog& log) {
    if (!options.step) return log;
    if (*options.step < 0 || uint64_t(*options.step) > log.entries())
        throwUsage(CULLSCOPE_TR("--step %1: this frame has the steps 0 to %2."),
                   {std::to_string(*options.step), std::to_string(log.entries())});
    return replayUpTo(log, size_t(*options.step));
}

void run(const RenderOptions& options, const Context& context) {
    const Viewport size = sizeFromText(options.size);
    const StrategyRequest request = strategiesOf({options.strategy}, options.parameters).front();
    const OverlayChoice choice = overlaysOf(options.overlays);
    const std::optional<BelowChoice> below = belowOf(options.overlays, choice);
    DrawStyle style;
    style.background = colourFromText("--background", options.background, style.background);
    style.surface = colourFromText("--surface", options.surface, style.surface);
    requirePictureFormat(options.output);
    checkOutputPlaces({options.output});
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    const Camera camera = cameraOf(options, *opened.scene, size);
    const Camera viewing = viewingCamera(options.overlays, camera, *opened.scene);
    const View view(camera, cullingSize(options.overlays, size));
    View viewingView(viewing, size);
    const std::optional<Section> section = sectionOf(options.overlays);
    const auto cut = [&](View& shown) {
        if (section) shown.cutBy(sectionPlane(*section, opened.scene->bounds(), camera));
    };
    cut(viewingView);
    const HeadlessContext gl;
    requireAvailable(request, gl.info());
    StructureStore structures;
    const BuiltStrategyPointer strategy =
        buildStrategy(request.id, request.parameters, opened.scene, structures, terminalProgress(context));
    clearProgress();
    terminalProgress(context).check();
    Renderer renderer;
    const SceneBuffers buffers(opened.scene, Upload::Vbo);
    const bool recording =
        choice.needsDecisions() || (below && below->overlays.needsDecisions()) || options.step || options.steps;
    const FrameLog whole = frameOf(renderer, buffers, *strategy, view, recording, terminalProgress(context).stop);
    const FrameLog log = upToStep(options, whole);
    const auto drawnBy = [&](const View& viewed, const OverlayChoice& chosen) {
        Drawn picture = drawPicture(renderer, buffers, *strategy, log, viewed, chosen, style);
        if (!options.step || chosen.replacesScene() || chosen.look.has(Show::Kind::Verdicts)) return picture;
        const DrawList ahead = strategy->decidedAhead(whole, size_t(*options.step));
        if (!ahead.ranges.empty()) drawAhead(renderer, buffers, viewed, ahead, style, picture.rgba);
        return picture;
    };
    Drawn drawn = drawnBy(viewingView, choice);
    if (below) {
        View side(below->behind ? cameraBehind(viewing, *opened.scene) : viewing, size);
        cut(side);
        // Rows count from the bottom, so the second picture's rows come first.
        Drawn second = drawnBy(side, below->overlays);
        drawn.rgba.insert(drawn.rgba.begin(), second.rgba.begin(), second.rgba.end());
        if (drawn.line.empty()) drawn.line = std::move(second.line);
    }
    const auto& [states, rgba, line] = drawn;
    const Viewport pictureSize{size.width, below ? 2 * size.height : size.height};
    const Submitted submitted = submittedBy(*opened.scene, log);
    PictureSubject subject = subjectOf(options, request, choice, viewingView, style, log, submitted);
    subject.section = section;
    PictureMetadata metadata = subjectMetadata(subject);
    std::ranges::move(programMetadata(gl.info().renderer), std::back_inserter(metadata));
    Picture picture{pictureSize, rgba, std::move(metadata)};
    if (keepsDepth(options.output) && !choice.replacesScene() && !below) addDepth(renderer, picture, buffers, viewingView, log);
    writePicture(options.output, picture);
    // Where the picture goes to standard output, the text goes to standard error.
    std::FILE* words = options.output == "-" ? stderr : stdout;
    const std::string parts = submitted.fragments > 0 ? fmt::format(" in {} fragments", submitted.fragments) : "";
    say(words, "{}: {} of {} triangles submitted{}; {} on {}\n", options.output, submitted.triangles,
        opened.scene->triangleCount(), parts, gl.info().renderer, gl.platform());
    if (states.againstTruth) say(words, "{}: {}\n", options.output, described(states));
    if (options.steps) printSteps(words, *strategy, log);
    if (!line.empty()) say(words, "{}: {}\n", options.output, line);
}

}  // namespace

void addRenderCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("render", "Draws one picture of a scene with a strategy");
    auto options = std::make_shared<RenderOptions>();
    addSceneOptions(*command, options->scene);
    command->add_option("-s,--strategy", options->strategy, "strategy")->required();
    command->add_option("-p,--parameter", options->parameters, "parameter of the strategy: key=value")->allow_extra_args(false);
    auto* eye = command->add_option("--eye", options->eye, "eye, x,y,z (default: all of the scene in view)");
    command->add_option("--target", options->target, "what is looked at, x,y,z");
    command->add_option("--up", options->up, "up, x,y,z");
    auto* fovy = command->add_option("--fovy", options->fovy,
                                     "vertical field of view in degrees (default: 45; of a case of the gallery its own)");
    addFieldOption(*command, options->fovx)->excludes(fovy);
    addProjectionOptions(*command, options->projection);
    command->add_option("--near", options->nearDistance, "near distance (default: from the eye's place)")
        ->check(positiveNumber());
    command->add_option("--far", options->farDistance, "far distance (default: from the eye's place)")->check(positiveNumber());
    auto* path =
        command->add_option("--path", options->path, "camera path: file or built-in name")->excludes(eye)->excludes(fovy);
    command->add_option("--pose", options->pose, "pose of the path, from 0")->needs(path)->check(countFromZero());
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--background", options->background, "colour behind the scene, RRGGBB");
    command->add_option("--surface", options->surface, "colour of the surfaces, RRGGBB");
    command->add_option("--step", options->step, "draw only so many of the frame's decisions and commands, from 0");
    command->add_flag("--steps", options->steps, "print the frame's decisions and commands, one a line");
    addOverlayOptions(*command, options->overlays);
    command->add_option("-o,--output", options->output, "picture file: .png, .jpg, .tif, .exr; - is standard output (PNG)")
        ->required();
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
