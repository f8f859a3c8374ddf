#include <fmt/format.h>

#include <charconv>

#include "app/cullbench/commands.h"
#include "core/base/error.h"
#include "core/gpu/context.h"
#include "core/measure/frame.h"
#include "core/measure/picture_file.h"

namespace cullscope::cullbench {
namespace {

struct Options {
    std::string scene, strategy, output, path, eye, target, up;
    std::vector<std::string> parameters;
    std::string size = "640x480";
    std::string background, surface;
    double fovy = 45.0, nearDistance = 0.0, farDistance = 0.0;
    int64_t pose = 0;
};

Camera cameraOf(const Options& options, const Scene& scene, const Viewport& size) {
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
    if (options.path.empty()) {
        camera.fovy = Angle::fromDegrees(options.fovy);
        fitDepthRange(camera, scene);
    }
    if (options.nearDistance > 0) camera.nearDistance = options.nearDistance;
    if (options.farDistance > 0) camera.farDistance = options.farDistance;
    return camera;
}

/// "RRGGBB", as in web pages; nothing given keeps the fallback.
Vec3f colourFromText(const std::string& option, const std::string& text, const Vec3f& fallback) {
    if (text.empty()) return fallback;
    unsigned value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (text.size() != 6 || error != std::errc() || end != text.data() + text.size())
        throwUsage(CULLSCOPE_TR("%1 %2 is not a colour of six hexadecimal digits, as in FFFFFF."), {option, text});
    return Vec3f(float(value >> 16), float(value >> 8 & 255), float(value & 255)) / 255.0f;
}

std::string text(const Vec3& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

/// Everything that repeats the picture.
std::vector<std::pair<std::string, std::string>> metadata(const Options& options, const StrategyRequest& strategy,
                                                          const Camera& camera) {
    std::vector<std::pair<std::string, std::string>> pairs{{"cullscope:scene", options.scene},
                                                           {"cullscope:strategy", strategy.id},
                                                           {"cullscope:eye", text(camera.eye)},
                                                           {"cullscope:target", text(camera.target)},
                                                           {"cullscope:up", text(camera.up)},
                                                           {"cullscope:fovy_deg", fmt::format("{}", camera.fovy.degrees())},
                                                           {"cullscope:near", fmt::format("{}", camera.nearDistance)},
                                                           {"cullscope:far", fmt::format("{}", camera.farDistance)}};
    for (const ParameterDeclaration& declaration : strategy.parameters.declarations())
        pairs.emplace_back("cullscope:parameter:" + declaration.key, toText(strategy.parameters.value(declaration.key)));
    return pairs;
}

void run(const Options& options, const Context& context) {
    const Viewport size = sizeFromText(options.size);
    const std::vector<StrategyRequest> requests = strategiesFromText({options.strategy}, options.parameters);
    DrawStyle style;
    style.background = colourFromText("--background", options.background, style.background);
    style.surface = colourFromText("--surface", options.surface, style.surface);
    const OpenedScene opened = openSceneForCommand(options.scene, context);
    const Camera camera = cameraOf(options, *opened.scene, size);
    const View view(camera, size);
    const HeadlessContext gl;
    Renderer renderer;
    const SceneBuffers buffers(opened.scene, Upload::Vbo);
    Framebuffer target(size);
    const StrategyPointer strategy = makeStrategy(requests.front().id, requests.front().parameters);
    strategy->build(*opened.scene, terminalProgress(context));
    clearProgress();
    terminalProgress(context).check();
    const FrameResult frame = renderFrame(renderer, buffers, *strategy, view, target, style);
    writePicture(options.output, {size, target.readColour(), metadata(options, requests.front(), camera)});
    // Where the picture went to standard output, the words go beside it.
    fmt::print(options.output == "-" ? stderr : stdout, "{}: {} of {} triangles submitted; {} on {}\n", options.output,
               frame.verdict.consideredTriangles, opened.scene->triangleCount(), gl.info().renderer, gl.platform());
}

}  // namespace

void addRenderCommand(CLI::App& app, Context& context) {
    CLI::App* command = app.add_subcommand("render", "Draws one picture of a scene with a strategy");
    auto options = std::make_shared<Options>();
    command->add_option("SCENE", options->scene, "mesh file or generator")->required();
    command->add_option("-s,--strategy", options->strategy, "strategy")->required();
    command->add_option("-p,--parameter", options->parameters, "parameter of the strategy: key=value")->allow_extra_args(false);
    auto* eye = command->add_option("--eye", options->eye, "eye, x,y,z (default: all of the scene in view)");
    command->add_option("--target", options->target, "what is looked at, x,y,z");
    command->add_option("--up", options->up, "up, x,y,z");
    auto* fovy = command->add_option("--fovy", options->fovy, "vertical field of view in degrees")->capture_default_str();
    command->add_option("--near", options->nearDistance, "near distance (default: from the eye's place)")
        ->check(CLI::PositiveNumber);
    command->add_option("--far", options->farDistance, "far distance (default: from the eye's place)")
        ->check(CLI::PositiveNumber);
    auto* path =
        command->add_option("--path", options->path, "camera path: file or built-in name")->excludes(eye)->excludes(fovy);
    command->add_option("--pose", options->pose, "pose of the path, from 0")->needs(path)->check(CLI::NonNegativeNumber);
    command->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
    command->add_option("--background", options->background, "colour behind the scene, RRGGBB");
    command->add_option("--surface", options->surface, "colour of the surfaces, RRGGBB");
    command->add_option("-o,--output", options->output, "picture file: .png, .jpg, .tif, .exr; - is standard output (PNG)")
        ->required();
    command->callback([options, &context] { run(*options, context); });
}

}  // namespace cullscope::cullbench
